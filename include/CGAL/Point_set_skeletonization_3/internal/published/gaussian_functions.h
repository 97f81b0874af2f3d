// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PUBLISHED_GAUSSIAN_FUNCTIONS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PUBLISHED_GAUSSIAN_FUNCTIONS_H


#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/principal_axes.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/sort_polled.h>

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Order of points by x, then y, then z.
inline bool lexicographically_less(const Vector3& a, const Vector3& b)
{
  return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
}

/// Returns the indices of points in lexicographic order of these. O(n log n).
inline std::vector<std::size_t> lexicographic_order(const std::vector<Vector3>& points)
{
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  sort_polled(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return lexicographically_less(points[a], points[b]);
  });
  return order;
}

/// A total order of Gaussians: by mean, weight, covariance. Equivalent Gaussians have the same bits
/// up to the sign of zero, so a sorted mixture does not depend on its order before.
inline bool lexicographically_less(const Gaussian& a, const Gaussian& b)
{
  if(a.mean != b.mean)
    return lexicographically_less(a.mean, b.mean);
  if(a.weight != b.weight)
    return a.weight < b.weight;
  return std::lexicographical_compare(a.covariance.data(), a.covariance.data() + 9,
                                      b.covariance.data(), b.covariance.data() + 9);
}

/// Returns `covariance` plus `fraction` of its mean variance in every direction, which bounds the
/// condition number by `1 + 3 / fraction`. If it is zero up to rounding, a standard deviation of
/// 10^-6 bounding box diagonals, below any spacing.
inline Matrix3 regularized(const Matrix3& covariance, double fraction)
{
  constexpr double pointlike_variance = 1e-12;
  const double variance = covariance.trace() / 3;
  // An extent below 10^-12 diagonals is rounding of the coordinates.
  const double added = variance > 1e-24 ? fraction * variance : pointlike_variance;
  return covariance + added * Matrix3::Identity();
}

/// The inverse and the determinant of a covariance, computed once for all evaluations.
class Precision
{
public:
  /// \pre `covariance` is positive semidefinite
  explicit Precision(const Matrix3& covariance)
  {
    // Negligible for a well-conditioned covariance; repairs one whose smallest eigenvalue was lost
    // to rounding.
    constexpr double rounding = 1e-9;
    const Eigen::LLT<Matrix3> factor(regularized(covariance, rounding));
    inverse_ = factor.solve(Matrix3::Identity());
    log_determinant_ = 2 * factor.matrixLLT().diagonal().array().log().sum();
  }

  const Matrix3& inverse() const { return inverse_; }
  double log_determinant() const { return log_determinant_; }

  /// Squared Mahalanobis length of a difference of positions.
  double squared_length(const Vector3& d) const { return d.dot(inverse_ * d); }

private:
  Matrix3 inverse_;
  double log_determinant_;
};

/// tr(A B) of symmetric matrices.
inline double trace_of_product(const Matrix3& a, const Matrix3& b)
{
  return a.cwiseProduct(b).sum();
}

/// Standard deviation along the longest axis.
inline double largest_deviation(const Matrix3& covariance)
{
  return std::sqrt(principal_axes(covariance).variances[2]);
}

/// The squares of the distances d_M: the smaller of the two Mahalanobis distances of the means of a
/// pair. Evaluated on demand, which costs about as much as reading a large matrix.
class Squared_mahalanobis_distances
{
public:
  explicit Squared_mahalanobis_distances(const Gaussians& mixture) : mixture_(mixture)
  {
    precisions_.reserve(mixture.size());
    for(const Gaussian& g : mixture)
      precisions_.emplace_back(g.covariance);
  }

  double operator()(std::size_t i, std::size_t j) const
  {
    const Vector3 d = mixture_[i].mean - mixture_[j].mean;
    return (std::min)(precisions_[i].squared_length(d), precisions_[j].squared_length(d));
  }

private:
  const Gaussians& mixture_;
  std::vector<Precision> precisions_;
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PUBLISHED_GAUSSIAN_FUNCTIONS_H
