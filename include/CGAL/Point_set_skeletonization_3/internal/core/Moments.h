// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_MOMENTS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_MOMENTS_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>

#include <Eigen/Core>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Weight, first and second moments of weighted points and Gaussians about an origin that the
/// caller knows. It should be close to the data, to avoid cancellation. Scalar members let
/// compilers keep them in registers.
class Moments
{
public:
  /// Adds a point at offset `d` from the origin.
  void add(double weight, const Vector3& d)
  {
    const Vector3 weighted = weight * d;
    weight_ += weight;
    first_ += weighted;
    add_product(weighted, d);
  }

  /// Adds a Gaussian whose mean is at offset `d` from the origin.
  void add(double weight, const Vector3& d, const Matrix3& covariance)
  {
    add(weight, d);
    xx_ += weight * covariance(0, 0);
    xy_ += weight * covariance(0, 1);
    xz_ += weight * covariance(0, 2);
    yy_ += weight * covariance(1, 1);
    yz_ += weight * covariance(1, 2);
    zz_ += weight * covariance(2, 2);
  }

  /// Adds moments about an origin at offset `d` from this one; exact up to rounding.
  void add(const Moments& other, const Vector3& d)
  {
    const Vector3 first = other.first_ + other.weight_ * d;
    xx_ += other.xx_;
    xy_ += other.xy_;
    xz_ += other.xz_;
    yy_ += other.yy_;
    yz_ += other.yz_;
    zz_ += other.zz_;
    add_product(d, other.first_);
    add_product(first, d);
    weight_ += other.weight_;
    first_ += first;
  }

  double weight() const { return weight_; }

  /// Returns the Gaussian with these moments about `origin`. \pre `weight() > 0`
  Gaussian gaussian(const Vector3& origin) const
  {
    const Vector3 d = first_ / weight_;
    Matrix3 second;
    second << xx_, xy_, xz_, xy_, yy_, yz_, xz_, yz_, zz_;
    return {weight_, origin + d, second / weight_ - d * d.transpose()};
  }

  /// Weight, first moments and the upper triangle of the second moments, for vectorised sums.
  using Array = Eigen::Matrix<double, 10, 1>;

  Array array() const
  {
    Array result;
    result << weight_, first_[0], first_[1], first_[2], xx_, xy_, xz_, yy_, yz_, zz_;
    return result;
  }

private:
  /// Adds the upper triangle of `a * b.transpose()`.
  void add_product(const Vector3& a, const Vector3& b)
  {
    xx_ += a[0] * b[0];
    xy_ += a[0] * b[1];
    xz_ += a[0] * b[2];
    yy_ += a[1] * b[1];
    yz_ += a[1] * b[2];
    zz_ += a[2] * b[2];
  }

  double weight_ = 0;
  Vector3 first_ = Vector3::Zero();
  double xx_ = 0, xy_ = 0, xz_ = 0, yy_ = 0, yz_ = 0, zz_ = 0;
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_MOMENTS_H
