// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_ROUND_SECTION_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_ROUND_SECTION_H

#include <CGAL/Point_set_skeletonization_3/internal/curve/cross_section.h>

#include <CGAL/number_utils.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// A circle in a plane.
struct Circle
{
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  double radius = 0; ///< 0: unknown.
};

/// Returns the circle that fits some points, by linear least squares (Kasa 1976); unknown if they
/// are on a line. Accurate for a third of a circle or more. O(n).
inline Circle fitted_circle(const std::vector<Eigen::Vector2d>& points)
{
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for(const Eigen::Vector2d& p : points)
    mean += p / static_cast<double>(points.size());
  // |q|^2 = 2 q.c + (radius^2 - |c|^2) for each point q; with the mean in the origin, the latter is
  // the mean of the former.
  Eigen::Matrix2d products = Eigen::Matrix2d::Zero();
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
  double squares = 0;
  for(const Eigen::Vector2d& p : points) {
    const Eigen::Vector2d q = p - mean;
    products += 2 * q * q.transpose();
    right += q.squaredNorm() * q;
    squares += q.squaredNorm() / static_cast<double>(points.size());
  }
  const Eigen::LDLT<Eigen::Matrix2d> solver(products);
  if(!(solver.rcond() > 0))
    return {};
  const Eigen::Vector2d center = solver.solve(right);
  return {center + mean, std::sqrt(squares + center.squaredNorm())};
}

/// A round cross-section of a limb that was seen from one side.
struct Round_section
{
  Circle circle;
  double share = 0; ///< How much it counts beside its points, in [0, 1].
};

/// Returns the circle that points are on. It counts wholly if 150 degrees of it were seen or more: a
/// scanner sees half of a round limb, less what it sees at a grazing angle. Not at all if less than
/// 120 degrees were seen, since leaves are folded as much, or more than 240: that is not one side.
/// Nor if the points are off it by more than a twentieth of its radius, as scattered ones are, or if
/// there are less than a dozen. O(n log n).
inline Round_section round_section(const std::vector<Eigen::Vector2d>& points)
{
  constexpr std::size_t fewest = 12;
  constexpr double most_off = 0.05; // radii, root mean square
  constexpr double least_seen = 2 * CGAL_PI / 3, half_seen = 5 * CGAL_PI / 6,
                   most_seen = 4 * CGAL_PI / 3;
  Round_section result;
  if(points.size() < fewest)
    return result;
  result.circle = fitted_circle(points);
  std::vector<Eigen::Vector2d> around;
  double off = 0;
  for(const Eigen::Vector2d& p : points) {
    around.push_back(p - result.circle.center);
    const double distance = around.back().norm() - result.circle.radius;
    off += distance * distance / static_cast<double>(points.size());
  }
  if(std::sqrt(off) >= most_off * result.circle.radius)
    return result;
  const double seen = 2 * CGAL_PI - cross_section(around).unknown - between_points; // one gap
  if(seen <= most_seen)
    result.share = std::clamp((seen - least_seen) / (half_seen - least_seen), 0.0, 1.0);
  return result;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_ROUND_SECTION_H
