// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_ROUND_SECTION_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_ROUND_SECTION_H

#include <CGAL/Point_set_skeletonization_3/internal/core/quantile.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/cross_section.h>

#include <CGAL/number_utils.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
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
struct Cylinder_section
{
  Eigen::Vector2d slope = Eigen::Vector2d::Zero(); ///< How far the axis moves across per length
                                                   ///< along the curve.
  Eigen::Matrix2d shorten = Eigen::Matrix2d::Identity();
  std::vector<Eigen::Vector2d> points; ///< Of the slab, shortened.
  Circle circle;                       ///< Among them.
  double noise = 0; ///< Standard deviation of the points from the circle, in its radii.
  double error = std::numeric_limits<double>::infinity(); ///< That of its centre, likewise;
                                                          ///< infinite: there is no such cylinder.

  /// The cosine of the angle between the axis and the curve.
  double cosine() const { return 1 / std::sqrt(1 + slope.squaredNorm()); }

  /// How far a point is off the circle, in its radii.
  double off(std::size_t i) const
  {
    return (points[i] - circle.center).norm() / circle.radius - 1;
  }

  /// Moves the points of the slab along an axis of another slope. O(n).
  void set_slope(const Eigen::Vector2d& other, const Slab& slab)
  {
    slope = other;
    const double shortened = cosine() * cosine() / (1 + cosine()); // 1 - cosine, per slope squared
    shorten = Eigen::Matrix2d::Identity() - shortened * slope * slope.transpose();
    points.clear();
    for(std::size_t i = 0; i < slab.across.size(); ++i)
      points.emplace_back(shorten * (slab.across[i] - slab.along[i] * slope));
  }
};

/// Weighted equations for how a cylinder is to change, per radius: slope, centre, radius.
struct Cylinder_equations
{
  static constexpr Eigen::Index unknowns = 5;
  using Equation = Eigen::Matrix<double, unknowns, 1>;
  using Matrix = Eigen::Matrix<double, unknowns, unknowns>;

  Matrix products = Matrix::Zero();
  Equation right = Equation::Zero();
};

/// Returns the equations for the points of a slab to be on a cylinder. Weights fall with the
/// distance from it (Cauchy's, see Holland and Welsch 1977). O(n).
inline Cylinder_equations cylinder_equations(const Cylinder_section& section, const Slab& slab)
{
  constexpr double tuning = 2.385; // standard deviations; of normally distributed points it takes
                                   // 5 % more to know as much as without weights
  const Circle& circle = section.circle;
  Cylinder_equations result;
  for(std::size_t i = 0; i < section.points.size(); ++i) {
    const Eigen::Vector2d outwards = (section.points[i] - circle.center).normalized();
    const double off = section.off(i), relative = off / (tuning * section.noise);
    const double weight = 1 / (1 + relative * relative);
    Cylinder_equations::Equation row;
    row << slab.along[i] / circle.radius * outwards, outwards, 1;
    result.products += weight * row * row.transpose();
    result.right += weight * off * row;
  }
  return result;
}

/// Returns the standard deviation of the points from a circle, in its radii, by the median of their
/// distances. O(n).
inline double noise_of(const Cylinder_section& section)
{
  constexpr double roundest = 0.02; // radii: no limb is rounder
  constexpr double normal = 1.4826; // standard deviations in the median distance
  const auto size = static_cast<double>(section.points.size());
  std::vector<double> distances;
  for(std::size_t i = 0; i < section.points.size(); ++i)
    distances.push_back(std::abs(section.off(i)));
  const double free = size - static_cast<double>(Cylinder_equations::unknowns);
  return (std::max)(roundest,
                    std::sqrt(size / free) * normal * quantile(std::move(distances), 0.5));
}

/// Fits a cylinder to the points of a slab, of which a few may be of something else: the weighted
/// least squares of their distances from it, starting with all points. What is no cylinder is left
/// soon. O(n). \pre there are more than six points
inline Cylinder_section fitted_cylinder(const Slab& slab)
{
  // Radii: points scattered all over a disc deviate by 0.35 from a circle, in radii of their mean
  // distance from its middle; those of a trunk from a laser scanner by about 0.1. Before the fit is
  // done they are further off.
  constexpr double scattered = 0.35, most_at_first = scattered / 2, most_left = scattered / 3;
  constexpr int most_steps = 10;
  constexpr double last_step = 0.03;       // radii: what is left is a fraction of that
  constexpr double least_condition = 1e-9; // single points and planes are far below
  Cylinder_section result;
  Circle& circle = result.circle;
  result.set_slope(fitted_slope(slab), slab);
  circle = fitted_circle(result.points);
  for(int k = 0; k < most_steps && circle.radius > 0; ++k) {
    result.noise = noise_of(result);
    if(!(result.noise < most_at_first))
      break;
    const Cylinder_equations equations = cylinder_equations(result, slab);
    const Eigen::LDLT<Cylinder_equations::Matrix> solver(equations.products);
    if(!(solver.rcond() > least_condition))
      break;
    const Cylinder_equations::Equation step = solver.solve(equations.right);
    const Eigen::Vector2d center =
      result.shorten.inverse() * (circle.center + circle.radius * step.segment<2>(2));
    result.set_slope(result.slope + step.head<2>(), slab);
    circle = {result.shorten * center, circle.radius * (1 + step[4])};
    if(step.norm() < last_step) {
      if(!(result.noise < most_left))
        break;
      const Cylinder_equations::Matrix covariances =
        solver.solve(Cylinder_equations::Matrix::Identity());
      result.error = result.noise * std::sqrt(covariances(2, 2) + covariances(3, 3));
      break;
    }
  }
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
/// centred yet is crooked, and a section across it is no circle. The circle counts wholly if as
/// much of it was seen as from one side, see `arc_seen_from_one_side()`; not at all if it was 30
/// degrees less, since leaves are folded as much. Nor if its centre is not known well enough (of
/// half a circle the median of the points is 0.64 radii from the centre, which is to be nearer), if
/// there are too few points, or if the cosine of the angle between the cylinder and the curve is
/// less than `aligned`. O(n log n).
inline Round_section round_section(const Slab& slab, double aligned)
{
  constexpr double most_error = 0.15; // radii: twice that is half as far off as the median
  constexpr double folded = CGAL_PI / 6;
  constexpr double near = 3; // standard deviations: all points on the circle, but 1 of 300
  if(slab.across.size() < fewest_on_circle)
    return {};
  const Cylinder_section section = fitted_cylinder(slab);
  const Circle& circle = section.circle;
  if(section.cosine() < aligned || !(section.error < most_error))
    return {};
  std::vector<Eigen::Vector2d> around;
  for(std::size_t i = 0; i < section.points.size(); ++i)
    if(std::abs(section.off(i)) < near * section.noise)
      around.push_back(section.points[i] - circle.center);
  const double seen = // there is one gap
    (std::max)(0.0, 2 * CGAL_PI - cross_section(around).unknown - between_points);
  double half_width = 0;
  for(double z : slab.along)
    half_width = (std::max)(half_width, std::abs(z));
  const double area = 2 * half_width * seen * circle.radius;
  const double spacing = std::sqrt(area / static_cast<double>(around.size()));
  const double missing = arc_seen_from_one_side(spacing, circle.radius) - seen;
  return {{section.shorten.inverse() * circle.center, circle.radius},
          std::clamp(1 - missing / folded, 0.0, 1.0)};
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_ROUND_SECTION_H
