// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CONSOLIDATION_MIXTURE_WINDOW_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CONSOLIDATION_MIXTURE_WINDOW_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Moments.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/principal_axes.h>
#include <CGAL/Point_set_skeletonization_3/internal/mixture/merge_by_cell.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/Box_tree.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Features of the mixture in a Gaussian window around a place. Linearity and sphericity are
/// eigenvalue features as in the literature on point clouds, but as ratios of neighbouring
/// eigenvalues: a window truncates long shapes, so the largest eigenvalue alone says little.
struct Local_shape
{
  Vector3 mean = Vector3::Zero();
  Vector3 normal = Vector3::UnitZ();
  Vector3 axis = Vector3::UnitX(); ///< Direction of the largest variance.
  double linearity = 0;            ///< In [0, 1]: 0 if not twice as long as wide, 1 for a line.
  double density = 0;    ///< Weight in the window over its squared radius.
  double sphericity = 1; ///< Smallest over middle variance: 0 for a plane, 1 for a ball.
  double variance = 0;   ///< Along the normal.
  double radius = 0;     ///< Of the window.
};

/// A window of this radius falls off as a normal distribution of this variance.
inline double variance_of_window(double radius) { return radius * radius / 4; }

/// Returns how much of the variance of a normal distribution is seen in a window of this radius. At
/// most that of the window. O(1).
inline double variance_seen(double variance, double radius)
{
  const double of_window = variance_of_window(radius);
  return variance * of_window / (variance + of_window);
}

/// Returns the variance of the normal distribution of which so much is seen. What is much wider
/// than the window looks like the window, and cannot be told. O(1).
inline double variance_behind(double seen, double radius)
{
  constexpr double most = 20; // times what is seen
  return seen / (std::max)(1 - seen / variance_of_window(radius), 1 / most);
}

/// Returns `exp(32 x)`, to nine digits for -1/7 <= x <= 0, in less than half the time of `exp()`: a
/// Taylor polynomial, squared five times.
inline double exponential_of_32_times(double x)
{
  double result =
    1 + x * (1 + x * (1.0 / 2 + x * (1.0 / 6 + x * (1.0 / 24 + x * (1.0 / 120 + x * (1.0 / 720 +
    x * (1.0 / 5040)))))));
  result *= result;
  result *= result;
  result *= result;
  result *= result;
  result *= result;
  return result;
}

/// A mixture with a tree over its means; copies share both.
class Mixture_tree
{
public:
  /// Refers to the components; `tree` is over their means.
  Mixture_tree(const Gaussians* components, const Box_tree& tree)
    : components_(std::shared_ptr<void>(), components), tree_(tree)
  {}

  Mixture_tree(Gaussians components, Concurrency concurrency)
    : components_(std::make_shared<Gaussians>(std::move(components))),
      tree_(means_of(*components_), concurrency)
  {}

  const Box_tree& tree() const { return tree_; }

  /// The `k`-th component in the order of the tree.
  const Gaussian& operator[](std::size_t k) const { return (*components_)[tree_.order()[k]]; }

  /// All components in that order.
  Gaussians in_order() const
  {
    Gaussians result;
    result.reserve(components_->size());
    for(std::size_t i : tree_.order())
      result.push_back((*components_)[i]);
    return result;
  }

private:
  std::shared_ptr<const Gaussians> components_;
  Box_tree tree_;
};

/// The mixture in windows of one radius around the places in a small box: the components within
/// reach are collected once.
class Window_view
{
public:
  Window_view(const Mixture_tree& components, double radius, const Eigen::AlignedBox3d& box)
    : radius_(radius), origin_(box.center())
  {
    const Box_tree& tree = components.tree();
    const Vector3 reaches = Vector3::Constant(reach * radius);
    const Eigen::AlignedBox3d wide((box.min)() - reaches, (box.max)() + reaches);
    const auto enter = [&](std::size_t node) { return tree.boxes()[node].intersects(wide); };
    std::vector<std::size_t> seen;
    tree.visit_leaves(enter, [&](std::size_t begin, std::size_t end) {
      for(std::size_t k = begin; k < end; ++k)
        if(squared_distance(box, tree.positions()[k]) < reach * reach * radius * radius)
          seen.push_back(k);
    });
    for(std::vector<double>* each : {&x_, &y_, &z_, &squared_distances_, &weights_})
      each->resize(seen.size());
    moments_.resize(seen.size());
    near_.resize(seen.size());
    for(std::size_t i = 0; i < seen.size(); ++i) {
      const Gaussian& g = components[seen[i]];
      const Vector3 d = g.mean - origin_;
      Moments moments;
      moments.add(1, d, g.covariance);
      x_[i] = d[0];
      y_[i] = d[1];
      z_[i] = d[2];
      moments_[i] = g.weight * moments.array();
    }
  }

  /// Weight in the window around `q` over its squared radius. \pre `q` is in the box
  double density(const Vector3& q) { return moments(q)[0] / (radius_ * radius_); }

  /// Features of the window around `q`. \pre `q` is in the box
  Local_shape shape(const Vector3& q)
  {
    const Moments::Array sum = moments(q);
    Local_shape fit;
    fit.mean = q;
    fit.radius = radius_;
    if(!(sum[0] > 0))
      return fit;
    const Moments::Array mean = sum / sum[0];
    const Vector3 d = mean.segment<3>(1);
    Matrix3 covariance;
    covariance << mean[4], mean[5], mean[6], mean[5], mean[7], mean[8], mean[6], mean[8], mean[9];
    covariance -= d * d.transpose();
    const auto [variance, directions] = principal_axes(covariance);
    fit.mean = origin_ + d;
    fit.normal = directions.col(0);
    fit.axis = directions.col(2);
    if(variance[2] > 0)
      fit.linearity = (std::max)(0.0, 1 - 4 * variance[1] / variance[2]);
    fit.variance = variance[0];
    fit.density = sum[0] / (radius_ * radius_);
    // A line has no normal: its sphericity stays 1. Eigenvalues in closed form are that inexact.
    if(variance[1] > 1e-6 * variance[2])
      fit.sphericity = variance[0] / variance[1];
    return fit;
  }

  static constexpr double reach = 1.5; ///< Radii; there the window has fallen to 1 %.

private:
  /// Moments of the mixture in the window around `q`, about the origin.
  Moments::Array moments(const Vector3& q)
  {
    // Four loops instead of one, so that compilers vectorise three of them.
    const Vector3 d = q - origin_;
    const std::size_t all = near_.size();
    for(std::size_t i = 0; i < all; ++i) {
      const double x = x_[i] - d[0], y = y_[i] - d[1], z = z_[i] - d[2];
      squared_distances_[i] = x * x + y * y + z * z;
    }
    const double squared_reach = reach * reach * radius_ * radius_;
    std::size_t size = 0;
    for(std::size_t i = 0; i < all; ++i) { // branchless: the result is unpredictable
      const double squared_distance = squared_distances_[i];
      weights_[size] = squared_distance;
      near_[size] = i;
      size += squared_distance < squared_reach;
    }
    const double factor = -0.5 / variance_of_window(radius_) / 32;
    for(std::size_t i = 0; i < size; ++i)
      weights_[i] = exponential_of_32_times(factor * weights_[i]);
    Moments::Array sum = Moments::Array::Zero();
    for(std::size_t i = 0; i < size; ++i)
      sum += weights_[i] * moments_[near_[i]];
    return sum;
  }

  double radius_;
  Vector3 origin_;
  std::vector<double> x_, y_, z_;       ///< Of every component, from the origin.
  std::vector<Moments::Array> moments_; ///< Of every component.
  std::vector<double> squared_distances_, weights_;
  std::vector<std::size_t> near_;
};

/// The mixture for windows of one radius, coarsened to a third of it.
class Mixture_window
{
public:
  Mixture_window(const Mixture_tree& finest, double spacing, double radius, Concurrency concurrency)
    : radius_(radius), components_(finest)
  {
    constexpr double resolution = 1.0 / 3; // radii: two dozen components in a window
    if(!(resolution * radius > spacing))
      return;
    components_ =
      Mixture_tree(merged_by_cell(finest.in_order(), resolution * radius).gaussians, concurrency);
  }

  /// The windows around the places in a box.
  Window_view around(const Eigen::AlignedBox3d& box) const { return {components_, radius_, box}; }

private:
  double radius_;
  Mixture_tree components_;
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CONSOLIDATION_MIXTURE_WINDOW_H
