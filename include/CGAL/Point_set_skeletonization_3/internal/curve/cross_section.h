// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_CROSS_SECTION_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_CROSS_SECTION_H

#include <CGAL/number_utils.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// The region of a plane around the origin that some points bound.
struct Cross_section
{
  Eigen::Vector2d center = Eigen::Vector2d::Zero(); ///< Centroid of the area.
  double area = 0;                                  ///< 0: unknown.
  double unknown = 2 * CGAL_PI; ///< Radians; sum of gaps, each less `between_points`.
};

/// Returns a number that orders directions like their angle in [-pi, pi], without std::atan2(): the
/// position on a square instead of a circle, in [-2, 2]. Its slope is between 1/2 and 1.
inline double pseudo_angle(const Eigen::Vector2d& p)
{
  if(p.isZero(0))
    return 0; // as std::atan2()
  const double way = p.y() / p.lpNorm<1>();
  return p.x() >= 0 ? way : std::copysign(2.0, p.y()) - way;
}

/// Radians between two points of a boundary that are no gap yet.
constexpr double between_points = CGAL_PI / 3;

/// Returns the region that is star-shaped around the origin with the given points on its boundary;
/// area 0 with fewer than three. The density of points along the boundary hardly matters, and
/// scatter to both sides cancels out. In a gap the distance is interpolated linearly in the angle:
/// an arc remains an arc, and a circle with a missing part keeps its centre. O(n log n).
inline Cross_section cross_section(const std::vector<Eigen::Vector2d>& boundary)
{
  constexpr std::size_t fewest = 3;
  constexpr double step = CGAL_PI / 8; // the area of a circle in such steps is exact to 3 %
  Cross_section result;
  if(boundary.size() < fewest)
    return result;
  std::vector<std::pair<double, std::size_t>> around; // by pseudo-angle
  around.reserve(boundary.size() + 1);
  for(std::size_t i = 0; i < boundary.size(); ++i)
    around.emplace_back(pseudo_angle(boundary[i]), i);
  std::sort(around.begin(), around.end());
  around.emplace_back(around.front().first + 4, around.front().second);

  Eigen::Vector2d moment = Eigen::Vector2d::Zero();
  const auto add = [&](const Eigen::Vector2d& p, const Eigen::Vector2d& q) {
    const double triangle = (p.x() * q.y() - p.y() * q.x()) / 2; // with the origin
    result.area += triangle;
    moment += triangle * (p + q) / 3;
  };
  result.unknown = 0;
  for(std::size_t i = 0; i + 1 < around.size(); ++i) {
    const Eigen::Vector2d &p = boundary[around[i].second], &q = boundary[around[i + 1].second];
    if(2 * (around[i + 1].first - around[i].first) < step) {
      add(p, q);
      continue;
    }
    const double angle = std::atan2(p.y(), p.x());
    double gap = std::atan2(q.y(), q.x()) - angle;
    if(gap <= 0) // from the last to the first
      gap += 2 * CGAL_PI;
    result.unknown += (std::max)(0.0, gap - between_points);
    const int pieces = 1 + static_cast<int>(gap / step);
    Eigen::Vector2d from = p;
    for(int k = 1; k <= pieces; ++k) {
      const double t = static_cast<double>(k) / pieces;
      const double distance = p.norm() + t * (q.norm() - p.norm());
      const Eigen::Vector2d to(distance * std::cos(angle + t * gap),
                               distance * std::sin(angle + t * gap));
      add(from, to);
      from = to;
    }
  }
  if(result.area > 0)
    result.center = moment / result.area;
  return result;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_CROSS_SECTION_H
