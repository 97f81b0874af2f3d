// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_ROUND_SECTION_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_ROUND_SECTION_H

#include <CGAL/Point_set_skeletonization_3/internal/curve/cross_section.h>

#include <CGAL/number_utils.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/LU>

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

/// The points of a slab of a limb, in the frame of a curve along it.
struct Slab
{
  std::vector<Eigen::Vector2d> across; ///< In the plane orthogonal to the curve.
  std::vector<double> along;           ///< Distances from this plane.
};

/// Returns the slope of the axis of the cylinder that the points of a slab are on: how far it moves
/// across per length along the curve; 0 if that is unknown. For points q at a distance z along the
/// curve, (q - z slope - c)^2 = radius^2 is linear in the slope, in c, in their product and in what
/// is left, but for the square of the slope. As `fitted_circle()`, linear least squares. O(n).
inline Eigen::Vector2d fitted_slope(const Slab& points)
{
  constexpr Eigen::Index unknowns = 6;
  using Equation = Eigen::Matrix<double, unknowns, 1>;
  const std::size_t size = points.across.size();
  double squares = 0;
  for(const Eigen::Vector2d& p : points.across)
    squares += p.squaredNorm() / static_cast<double>(size);
  const double unit = std::sqrt(squares);
  Eigen::Matrix<double, unknowns, unknowns> products = decltype(products)::Zero();
  Equation right = Equation::Zero();
  for(std::size_t i = 0; unit > 0 && i < size; ++i) {
    const Eigen::Vector2d q = points.across[i] / unit;
    const double z = points.along[i] / unit;
    Equation row;
    row << 2 * z * q, 2 * q, z, 1;
    products += row * row.transpose();
    right += q.squaredNorm() * row;
  }
  constexpr double least_condition = 1e-9; // single points and planes are far below
  const Eigen::LDLT<decltype(products)> solver(products);
  if(!(solver.rcond() > least_condition))
    return Eigen::Vector2d::Zero();
  return solver.solve(right).head<2>();
}

/// A round cross-section of a limb that was seen from one side.
struct Round_section
{
  Circle circle;    ///< Around the axis of the limb, where that meets the plane of the curve.
  double share = 0; ///< How much it counts beside its points, in [0, 1].
};

/// Returns the circle across a cylinder that the points of a slab are on. A curve that is not
/// centred yet is crooked, and a section across it is no circle. The circle counts wholly if 150
/// degrees of it were seen or more: a scanner sees half of a round limb, less what it sees at a
/// grazing angle. Not at all if less than 120 degrees were seen, since leaves are folded as much,
/// or more than 240: that is not one side. Nor if the points are off it by more than a twentieth of
/// its radius, as scattered ones are, if there are less than a dozen, or if the cosine of the angle
/// between the cylinder and the curve is less than `aligned`. O(n log n).
inline Round_section round_section(const Slab& points, double aligned)
{
  constexpr std::size_t fewest = 12;
  constexpr double most_off = 0.05; // radii, root mean square
  constexpr double least_seen = 2 * CGAL_PI / 3, half_seen = 5 * CGAL_PI / 6,
                   most_seen = 4 * CGAL_PI / 3;
  Round_section result;
  if(points.across.size() < fewest)
    return result;
  const Eigen::Vector2d slope = fitted_slope(points);
  const double cosine = 1 / std::sqrt(1 + slope.squaredNorm());
  if(cosine < aligned)
    return result;
  // Points move along the axis into the plane of the curve. In this, a circle across the axis is
  // longer along the slope.
  const double shortened = cosine * cosine / (1 + cosine); // 1 - cosine, per square of the slope
  const Eigen::Matrix2d shorten =
    Eigen::Matrix2d::Identity() - shortened * slope * slope.transpose();
  std::vector<Eigen::Vector2d> straight;
  for(std::size_t i = 0; i < points.across.size(); ++i)
    straight.emplace_back(shorten * (points.across[i] - points.along[i] * slope));
  result.circle = fitted_circle(straight);
  std::vector<Eigen::Vector2d> around;
  double off = 0;
  for(const Eigen::Vector2d& p : straight) {
    around.push_back(p - result.circle.center);
    const double distance = around.back().norm() - result.circle.radius;
    off += distance * distance / static_cast<double>(straight.size());
  }
  result.circle.center = shorten.inverse() * result.circle.center;
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
