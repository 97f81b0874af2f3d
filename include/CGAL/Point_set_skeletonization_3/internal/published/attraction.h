// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PUBLISHED_ATTRACTION_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PUBLISHED_ATTRACTION_H


#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/principal_axes.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Returns theta_h(r) = exp(-16 r^2 / h^2), a weight with support radius h.
inline double theta(double squared_distance, double h)
{
  return std::exp(-16 * squared_distance / (h * h));
}

/// The attraction weight theta_h(r) / r of the L1-median (Eq. 5) as a sum of Gaussians,
/// sum_k amplitude[k] exp(-r^2 / (2 (deviation[k] h)^2)) / h, which makes Eq. 9 a closed form.
/// Fitted to the relative error over r/h in [0.01, 0.5], where it stays below 14 %; the
/// coefficients of Preiner et al. (2014) fit the absolute error and are 96 % too small at r = h/2,
/// the distance from which the far side of a limb has to pull.
struct Attraction_kernel
{
  static constexpr std::array<double, 3> amplitude{{79.73184, 18.54099, 5.470513}};
  static constexpr std::array<double, 3> deviation{{0.01460686, 0.05968915, 0.1558997}};

  /// Its value at distance r, for the tests: approximates theta(r^2, h) / r.
  static double value(double r, double h)
  {
    double sum = 0;
    for(std::size_t k = 0; k < amplitude.size(); ++k) {
      const double x = r / (deviation[k] * h);
      sum += amplitude[k] * std::exp(-x * x / 2) / h;
    }
    return sum;
  }
};

/// A weighted sum of positions and the sum of weights: numerator and denominator of a local median.
struct Pull
{
  Vector3 weighted_position = Vector3::Zero();
  double weight = 0;
};

/// A mixture component, diagonalised once for all kernels.
class Attractor
{
public:
  explicit Attractor(const Gaussian& g) : weight_(g.weight), mean_(g.mean)
  {
    const Principal_axes axes = principal_axes(g.covariance);
    axes_ = axes.directions;
    variance_ = axes.variances;
  }

  const Vector3& mean() const { return mean_; }
  double weight() const { return weight_; }
  double largest_variance() const { return variance_[2]; }

  /// Returns the term of this component in the closed form of Eq. 9, for a sample at `q` with
  /// kernel radius `h`. O(1).
  Pull pull(const Vector3& q, double h) const
  {
    const Vector3 y = axes_.transpose() * (q - mean_);
    Pull result;
    Vector3 offset = Vector3::Zero(); // of the pull from the mean, in the component's axes
    for(std::size_t k = 0; k < Attraction_kernel::amplitude.size(); ++k) {
      const double deviation = Attraction_kernel::deviation[k] * h;
      const double v = deviation * deviation;
      const Vector3 inverse = (variance_.array() + v).inverse();
      const double exponent = y.cwiseAbs2().dot(inverse);
      const double c = Attraction_kernel::amplitude[k] *
                       std::sqrt(v * v * v * inverse.prod()) * std::exp(-exponent / 2);
      result.weight += c;
      offset += c * variance_.cwiseProduct(inverse).cwiseProduct(y);
    }
    result.weighted_position = weight_ * (result.weight * mean_ + axes_ * offset);
    result.weight *= weight_;
    return result;
  }

private:
  double weight_;
  Vector3 mean_;
  Matrix3 axes_;
  Vector3 variance_;
};

/// Returns F1 for points instead of Gaussians (Eq. 3 and 5): the reference for the closed form.
/// `weights` are 1 or 1/density (Eq. 7). A point at `q` itself has infinite weight in Eq. 5; it
/// counts as if it were 0.01 h away, the lower end of the range of the kernel. O(n).
inline Vector3 attraction_to_points(const Vector3& q, double h, const std::vector<Vector3>& points,
                                    const std::vector<double>& weights)
{
  Pull pull;
  for(std::size_t j = 0; j < points.size(); ++j) {
    const double r = std::max((points[j] - q).norm(), 0.01 * h);
    const double alpha = weights[j] * theta(r * r, h) / r;
    pull.weighted_position += alpha * points[j];
    pull.weight += alpha;
  }
  return pull.weight > 0 ? Vector3(pull.weighted_position / pull.weight) : q;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PUBLISHED_ATTRACTION_H
