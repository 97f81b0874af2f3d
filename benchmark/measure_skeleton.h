// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_MEASURE_SKELETON_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_MEASURE_SKELETON_H

#include "Measurements.h"
#include "methods/Method.h"

#include <vector>

/// Fills in what can be measured with nothing but the cloud.
void measure_skeleton(Measurements& row, const Skeleton& skeleton,
                      const std::vector<Point>& points);

/// Fills in how far the skeleton is from that of the clean cloud.
void measure_stability(Measurements& row, const Skeleton& skeleton, const Skeleton& clean,
                       double diagonal);

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_MEASURE_SKELETON_H
