// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_CONSOLIDATION_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_CONSOLIDATION_H

#include <CGAL/Point_set_skeletonization_3/internal/Box_tree.h>
#include <CGAL/Point_set_skeletonization_3/internal/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/Neighbor_search.h>
#include <CGAL/Point_set_skeletonization_3/internal/grid_cells.h>
#include <CGAL/Point_set_skeletonization_3/internal/parallel_for.h>
#include <CGAL/Point_set_skeletonization_3/internal/quantile.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// What a Gaussian window on the mixture shows around a place.
struct Local_fit
{
  Vector3 mean = Vector3::Zero();
  Vector3 normal = Vector3::UnitZ();
  Vector3 axis = Vector3::UnitX(); ///< Of the largest variance.
  double elongation = 0;           ///< In [0, 1]: 0 not twice as long as wide, 1 a line.
  double density = 0;   ///< Weight in the window over its area.
  double roughness = 1; ///< The smallest principal variance over the next: 0 a plane, 1 a blob.
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

/// A mixture with a tree over it, in whose order it is.
struct Mixture_tree
{
  explicit Mixture_tree(const Gaussians& components)
    : tree(components.size(), [&](std::size_t i) { return components[i].mean; })
  {
    mixture.reserve(components.size());
    for(std::size_t i : tree.order())
      mixture.push_back(components[i]);
  }

  Box_tree tree;
  Gaussians mixture;
};

/// The mixture seen through windows of one size, at a resolution that fits.
class Mixture_window
{
public:
  Mixture_window(std::shared_ptr<const Mixture_tree> finest, double spacing, double radius)
    : radius_(radius), components_(std::move(finest))
  {
    constexpr double resolution = 1.0 / 3; // of the radius: two dozen components in a window
    if(resolution * radius > spacing)
      components_ = std::make_shared<Mixture_tree>(
        coarsened(components_->mixture, resolution * radius));
  }

  double radius() const { return radius_; }

  /// Weight in the window around a place over its area.
  double density(const Vector3& q) const
  {
    double sum = 0;
    visit(q, [&](double weight, const Gaussian&) { sum += weight; });
    return sum / (radius_ * radius_);
  }

  Local_fit operator()(const Vector3& q) const
  {
    Moments moments(q);
    visit(q, [&](double weight, const Gaussian& g) { moments.add(weight, g); });
    Local_fit fit;
    fit.mean = q;
    if(!(moments.weight() > 0))
      return fit;
    const Gaussian window = moments.gaussian();
    Eigen::SelfAdjointEigenSolver<Matrix3> solver;
    solver.computeDirect(window.covariance);
    const Vector3 variance = solver.eigenvalues().cwiseMax(0);
    fit.mean = window.mean;
    fit.normal = solver.eigenvectors().col(0);
    fit.axis = solver.eigenvectors().col(2);
    if(variance[2] > 0)
      fit.elongation = std::max(0.0, 1 - 4 * variance[1] / variance[2]);
    fit.thickness = std::sqrt(variance[0]);
    fit.density = moments.weight() / (radius_ * radius_);
    // A line, to rounding, is as rough as a blob: it has no normal.
    if(variance[1] > 1e-10 * variance[2])
      fit.roughness = variance[0] / variance[1];
    return fit;
  }

private:
  /// Calls `visit(weight, component)` for those in the window, with their weight in it.
  template <typename Visit>
  void visit(const Vector3& q, const Visit& visit) const
  {
    constexpr double reach = 1.5; // where the window has fallen to 1 %
    constexpr std::size_t most = 64; // at a time: the exponentials of many are cheaper
    Eigen::Array<double, most, 1> weights; // squared distances at first
    std::array<const Gaussian*, most> seen;
    std::size_t size = 0;
    const auto visit_seen = [&] {
      auto known = weights.head(static_cast<Eigen::Index>(size));
      known *= -2 / (radius_ * radius_) / 32;
      known = exponential_of_32_times(known);
      for(std::size_t i = 0; i < size; ++i)
        visit(known[static_cast<Eigen::Index>(i)] * seen[i]->weight, *seen[i]);
      size = 0;
    };
    const double squared_reach = reach * reach * radius_ * radius_;
    const Box_tree& tree = components_->tree;
    tree.visit_leaves_within(q, reach * radius_, [&](std::size_t begin, std::size_t end) {
      if(size + Box_tree::leaf_size > most)
        visit_seen();
      for(std::size_t k = begin; k < end; ++k) { // without a branch, which nobody could predict
        const double squared_distance = (tree.positions()[k] - q).squaredNorm();
        weights[static_cast<Eigen::Index>(size)] = squared_distance;
        seen[size] = &components_->mixture[k];
        size += squared_distance < squared_reach;
      }
    });
    visit_seen();
  }

  double radius_;
  std::shared_ptr<const Mixture_tree> components_;
};

/// Where the components of a mixture lie once the noise is taken off.
struct Consolidated_surface
{
  std::vector<Vector3> positions;
  std::vector<bool> outlier;
  double noise = 0; ///< In [0, 1]: how much was to be taken off.
};

/// Takes the noise off a mixture: moves its components to the surface that they scatter around.
///
/// The window that this takes has to be wider than the noise and narrower than the limbs. Noise makes
/// small windows rough, curvature and neighbouring sheets make large ones rough; so it is the first
/// of a row of sizes whose roughness is small, or grows with the next size. What counts is the first
/// quartile over the shape: noise is everywhere, and nearly every shape is smooth for a quarter.
/// A component moves to the plane fitted in its window, or in a narrower one where that shows a limb
/// all around; in a twig as thin as the noise across it to the mean, as mean shift does (Comaniciu &
/// Meer 2002). Without noise nothing moves.
template <typename ConcurrencyTag>
class Surface_consolidation
{
public:
  /// Refers to the mixture and to the `neighborhoods()` of its components, of nine or more.
  Surface_consolidation(const Gaussians& mixture, const Neighborhoods& nearest)
    : mixture_(mixture), nearest_(nearest), spacings_(spacings()),
      spacing_(std::max(quantile(spacings_, 0.5), std::numeric_limits<double>::min()))
  {
    for(const Gaussian& g : mixture)
      result_.positions.push_back(g.mean);
    result_.outlier.assign(mixture.size(), false);
  }

  Consolidated_surface operator()()
  {
    drop_isolated();
    measure_noise();
    result_.noise = strength_;
    constexpr int passes = 4; // the first halves the noise, the last finds nothing to do
    for(int pass = 0; pass < passes; ++pass) {
      if(strength_ > 0)
        move();
      else
        measure_densities(pass == 0);
      if(!drop_thin() && !(strength_ > 0)) // nothing has changed
        break;
    }
    return result_;
  }

private:
  /// Distance of every component to its fourth neighbour.
  std::vector<double> spacings() const
  {
    std::vector<double> result;
    for(const auto& nearest : nearest_) {
      const std::size_t fourth = std::min<std::size_t>(4, nearest.size() - 1);
      result.push_back(std::sqrt(nearest[fourth].squared_distance));
    }
    return result;
  }

  /// Components whose neighbours are far away are outliers: density falls by the square root of 8
  /// in spacing over a badly sampled shape, and outliers are spread in space, not on a surface.
  void drop_isolated()
  {
    constexpr double isolated = 3;
    for(std::size_t i = 0; i < mixture_.size(); ++i)
      result_.outlier[i] = spacings_[i] > isolated * spacing_;
  }

  static constexpr std::size_t sizes = 6;

  /// Radius of a window size: from two spacings, the narrowest with a plane in it, by steps of 1.4.
  double radius(std::size_t size) const
  {
    return 2 * spacing_ * std::pow(1.4, static_cast<double>(size));
  }

  /// What is left of the mixture, where it is now.
  const std::shared_ptr<const Mixture_tree>& finest()
  {
    if(finest_)
      return finest_;
    Gaussians kept;
    kept.reserve(mixture_.size());
    kept_.clear();
    for(std::size_t i = 0; i < mixture_.size(); ++i)
      if(!result_.outlier[i]) {
        kept.push_back({mixture_[i].weight, result_.positions[i], mixture_[i].covariance});
        kept_.push_back(i);
      }
    finest_ = std::make_shared<Mixture_tree>(kept);
    return finest_;
  }

  const Mixture_window& window(std::size_t size)
  {
    if(!windows_[size])
      windows_[size] = std::make_unique<Mixture_window>(finest(), spacing_, radius(size));
    return *windows_[size];
  }

  /// To be called when components have moved or been dropped.
  void forget_windows()
  {
    finest_ = nullptr;
    windows_ = {};
  }

  /// Chooses the size of the window and how much the components move, from nothing to all the way.
  void measure_noise()
  {
    constexpr double smooth = 0.15;  // noise of a fifth of the window's radius
    constexpr std::size_t every = 7; // some hundreds are enough
    double least = std::numeric_limits<double>::infinity();
    for(std::size_t size = 0; size < sizes; ++size) {
      const Mixture_window& view = window(size);
      std::vector<double> roughness((mixture_.size() + every - 1) / every);
      std::vector<double> thickness(roughness.size());
      parallel_for<ConcurrencyTag>(roughness.size(), [&](std::size_t k) {
        const Local_fit fit = view(result_.positions[k * every]);
        roughness[k] = fit.roughness;
        thickness[k] = fit.thickness;
      });
      const double quartile = quantile(roughness, 0.25);
      // Uneven sampling alone measures up to 0.03, noise of a quarter of the spacing 0.05 and more.
      // So much noise that it fills a volume evenly has no scatter, but nothing is smooth.
      if(size == 0)
        strength_ = std::min(1.0, std::max({0.0, (scatter(view) - 0.03) / 0.03,
                                            (quartile - 0.3) / 0.2}));
      if(quartile > least)
        return;
      size_ = size;
      noise_ = quantile(thickness, 0.25);
      least = quartile;
      if(quartile < smooth)
        return;
    }
  }

  /// How far components lie off the surface through their neighbours, in the median over the shape,
  /// in radii of the window. On a curved surface all lie off their fitted plane, and by the same; only
  /// the difference from the neighbours is noise.
  double scatter(const Mixture_window& view)
  {
    const std::size_t n = mixture_.size();
    std::vector<Vector3> offset(n), normal(n);
    density_.resize(n);
    parallel_for<ConcurrencyTag>(n, [&](std::size_t i) {
      const Local_fit fit = view(result_.positions[i]);
      offset[i] = fit.mean - result_.positions[i];
      normal[i] = fit.normal;
      density_[i] = fit.density;
    });
    std::vector<double> off(n);
    parallel_for<ConcurrencyTag>(n, [&](std::size_t i) {
      const auto& nearest = nearest_[i]; // nothing has moved yet
      const std::size_t size = std::min<std::size_t>(9, nearest.size());
      Vector3 mean = Vector3::Zero();
      for(std::size_t k = 0; k < size; ++k)
        mean += offset[nearest[k].index] / static_cast<double>(size);
      off[i] = std::abs(normal[i].dot(offset[i] - mean)) / view.radius();
    });
    return quantile(off, 0.5);
  }

  /// The window for a component: where the points are sparse it has to be wider to show anything.
  std::size_t size_for(std::size_t i) const
  {
    std::size_t size = size_;
    while(size + 1 < sizes && radius(size) < 1.6 * spacings_[i])
      ++size;
    return size;
  }

  /// How far a limb that a window shows all around is drowned in the noise, in [0, 1]. Its radius is
  /// that of the noise where the thickness is 1.2 of that of the noise, twice that where it is 1.7.
  double drowned(const Local_fit& fit) const
  {
    return std::min(1.0, std::max(0.0, 2 * (1.65 - fit.thickness / noise_)));
  }

  /// What a component sees through its window. Where that shows a limb all around, narrower ones are
  /// tried, as long as they show something flatter.
  Local_fit fit_through(std::size_t size, const Vector3& position) const
  {
    constexpr double round = 0.2; // roughness
    Local_fit fit = (*windows_[size])(position);
    while(size-- > 0 && fit.roughness > round && drowned(fit) < 0.5) {
      const Local_fit narrower = (*windows_[size])(position);
      if(narrower.roughness > fit.roughness)
        break;
      const double density = fit.density; // of windows of one size only, they are compared
      fit = narrower;
      fit.density = density;
    }
    return fit;
  }

  /// The size of the window for every component that is left. Makes them, and all narrower ones.
  std::vector<std::size_t> window_sizes()
  {
    std::vector<std::size_t> result(mixture_.size(), 0);
    for(std::size_t i = 0; i < mixture_.size(); ++i)
      if(!result_.outlier[i])
        result[i] = size_for(i);
    for(std::size_t size = 0; size <= *std::max_element(result.begin(), result.end()); ++size)
      window(size);
    return result;
  }

  /// Without noise this is all there is to do. At first `scatter()` has done it in the narrowest.
  void measure_densities(bool narrowest_known)
  {
    const std::vector<std::size_t> size = window_sizes();
    parallel_for<ConcurrencyTag>(mixture_.size(), [&](std::size_t i) {
      if(result_.outlier[i])
        density_[i] = 0;
      else if(!narrowest_known || size[i] > 0)
        density_[i] = windows_[size[i]]->density(result_.positions[i]);
    });
  }

  void move()
  {
    const std::vector<std::size_t> size = window_sizes();
    density_.assign(mixture_.size(), 0);
    parallel_for<ConcurrencyTag>(mixture_.size(), [&](std::size_t i) {
      if(result_.outlier[i])
        return;
      Vector3& position = result_.positions[i]; // the windows keep the ones before
      const Local_fit fit = fit_through(size[i], position);
      density_[i] = fit.density;
      const double blob = std::min(1.0, std::max(0.0, (fit.roughness - 0.1) / 0.2));
      const Vector3 step = fit.mean - position;
      // Along a twig nothing moves, or its points would gather in lumps.
      const Vector3 across = step - fit.elongation * fit.axis.dot(step) * fit.axis;
      position += strength_ * ((1 - blob) * fit.normal.dot(step) * fit.normal +
                               blob * drowned(fit) * across);
    });
    forget_windows();
  }

  /// A thin cloud beside a dense surface is the tail of its noise. False if there is none.
  bool drop_thin()
  {
    constexpr double apart = 1.5;
    constexpr double thin = 0.3; // Gaussian noise at 1.6 standard deviations
    const Box_tree& tree = finest()->tree;
    std::vector<double> densities; // in the order of the tree
    for(std::size_t k : tree.order())
      densities.push_back(density_[kept_[k]]);
    const double least = thin * *std::max_element(density_.begin(), density_.end());
    std::vector<char> drop(mixture_.size(), 0);
    parallel_for<ConcurrencyTag>(mixture_.size(), [&](std::size_t i) {
      if(result_.outlier[i] || density_[i] >= least) // beside anything it is thick
        return;
      // What lies apart from the others is compared with the surface further away.
      const double reach = spacings_[i] > apart * spacing_ ? 1.5 : 1;
      double densest = 0;
      tree.visit_within(result_.positions[i], reach * radius(size_),
                        [&](std::size_t k, double) { densest = std::max(densest, densities[k]); });
      drop[i] = density_[i] < thin * densest;
    });
    bool any = false;
    for(std::size_t i = 0; i < mixture_.size(); ++i)
      if(drop[i])
        any = result_.outlier[i] = true;
    if(any)
      forget_windows();
    return any;
  }

  const Gaussians& mixture_;
  const Neighborhoods& nearest_;
  std::vector<double> spacings_;
  double spacing_;
  std::vector<double> density_;
  std::size_t size_ = 0;
  double strength_ = 0;
  std::vector<std::size_t> kept_; ///< The components of `finest_`, before it was sorted.
  std::shared_ptr<const Mixture_tree> finest_;
  std::array<std::unique_ptr<Mixture_window>, sizes> windows_;
  double noise_ = 0; ///< Thickness of the noisy surface: one standard deviation.
  Consolidated_surface result_;
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_CONSOLIDATION_H
