// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_GAUSSIAN_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_GAUSSIAN_H

#include <Eigen/Core>

#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

using Vector3 = Eigen::Vector3d;
using Matrix3 = Eigen::Matrix3d;

/// A weighted Gaussian in normalised coordinates (see `Normalization`).
struct Gaussian
{
  double weight = 0;
  Vector3 mean = Vector3::Zero();
  Matrix3 covariance = Matrix3::Zero();
};

using Gaussians = std::vector<Gaussian>;

/// Returns the means, in the same order. O(n).
inline std::vector<Vector3> means_of(const Gaussians& gaussians)
{
  std::vector<Vector3> result;
  result.reserve(gaussians.size());
  for(const Gaussian& g : gaussians)
    result.push_back(g.mean);
  return result;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_GAUSSIAN_H
