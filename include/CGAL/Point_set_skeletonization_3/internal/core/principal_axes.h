// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_PRINCIPAL_AXES_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_PRINCIPAL_AXES_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>

#include <Eigen/Eigenvalues>

#include <cmath>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// The eigenvalues of a covariance, ascending, and its unit eigenvectors as columns.
struct Principal_axes
{
  Vector3 variances; ///< >= 0
  Matrix3 directions;
};

/// Returns the principal axes of a positive semidefinite covariance, in closed form. O(1).
inline Principal_axes principal_axes(const Matrix3& covariance)
{
  Eigen::SelfAdjointEigenSolver<Matrix3> solver;
  solver.computeDirect(covariance);
  return {solver.eigenvalues().cwiseMax(0), solver.eigenvectors()};
}

/// Returns how far differences of variances, in units of the greatest, come about by chance among
/// some points: measured on points that are scattered evenly.
inline double anisotropy_by_chance(double points)
{
  return 0.95 / std::sqrt(points);
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_PRINCIPAL_AXES_H
