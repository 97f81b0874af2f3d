// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_MEASURE_SKELETON_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_MEASURE_SKELETON_H

#include "Measurements.h"
#include "methods/Method.h"
#include "skeleton_distance.h"
#include "spurs.h"
#include "unexplained_points.h"

#include <vector>

/// Fills in what can be measured with nothing but the cloud.
inline void measure_skeleton(Measurements& row, const Skeleton& skeleton,
                             const std::vector<Point>& points)
{
  row.got = count_graph(skeleton);
  row.spurs = metrics::count_spurs(skeleton);
  row.unexplained = metrics::unexplained_points(points, skeleton);
}

/// Fills in how far the skeleton is from that of the clean cloud.
inline void measure_stability(Measurements& row, const Skeleton& skeleton, const Skeleton& clean,
                              double diagonal)
{
  constexpr double step = 0.002; // diagonals; a fraction of any limb's radius
  if(num_vertices(skeleton) == 0 || num_vertices(clean) == 0)
    return;
  const auto distance = metrics::two_way_distance(skeleton, clean, step * diagonal);
  row.moved_mean = distance.mean / diagonal;
  row.moved_maximum = distance.maximum / diagonal;
}

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_MEASURE_SKELETON_H
