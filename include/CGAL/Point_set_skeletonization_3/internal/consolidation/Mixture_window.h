// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CONSOLIDATION_MIXTURE_WINDOW_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CONSOLIDATION_MIXTURE_WINDOW_H

#include <CGAL/Point_set_skeletonization_3/internal/spatial/Box_tree.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/mixture/merge_by_cell.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/patches.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// What a Gaussian window on the mixture shows around a place.
struct Local_shape
{
  Vector3 mean = Vector3::Zero();
  Vector3 normal = Vector3::UnitZ();
  Vector3 axis = Vector3::UnitX(); ///< Of the largest variance.
  double linearity = 0;           ///< In [0, 1]: 0 not twice as long as wide, 1 a line.
  double density = 0;   ///< Weight in the window over its area.
  double sphericity = 1; ///< The smallest principal variance over the next: 0 a plane, 1 a blob.
  double thickness = 0; ///< Square root of the smallest principal variance.
};

/// `exp(32 x)` of every element, to nine digits for -1/7 <= x <= 0, in less than half the time of
/// `exp()`: its Taylor polynomial at x, squared five times. Refers to the argument.
template <typename Array>
auto exponential_of_32_times(const Array& x)
{
  const auto polynomial =
    1 + x * (1 + x * (1.0 / 2 + x * (1.0 / 6 + x * (1.0 / 24 + x * (1.0 / 120 + x * (1.0 / 720 +
    x * (1.0 / 5040)))))));
  return polynomial.square().square().square().square().square();
}

/// A mixture with the tree over its means; copies share both.
class Mixture_tree
{
public:
  /// Of components and a tree that stay.
  Mixture_tree(const Gaussians* components, const Box_tree* tree_of_means)
    : components_(std::shared_ptr<void>(), components), tree_(std::shared_ptr<void>(), tree_of_means)
  {}

  template <typename ConcurrencyTag>
  Mixture_tree(Gaussians components, ConcurrencyTag)
    : components_(std::make_shared<Gaussians>(std::move(components))),
      tree_(std::make_shared<Box_tree>(tree_of_means<ConcurrencyTag>(*components_)))
  {}

  const Box_tree& tree() const { return *tree_; }

  /// The `k`-th in the order of the tree.
  const Gaussian& operator[](std::size_t k) const { return (*components_)[tree_->order()[k]]; }

  /// All in that order.
  Gaussians in_order() const
  {
    Gaussians result;
    result.reserve(components_->size());
    for(std::size_t i : tree_->order())
      result.push_back((*components_)[i]);
    return result;
  }

private:
  std::shared_ptr<const Gaussians> components_;
  std::shared_ptr<const Box_tree> tree_;
};

/// The mixture seen through windows of one size around the points of a small box: what they may see
/// is looked for once.
class Window_view
{
public:
  Window_view(const Mixture_tree& components, double radius, const Box& box)
    : radius_(radius), origin_((box.lower + box.upper) / 2)
  {
    const Box_tree& tree = components.tree();
    const Box wide{box.lower.array() - reach * radius, box.upper.array() + reach * radius};
    const auto enter = [&](std::size_t node) {
      return (tree.boxes()[node].lower.array() < wide.upper.array()).all() &&
             (tree.boxes()[node].upper.array() > wide.lower.array()).all();
    };
    std::vector<std::size_t> seen;
    tree.visit_leaves(enter, [&](std::size_t begin, std::size_t end) {
      for(std::size_t k = begin; k < end; ++k)
        if(box.squared_distance(tree.positions()[k]) < reach * reach * radius * radius)
          seen.push_back(k);
    });
    const auto size = static_cast<Eigen::Index>(seen.size());
    offsets_.resize(size, 3);
    moments_.resize(10, size);
    for(Eigen::Index i = 0; i < size; ++i) {
      const Gaussian& g = components[seen[static_cast<std::size_t>(i)]];
      const Vector3 d = g.mean - origin_;
      Symmetric_sum second;
      second.add_product(d, d);
      second.add(1, g.covariance);
      const std::array<double, 10> moments = {1,         d[0],      d[1],      d[2],      second.xx,
                                              second.xy, second.xz, second.yy, second.yz, second.zz};
      offsets_.row(i) = d.transpose();
      moments_.col(i) = g.weight * Eigen::Map<const Moment_vector>(moments.data());
    }
    squared_distances_.resize(size);
    weights_.resize(size);
    near_.resize(size);
  }

  /// Weight in the window around a place over its area.
  double density(const Vector3& q) { return moments(q)[0] / (radius_ * radius_); }

  Local_shape operator()(const Vector3& q)
  {
    const Moment_vector sum = moments(q);
    Local_shape fit;
    fit.mean = q;
    if(!(sum[0] > 0))
      return fit;
    const Moment_vector mean = sum / sum[0];
    const Vector3 d = mean.segment<3>(1);
    Matrix3 covariance;
    covariance << mean[4], mean[5], mean[6], mean[5], mean[7], mean[8], mean[6], mean[8], mean[9];
    covariance -= d * d.transpose();
    Eigen::SelfAdjointEigenSolver<Matrix3> solver;
    solver.computeDirect(covariance);
    const Vector3 variance = solver.eigenvalues().cwiseMax(0);
    fit.mean = origin_ + d;
    fit.normal = solver.eigenvectors().col(0);
    fit.axis = solver.eigenvectors().col(2);
    if(variance[2] > 0)
      fit.linearity = std::max(0.0, 1 - 4 * variance[1] / variance[2]);
    fit.thickness = std::sqrt(variance[0]);
    fit.density = sum[0] / (radius_ * radius_);
    // A line, to rounding, is as rough as a blob: it has no normal.
    if(variance[1] > 1e-10 * variance[2])
      fit.sphericity = variance[0] / variance[1];
    return fit;
  }

  static constexpr double reach = 1.5; ///< In radii: where the window has fallen to 1 %.

private:
  /// Weight, first moments, and the upper triangle of the second ones, about the origin.
  using Moment_vector = Eigen::Matrix<double, 10, 1>;

  /// Those of what is in the window around a place.
  Moment_vector moments(const Vector3& q)
  {
    const Vector3 d = q - origin_;
    squared_distances_ = (offsets_.col(0) - d[0]).square() + (offsets_.col(1) - d[1]).square() +
                         (offsets_.col(2) - d[2]).square();
    const double squared_reach = reach * reach * radius_ * radius_;
    const Eigen::Index all = near_.size();
    Eigen::Index size = 0;
    for(Eigen::Index i = 0; i < all; ++i) { // without a branch, which nobody could predict
      const double squared_distance = squared_distances_[i];
      weights_[size] = squared_distance;
      near_[size] = i;
      size += squared_distance < squared_reach;
    }
    auto weights = weights_.head(size);
    weights *= -2 / (radius_ * radius_) / 32;
    weights = exponential_of_32_times(weights);
    Moment_vector sum = Moment_vector::Zero();
    for(Eigen::Index i = 0; i < size; ++i)
      sum += weights[i] * moments_.col(near_[i]);
    return sum;
  }

  double radius_;
  Vector3 origin_;
  Eigen::ArrayX3d offsets_;                           ///< From the origin.
  Eigen::Matrix<double, 10, Eigen::Dynamic> moments_; ///< Of every component.
  Eigen::ArrayXd squared_distances_, weights_;
  Eigen::Array<Eigen::Index, Eigen::Dynamic, 1> near_;
};

/// The mixture for windows of one size, at a resolution that fits.
class Mixture_window
{
public:
  template <typename ConcurrencyTag>
  Mixture_window(const Mixture_tree& finest, double spacing, double radius,
                 ConcurrencyTag)
    : radius_(radius), components_(finest)
  {
    constexpr double resolution = 1.0 / 3; // of the radius: two dozen components in a window
    if(!(resolution * radius > spacing))
      return;
    components_ = Mixture_tree(coarsened(finest.in_order(), resolution * radius), ConcurrencyTag());
  }

  Window_view around(const Box& box) const { return {components_, radius_, box}; }

private:
  double radius_;
  Mixture_tree components_;
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CONSOLIDATION_MIXTURE_WINDOW_H
