// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PUBLISHED_ATTRACTION_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PUBLISHED_ATTRACTION_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Moments.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/principal_axes.h>
#include <CGAL/Point_set_skeletonization_3/internal/published/Kernel_packet.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/Box_tree.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/Packet_tree.h>

#include <Eigen/Core>

#include <boost/config.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// The attraction weight theta_h(r) / r of the L1-median (Eq. 5) as a sum of Gaussians,
/// sum_k amplitude[k] exp(-r^2 / (2 (deviation[k] h)^2)) / h, which makes Eq. 9 a closed form;
/// widest first. Fitted to the relative error over r/h in [0.01, 0.5], where it stays below 14 %;
/// the coefficients of Preiner et al. (2014) fit the absolute error and are 96 % too small at r =
/// h/2, the distance from which the far side of a limb has to pull.
struct Attraction_kernel
{
  static constexpr std::array<double, 3> amplitude{{5.470513, 18.54099, 79.73184}};
  static constexpr std::array<double, 3> deviation{{0.1558997, 0.05968915, 0.01460686}};

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

/// Returns exp(-x), of one value as it is, for the tests, and of packets without what is
/// negligible.
inline Eigen::Array<double, 1, 1> attraction_decay(const Eigen::Array<double, 1, 1>& x)
{
  return (-x).exp();
}
BOOST_FORCEINLINE Packet_values attraction_decay(const Packet_values& x)
{
  return decay(x, negligible);
}

/// One Gaussian of the kernel for several samples; `Values` is an Eigen array with a value for
/// each.
template <typename Values>
struct Kernel_term
{
  /// The `k`-th Gaussian for samples whose kernels have the squared radii h^2.
  Kernel_term(std::size_t k, const Values& squared_radius)
    : amplitude(static_cast<typename Values::Scalar>(Attraction_kernel::amplitude[k]))
  {
    const auto deviation = static_cast<typename Values::Scalar>(Attraction_kernel::deviation[k]);
    variance = deviation * deviation * squared_radius;
    inverse_variance = variance.inverse();
  }

  typename Values::Scalar amplitude;
  Values variance, inverse_variance;
};

/// A Gaussian, diagonalised once for all kernels.
template <typename Scalar>
struct Attractor
{
  using Vector = Eigen::Matrix<Scalar, 3, 1>;

  /// `place` is the mean, in the coordinates of the samples.
  Attractor(const Gaussian& g, const Vector& place)
    : weight(static_cast<Scalar>(g.weight)), mean(place)
  {
    const Principal_axes principal = principal_axes(g.covariance);
    axes = principal.directions.cast<Scalar>();
    variances = principal.variances.cast<Scalar>();
  }

  Scalar weight;
  Vector mean;
  Eigen::Matrix<Scalar, 3, 3> axes; ///< As columns.
  Vector variances;                 ///< Along the axes, ascending.
};

/// Numerator and denominator of Eq. 9 for several samples. The numerator is relative to the sample,
/// so that F1 is the sample plus (`x`, `y`, `z`) / `weight`.
template <typename Values>
struct Pull
{
  Values weight = Values::Zero();
  Values x = Values::Zero(), y = Values::Zero(), z = Values::Zero();

  /// Adds a Gaussian at d = mu - q from the samples, for one term of the kernel. With its variance
  /// v and S = Sigma + v I it has the weight
  ///   c = amplitude w v^(3/2) det(S)^(-1/2) exp(-d^T S^-1 d / 2)
  /// and pulls to q + v S^-1 d.
  void add(const Attractor<typename Values::Scalar>& a, const Values& dx, const Values& dy,
           const Values& dz, const Kernel_term<Values>& term)
  {
    const auto along = [&](int axis) {
      return Values(dx * a.axes(0, axis) + dy * a.axes(1, axis) + dz * a.axes(2, axis));
    };
    const Values u = along(0), v = along(1), w = along(2);
    // det(S) / v^3 and v S^-1, in the axes of S
    const Values in_u = 1 + a.variances[0] * term.inverse_variance,
                 in_v = 1 + a.variances[1] * term.inverse_variance,
                 in_w = 1 + a.variances[2] * term.inverse_variance;
    const Values inverse = (in_u * in_v * in_w).inverse();
    const Values to_u = u * in_v * in_w * inverse, to_v = v * in_u * in_w * inverse,
                 to_w = w * in_u * in_v * inverse;
    const Values exponent = (u * to_u + v * to_v + w * to_w) * (term.inverse_variance / 2);
    const Values c = (term.amplitude * a.weight) * inverse.sqrt() * attraction_decay(exponent);
    weight += c;
    x += c * (to_u * a.axes(0, 0) + to_v * a.axes(0, 1) + to_w * a.axes(0, 2));
    y += c * (to_u * a.axes(1, 0) + to_v * a.axes(1, 1) + to_w * a.axes(1, 2));
    z += c * (to_u * a.axes(2, 0) + to_v * a.axes(2, 1) + to_w * a.axes(2, 2));
  }
};

/// The components of a mixture for packets of samples, in single precision. Where a Gaussian of the
/// kernel is wide, components close to each other count as one, with their weight, mean and
/// covariance: the error is of third order in their distances. If these are at most sqrt(2)
/// deviations, the median is off by some 2e-4 h, 1e-3 h at most. So the number of terms hardly
/// grows with the kernel.
class Attractors
{
public:
  explicit Attractors(const Gaussians& mixture) : tree_(means_of(mixture)), packet_tree_(tree_)
  {
    for(std::size_t k = 0; k < mixture.size(); ++k)
      components_.emplace_back(mixture[tree_.order()[k]], packet_tree_.positions()[k]);
    for(std::size_t n = 0; n < tree_.nodes().size(); ++n) {
      const Box_tree::Node& node = tree_.nodes()[n];
      const Vector3 origin = tree_.boxes()[n].center();
      Moments moments;
      float largest = 0;
      for(std::size_t k = node.begin; k < node.end; ++k) {
        const Gaussian& g = mixture[tree_.order()[k]];
        moments.add(g.weight, g.mean - origin, g.covariance);
        largest = (std::max)(largest, components_[k].variances[2]);
      }
      const Gaussian sum = moments.gaussian(origin);
      groups_.push_back({Attractor<float>(sum, packet_tree_.place(sum.mean)), largest,
                         packet_tree_.boxes()[n].diagonal().squaredNorm()});
    }
  }

  /// Returns F1 of Eq. 9 minus the sample for each sample: the way to the local L1-median of the
  /// mixture; 0 where no component is near. Fast if consecutive samples are close.
  std::vector<Vector3> attraction(const Kernels& samples, Concurrency concurrency) const
  {
    std::vector<Vector3> result(samples.size());
    for_each_packet(concurrency, samples.size(), [&](std::size_t first, std::size_t end) {
      const Kernel_packet packet(packet_tree_, samples, first, end);
      Pull<Packet_values> sum;
      for(std::size_t k = 0; k < Attraction_kernel::amplitude.size(); ++k)
        add_term(packet.places, Kernel_term<Packet_values>(k, packet.squared_radius), sum);
      for(std::size_t i = first; i < end; ++i) {
        const std::size_t lane = i - first;
        const Vector3 offset(sum.x[lane], sum.y[lane], sum.z[lane]);
        result[i] = sum.weight[lane] > 0 ? Vector3(offset / sum.weight[lane]) : Vector3::Zero();
      }
    });
    return result;
  }

private:
  /// The components of a node of the tree.
  struct Group
  {
    Attractor<float> sum;
    float largest_variance;  ///< Of a component.
    float squared_diagonal;  ///< Of the box of their means.
  };

  void add_term(const Packet_vectors& places, const Kernel_term<Packet_values>& term,
                Pull<Packet_values>& sum) const
  {
    const auto add = [&](const Attractor<float>& a) {
      const Packet_vectors d = places.to(a.mean);
      sum.add(a, d.x, d.y, d.z, term);
    };
    const float widest_group = 2 * term.variance.minCoeff();
    const std::vector<Box_tree::Node>& nodes = tree_.nodes();
    for(std::size_t n = 0; n < nodes.size();) {
      const Group& group = groups_[n];
      const Packet_values squared_reach =
        2 * negligible * (term.variance + group.largest_variance);
      const bool is_near = places.is_any_closer(packet_tree_.boxes()[n], squared_reach);
      const bool is_one = group.squared_diagonal <= widest_group;
      if(is_near && is_one)
        add(group.sum);
      else if(is_near && tree_.is_leaf(n))
        for(std::size_t k = nodes[n].begin; k < nodes[n].end; ++k)
          add(components_[k]);
      n = is_near && !is_one ? n + 1 : nodes[n].after;
    }
  }

  Box_tree tree_;
  Packet_tree packet_tree_;
  std::vector<Attractor<float>> components_; ///< In the order of the tree.
  std::vector<Group> groups_;                ///< Of each node of the tree.
};

/// Returns F1 for points instead of Gaussians (Eq. 3 and 5): the reference for the closed form.
/// `weights` are 1 or 1/density (Eq. 7). A point at `q` itself has infinite weight in Eq. 5; it
/// counts as if it were 0.01 h away, the lower end of the range of the kernel. O(n).
inline Vector3 attraction_to_points(const Vector3& q, double h, const std::vector<Vector3>& points,
                                    const std::vector<double>& weights)
{
  Vector3 sum = Vector3::Zero();
  double weight = 0;
  for(std::size_t j = 0; j < points.size(); ++j) {
    const double r = (std::max)((points[j] - q).norm(), 0.01 * h);
    const double alpha = weights[j] * theta(r * r, h) / r;
    sum += alpha * points[j];
    weight += alpha;
  }
  return weight > 0 ? Vector3(sum / weight) : q;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PUBLISHED_ATTRACTION_H
