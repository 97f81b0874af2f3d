// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "measure_skeleton.h"

#include "skeleton_distance.h"
#include "spurs.h"
#include "unexplained_points.h"

void measure_skeleton(Measurements& row, const Skeleton& skeleton,
                      const std::vector<Point>& points)
{
  row.got = count_graph(skeleton);
  row.spurs = metrics::count_spurs(skeleton);
  row.unexplained = metrics::unexplained_points(points, skeleton);
}

void measure_stability(Measurements& row, const Skeleton& skeleton, const Skeleton& clean,
                       double diagonal)
{
  constexpr double step = 0.002; // diagonals; a fraction of any limb's radius
  if(num_vertices(skeleton) == 0 || num_vertices(clean) == 0)
    return;
  const auto distance = metrics::two_way_distance(skeleton, clean, step * diagonal);
  row.moved_mean = distance.mean / diagonal;
  row.moved_maximum = distance.maximum / diagonal;
}
