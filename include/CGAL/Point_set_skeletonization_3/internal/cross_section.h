// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CROSS_SECTION_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CROSS_SECTION_H

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

/// The region around the origin of a plane that some points bound.
struct Cross_section
{
  Eigen::Vector2d center = Eigen::Vector2d::Zero(); ///< Of its area.
  double area = 0;                                  ///< 0: it is not known.
  double gap = 2 * CGAL_PI; ///< The widest angle in which there is no point, in (0, 2 pi].
};

/// The region that is star-shaped around the origin and has the given points on its boundary. Only
/// their places count, so it matters little how densely the boundary is sampled, and where: what
/// points scatter to either side of it cancels out. Between two neighbours in angle the distance
/// changes evenly with the angle. So an arc remains an arc, and a circle of which a part is missing
/// has its centre where it should.
inline Cross_section cross_section(const std::vector<Eigen::Vector2d>& boundary)
{
  constexpr std::size_t fewest = 3;
  constexpr double step = CGAL_PI / 8; // the area of a circle in such steps is exact to 3 %
  Cross_section result;
  if(boundary.size() < fewest)
    return result;
  std::vector<std::pair<double, double>> polar; // angle and distance
  for(const Eigen::Vector2d& p : boundary)
    polar.emplace_back(std::atan2(p.y(), p.x()), p.norm());
  std::sort(polar.begin(), polar.end());
  polar.emplace_back(polar.front().first + 2 * CGAL_PI, polar.front().second);

  Eigen::Vector2d moment = Eigen::Vector2d::Zero();
  result.gap = 0;
  for(std::size_t i = 0; i + 1 < polar.size(); ++i) {
    const double gap = polar[i + 1].first - polar[i].first;
    result.gap = std::max(result.gap, gap);
    const int pieces = 1 + static_cast<int>(gap / step);
    const auto point = [&](int k) {
      const double t = static_cast<double>(k) / pieces;
      const double angle = polar[i].first + t * gap;
      const double distance = polar[i].second + t * (polar[i + 1].second - polar[i].second);
      return Eigen::Vector2d(distance * std::cos(angle), distance * std::sin(angle));
    };
    Eigen::Vector2d p = point(0);
    for(int k = 0; k < pieces; ++k) {
      const Eigen::Vector2d q = point(k + 1);
      const double triangle = (p.x() * q.y() - p.y() * q.x()) / 2; // with the origin
      result.area += triangle;
      moment += triangle * (p + q) / 3;
      p = q;
    }
  }
  if(result.area > 0)
    result.center = moment / result.area;
  return result;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CROSS_SECTION_H
