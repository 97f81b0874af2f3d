// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_LAPLACIAN_CONTRACTION_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_LAPLACIAN_CONTRACTION_H

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace methods {

/// A position per row.
using Positions = Eigen::Matrix<double, Eigen::Dynamic, 3>;

/// The triangles at a vertex, as the edges opposite to it.
using Fan = std::vector<std::array<std::size_t, 2>>;

/// How fast contraction gains on attraction, and when it is enough.
struct Contraction
{
  double growth; ///< s_L, of the weight of contraction with every step; > 1
  std::size_t maximum_steps;

  /// Whether to stop after a step. Gets the positions before the first step and before and after
  /// this one, all in the same unit.
  std::function<bool(const Positions& first, const Positions& before, const Positions& after)>
      is_enough;
};

/// Contracts a surface to where its volume is next to nothing: Au, Tai, Chu, Cohen-Or, Lee,
/// "Skeleton Extraction by Mesh Contraction", SIGGRAPH 2008, section 4. Every step minimises
/// |W_L L x|^2 + |W_H (x - p)|^2 with the cotangent Laplacian L of the positions p before it. W_L
/// grows by `growth`; W_H of a vertex grows as its fan shrinks: by the root of the ratio of areas.
///
/// The first W_L is not what the article says but what its authors' program and that of Cao et al.
/// take: 1 / (10 sqrt(A)), A the mean area of the triangles of a shape whose box has a longest side
/// of 1.6. So are the bounds of the weights. The article does not say what cotangents become when
/// triangles degenerate: here they are bounded.
///
/// \param fans of every vertex, its triangles
/// \return the positions after the last step that made the sum of the areas smaller
/// \throw std::runtime_error if the first step fails
Positions contract(const Positions& points, const std::vector<Fan>& fans,
                   const Contraction& contraction);

/// The areas of the fans.
Eigen::VectorXd fan_areas(const Positions& points, const std::vector<Fan>& fans);

} // namespace methods

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_LAPLACIAN_CONTRACTION_H
