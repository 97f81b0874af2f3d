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

/// A circle across the cylinder that the points of a slab are on. They move along the axis into the
/// plane of the curve, where a circle across the axis is longer along the slope: shortened by that,
/// they are on a circle.
struct Fitted_cylinder
{
  double cosine = 1; ///< Of the angle between the axis and the curve.
  Eigen::Matrix2d shorten = Eigen::Matrix2d::Identity();
  std::vector<Eigen::Vector2d> straight; ///< The points, shortened.
  Circle circle;                         ///< Among them.
  double off = 0; ///< How far the points are off it, in its radii: root mean square, per point that
                  ///< the fit leaves free.
};

/// Fits a cylinder to the points of a slab. O(n). \pre there are more than six points
inline Fitted_cylinder fitted_cylinder(const Slab& points)
{
  Fitted_cylinder result;
  const Eigen::Vector2d slope = fitted_slope(points);
  result.cosine = 1 / std::sqrt(1 + slope.squaredNorm());
  const double shortened = // 1 - cosine, per square of the slope
    result.cosine * result.cosine / (1 + result.cosine);
  result.shorten -= shortened * slope * slope.transpose();
  constexpr double unknowns = 6; // as many points are on some cylinder
  const std::size_t size = points.across.size();
  result.straight.reserve(size);
  for(std::size_t i = 0; i < size; ++i)
    result.straight.emplace_back(result.shorten * (points.across[i] - points.along[i] * slope));
  const Circle& circle = result.circle = fitted_circle(result.straight);
  double squares = 0;
  for(const Eigen::Vector2d& p : result.straight) {
    const double off = (p - circle.center).norm() / circle.radius - 1;
    squares += off * off;
  }
  result.off = std::sqrt(squares / (static_cast<double>(size) - unknowns));
  return result;
}

/// Returns how much of a round limb, in radians, a scanner sees from one side: half of it, but for
/// the last step between points at either end, where it sees the limb at a grazing angle. Of points
/// a share s of the radius apart, the last one is anywhere within s of the edge of what is seen, or
/// two thirds of sqrt(2 s) on average along the arc; and at less than 15 degrees nothing is seen.
inline double arc_seen_from_one_side(double spacing, double radius)
{
  constexpr double most_seen = 5 * CGAL_PI / 6;
  return (std::min)(most_seen, CGAL_PI - 4. / 3 * std::sqrt(2 * spacing / radius));
}

/// Points from which a round section is told: fewer are near some circle by chance.
constexpr std::size_t fewest_on_circle = 12;

/// A round cross-section of a limb.
struct Round_section
{
  Circle circle;    ///< Around the axis of the limb, where that meets the plane of the curve.
  double share = 0; ///< How much it counts beside its points, in [0, 1].
};

/// Returns the circle across the cylinder that the points of a slab are on. A curve that is not
/// centred yet is crooked, and a section across it is no circle. The circle counts wholly if as much
/// of it was seen as from one side, see `arc_seen_from_one_side()`; not at all if it was 30 degrees
/// less, since leaves are folded as much. Nor if the points are off it by more than a twentieth of
/// its radius, as scattered ones are, if there are too few, or if the cosine of the angle between
/// the cylinder and the curve is less than `aligned`. O(n log n).
inline Round_section round_section(const Slab& points, double aligned)
{
  constexpr double most_off = 0.05; // radii
  constexpr double folded = CGAL_PI / 6;
  if(points.across.size() < fewest_on_circle)
    return {};
  const Fitted_cylinder cylinder = fitted_cylinder(points);
  if(cylinder.cosine < aligned || !(cylinder.off < most_off))
    return {};
  const Circle& circle = cylinder.circle;
  std::vector<Eigen::Vector2d> around;
  for(const Eigen::Vector2d& p : cylinder.straight)
    around.push_back(p - circle.center);
  const double seen = // there is one gap
    (std::max)(0.0, 2 * CGAL_PI - cross_section(around).unknown - between_points);
  double half_width = 0;
  for(double z : points.along)
    half_width = (std::max)(half_width, std::abs(z));
  const double area = 2 * half_width * seen * circle.radius;
  const double spacing = std::sqrt(area / static_cast<double>(around.size()));
  const double missing = arc_seen_from_one_side(spacing, circle.radius) - seen;
  return {{cylinder.shorten.inverse() * circle.center, circle.radius},
          std::clamp(1 - missing / folded, 0.0, 1.0)};
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_ROUND_SECTION_H
