// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_UNSUPPORTED_SHARE_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_UNSUPPORTED_SHARE_H

#include "Point_tree.h"
#include "skeleton_samples.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace metrics {
namespace internal {

/// The largest angle around a piece of a skeleton in which there is no point, in radians. Only
/// points that are more beside the piece than before or behind it count.
inline double largest_gap(const Skeleton_sample& sample, const std::vector<Point>& points)
{
  constexpr double full_turn = 2 * CGAL_PI;
  const Kernel::Plane_3 plane(sample.point, sample.direction);
  const Vector u = plane.base1() / std::sqrt(plane.base1().squared_length());
  const Vector v = CGAL::cross_product(sample.direction, u);
  std::vector<double> angles;
  for(const Point& p : points) {
    const Vector offset = p - sample.point;
    const double x = offset * u, y = offset * v;
    if(std::hypot(x, y) > std::abs(offset * sample.direction))
      angles.push_back(std::atan2(y, x));
  }
  if(angles.empty())
    return full_turn;
  std::sort(angles.begin(), angles.end());
  double gap = angles.front() + full_turn - angles.back();
  for(std::size_t i = 1; i < angles.size(); ++i)
    gap = std::max(gap, angles[i] - angles[i - 1]);
  return gap;
}

inline bool is_supported(const Skeleton_sample& sample, const Point_tree& tree, double near)
{
  // A limb that is scanned from one side has points half of the way around it.
  constexpr double widest_gap = 200 * CGAL_PI / 180;
  const double distance = tree.distance(sample.point);
  if(distance <= near)
    return true;
  // What is twice as far away belongs to the same limb, if that is not quite round.
  return sample.direction != CGAL::NULL_VECTOR &&
         largest_gap(sample, tree.within(2 * distance, sample.point)) <= widest_gap;
}

} // namespace internal

/// Share of the length of a skeleton that goes through empty space, in [0, 1]; NaN if it is empty:
/// where no point is within `near`, and those that are nearest are not around it. Inside a thick
/// limb, they are.
///
/// \param skeleton a BGL graph whose vertices bundle a `.point`
/// \param near in the unit of the points; also the distance of the places that are asked
template <typename Skeleton>
double unsupported_share(const Skeleton& skeleton, const Point_tree& points, double near)
{
  double length = 0, unsupported = 0;
  for(const Skeleton_sample& sample : sample_skeleton(skeleton, near)) {
    length += sample.length;
    unsupported += internal::is_supported(sample, points, near) ? 0 : sample.length;
  }
  return unsupported / length;
}

} // namespace metrics

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_UNSUPPORTED_SHARE_H
