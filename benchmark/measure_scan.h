// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_MEASURE_SCAN_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_MEASURE_SCAN_H

#include "Row.h"
#include "methods/Method.h"

#include "generator/Known_shape.h"

#include <vector>

/// Fills in how much of the true skeleton of a scan was found, and how much of what was found is
/// true. Of a reference with radii, a place is seen if there are points at its radius. Where it is
/// true, its radii are compared with those of the axis of the shape, if that is known.
void measure_scan(Row& row, const Skeleton& skeleton, const Skeleton& reference,
                  const shapes::Known_shape& shape, const std::vector<Point>& points);

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_MEASURE_SCAN_H
