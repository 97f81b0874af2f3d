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

/// A symmetric matrix that sums are taken in: six numbers, each by name, stay in registers.
struct Symmetric_sum
{
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;

  /// Adds the upper triangle of `a * b.transpose()`.
  void add_product(const Vector3& a, const Vector3& b)
  {
    xx += a[0] * b[0];
    xy += a[0] * b[1];
    xz += a[0] * b[2];
    yy += a[1] * b[1];
    yz += a[1] * b[2];
    zz += a[2] * b[2];
  }

  void add(double weight, const Matrix3& m)
  {
    xx += weight * m(0, 0);
    xy += weight * m(0, 1);
    xz += weight * m(0, 2);
    yy += weight * m(1, 1);
    yz += weight * m(1, 2);
    zz += weight * m(2, 2);
  }

  Matrix3 matrix() const
  {
    Matrix3 m;
    m << xx, xy, xz, xy, yy, yz, xz, yz, zz;
    return m;
  }
};

/// Weight, mean and covariance of a weighted union, accumulated relative to an `origin` close to
/// the data: second moments taken about a far origin would cancel.
class Moments
{
public:
  explicit Moments(const Vector3& origin) : origin_(origin) {}

  void add(double weight, const Vector3& point)
  {
    const Vector3 d = point - origin_, weighted = weight * d;
    weight_ += weight;
    first_ += weighted;
    second_.add_product(weighted, d);
  }

  void add(const Gaussian& g) { add(g.weight, g); }

  /// Adds `g` with another weight, as the responsibilities of expectation maximization do.
  void add(double weight, const Gaussian& g)
  {
    add(weight, g.mean);
    second_.add(weight, g.covariance);
  }

  double weight() const { return weight_; }

  /// \pre `weight() > 0`
  Gaussian gaussian() const
  {
    const Vector3 d = first_ / weight_;
    return {weight_, origin_ + d, second_.matrix() / weight_ - d * d.transpose()};
  }

private:
  Vector3 origin_;
  double weight_ = 0;
  Vector3 first_ = Vector3::Zero();
  Symmetric_sum second_;
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_GAUSSIAN_H
