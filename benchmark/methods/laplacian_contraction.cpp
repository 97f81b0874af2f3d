// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "laplacian_contraction.h"

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <vector>

namespace methods {
namespace {

using Sparse_matrix = Eigen::SparseMatrix<double>;

constexpr double longest_side = 1.6;
constexpr double maximum_contraction = 2048;
constexpr double maximum_attraction = 10000;

/// Of an angle of a millionth. Bounds that are met while there still is a volume spoil the linear
/// precision of the Laplacian: vertices wander along the surface, and contraction stops early.
constexpr double maximum_cotangent = 1e6;

Eigen::Index to_index(std::size_t i)
{
  return static_cast<Eigen::Index>(i);
}

Eigen::Vector3d position(const Positions& points, std::size_t i)
{
  return points.row(to_index(i));
}

/// Of the angle at `apex` in the triangle with `a` and `b`.
double cotangent(const Positions& points, std::size_t apex, std::size_t a, std::size_t b)
{
  const Eigen::Vector3d u = position(points, a) - position(points, apex);
  const Eigen::Vector3d v = position(points, b) - position(points, apex);
  const double sine = u.cross(v).norm(), cosine = u.dot(v); // times both lengths
  return std::abs(cosine) < maximum_cotangent * sine ? cosine / sine
                                                     : std::copysign(maximum_cotangent, cosine);
}

Sparse_matrix cotangent_laplacian(const Positions& points, const std::vector<Fan>& fans)
{
  std::vector<Eigen::Triplet<double>> entries;
  const auto add = [&entries](std::size_t i, std::size_t j, double weight) {
    entries.emplace_back(to_index(i), to_index(j), weight);
    entries.emplace_back(to_index(i), to_index(i), -weight);
  };
  for(std::size_t i = 0; i < fans.size(); ++i)
    for(const auto& [j, k] : fans[i]) {
      add(i, j, cotangent(points, k, i, j));
      add(i, k, cotangent(points, j, k, i));
    }
  Sparse_matrix laplacian(points.rows(), points.rows());
  laplacian.setFromTriplets(entries.begin(), entries.end());
  return laplacian;
}

/// One step: the normal equations of the two weighted terms.
/// \return NaN if they cannot be solved
Positions step(const Positions& points, const std::vector<Fan>& fans, double contraction,
               const Eigen::VectorXd& attraction)
{
  const Sparse_matrix laplacian = contraction * cotangent_laplacian(points, fans);
  Sparse_matrix matrix = Sparse_matrix(laplacian.transpose()) * laplacian;
  const Eigen::VectorXd squares = attraction.cwiseAbs2();
  matrix.diagonal() += squares;
  const Eigen::SimplicialLDLT<Sparse_matrix> solver(matrix);
  if(solver.info() != Eigen::Success)
    return Positions::Constant(points.rows(), 3, std::numeric_limits<double>::quiet_NaN());
  return solver.solve(squares.asDiagonal() * points);
}

double longest_side_of(const Positions& points)
{
  return (points.colwise().maxCoeff() - points.colwise().minCoeff()).maxCoeff();
}

Positions contract_normalized(const Positions& points, const std::vector<Fan>& fans,
                              const Contraction& contraction)
{
  const Eigen::VectorXd first_areas = fan_areas(points, fans);
  std::size_t triangles_of_fans = 0;
  for(const Fan& fan : fans)
    triangles_of_fans += fan.size();
  double weight = 1 / (10 * std::sqrt(first_areas.sum() / static_cast<double>(triangles_of_fans)));
  Eigen::VectorXd attraction = Eigen::VectorXd::Ones(points.rows()), areas = first_areas;
  Positions before = points;
  for(std::size_t i = 0; i < contraction.maximum_steps; ++i) {
    const Positions after = step(before, fans, weight, attraction);
    const Eigen::VectorXd areas_after = fan_areas(after, fans);
    if(!(areas_after.sum() < areas.sum())) { // NaN neither
      if(i == 0)
        throw std::runtime_error("the first contraction step failed");
      break;
    }
    const bool is_last = contraction.is_enough(points, before, after);
    before = after;
    areas = areas_after;
    if(is_last)
      break;
    weight = std::min(weight * contraction.growth, maximum_contraction);
    attraction = (first_areas.array() / areas.array()).sqrt().min(maximum_attraction);
  }
  return before;
}

} // namespace

Eigen::VectorXd fan_areas(const Positions& points, const std::vector<Fan>& fans)
{
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(points.rows());
  for(std::size_t i = 0; i < fans.size(); ++i)
    for(const auto& [j, k] : fans[i]) {
      const Eigen::Vector3d u = position(points, j) - position(points, i);
      const Eigen::Vector3d v = position(points, k) - position(points, i);
      areas[to_index(i)] += u.cross(v).norm() / 2;
    }
  return areas;
}

Positions contract(const Positions& points, const std::vector<Fan>& fans,
                   const Contraction& contraction)
{
  const Eigen::RowVector3d centre = (points.colwise().maxCoeff() + points.colwise().minCoeff()) / 2;
  const double scale = longest_side / longest_side_of(points);
  const Positions normalized = (points.rowwise() - centre) * scale;
  return (contract_normalized(normalized, fans, contraction) / scale).rowwise() + centre;
}

} // namespace methods
