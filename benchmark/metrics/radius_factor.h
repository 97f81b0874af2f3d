// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_RADIUS_FACTOR_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_RADIUS_FACTOR_H

#include "Segment_tree.h"
#include "skeleton_edges.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace metrics {

/// The factor by which radii are wrong, too large or too small alike: 1 if they are exact. Half of
/// the length of the skeleton has no larger one. Only what is within a distance of the true axis
/// counts; NaN if nothing is. Infinite if radii are not positive.
///
/// \param skeleton a BGL graph whose vertices bundle a `.point` and a `.radius`
/// \param axis a range of segments with ends `.a`, `.b` and the radii `.radius_a`, `.radius_b` > 0
template <typename Skeleton, typename Axis>
double radius_factor(const Skeleton& skeleton, const Axis& axis, double distance)
{
  std::vector<Segment> segments;
  for(const auto& piece : axis)
    segments.emplace_back(to_point(piece.a), to_point(piece.b));
  const Segment_tree tree(segments);
  std::vector<std::pair<double, double>> factors; // and the length that has each
  double length = 0;
  for(const auto& [a, b] : edge_ends(skeleton))
    for(const auto v : {a, b}) {
      const Point p = to_point(skeleton[v].point);
      const Nearest nearest = tree.nearest(p);
      if(nearest.distance > distance)
        continue;
      const auto& piece = axis[nearest.segment];
      const double factor =
        skeleton[v].radius / nearest.interpolate(piece.radius_a, piece.radius_b);
      const double half = std::sqrt(CGAL::squared_distance(to_point(skeleton[a].point),
                                                           to_point(skeleton[b].point))) / 2;
      factors.emplace_back((std::max)(factor, 1 / factor), half);
      length += half;
    }
  if(factors.empty())
    return std::numeric_limits<double>::quiet_NaN();
  std::sort(factors.begin(), factors.end());
  double so_far = 0;
  for(const auto& [factor, half] : factors)
    if(so_far += half; 2 * so_far >= length)
      return factor;
  return factors.back().first;
}

} // namespace metrics

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_RADIUS_FACTOR_H
