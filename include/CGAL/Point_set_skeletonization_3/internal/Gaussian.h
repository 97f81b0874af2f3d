// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_GAUSSIAN_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_GAUSSIAN_H

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

/// Weight, mean and covariance of a weighted union, accumulated relative to an `origin` close to
/// the data: second moments taken about a far origin would cancel.
class Moments
{
public:
  explicit Moments(const Vector3& origin) : origin_(origin) {}

  void add(double weight, const Vector3& point)
  {
    const Vector3 d = point - origin_;
    weight_ += weight;
    first_ += weight * d;
    second_ += weight * d * d.transpose();
  }

  void add(const Gaussian& g) { add(g.weight, g); }

  /// Adds `g` with another weight, as the responsibilities of expectation maximization do.
  void add(double weight, const Gaussian& g)
  {
    add(weight, g.mean);
    second_ += weight * g.covariance;
  }

  double weight() const { return weight_; }

  /// \pre `weight() > 0`
  Gaussian gaussian() const
  {
    const Vector3 d = first_ / weight_;
    return {weight_, origin_ + d, second_ / weight_ - d * d.transpose()};
  }

private:
  Vector3 origin_;
  double weight_ = 0;
  Vector3 first_ = Vector3::Zero();
  Matrix3 second_ = Matrix3::Zero();
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_GAUSSIAN_H
