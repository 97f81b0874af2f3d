// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CONSOLIDATION_CONSOLIDATE_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CONSOLIDATION_CONSOLIDATE_H

#include <CGAL/Point_set_skeletonization_3/internal/spatial/Box_tree.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/consolidation/Mixture_window.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/K_nearest_neighbors.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/patches.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel_for.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/quantile.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Where the components of a mixture lie once the noise is taken off.
struct Consolidated_surface
{
  std::vector<Vector3> positions;
  std::vector<bool> outlier;
  double noise = 0; ///< In [0, 1]: how much was to be taken off.
  Box_tree tree;    ///< If that is 0, over the positions of those that are no outliers.
};

/// Takes the noise off a mixture: moves its components to the surface that they scatter around.
///
/// The window that this takes has to be wider than the noise and narrower than the limbs. Noise makes
/// small windows rough, curvature and neighbouring sheets make large ones rough; so it is the first
/// of a row of sizes whose sphericity is small, or grows with the next size. What counts is the first
/// quartile over the shape: noise is everywhere, and nearly every shape is smooth for a quarter.
/// A component moves to the plane fitted in its window, or in a narrower one where that shows a limb
/// all around; in a twig as thin as the noise across it to the mean, as mean shift does (Comaniciu &
/// Meer 2002). Without noise nothing moves.
template <typename ConcurrencyTag>
class Surface_consolidation
{
public:
  /// Refers to the mixture, to the tree over its means and to their `neighborhoods()`, of nine or more.
  Surface_consolidation(const Gaussians& mixture, const Box_tree& tree, const K_nearest_neighbors& nearest)
    : mixture_(mixture), tree_(&tree), nearest_(nearest), spacings_(spacings()),
      spacing_(std::max(quantile(spacings_, 0.5), std::numeric_limits<double>::min())),
      radii_(radii())
  {
    for(const Gaussian& g : mixture)
      result_.positions.push_back(g.mean);
    result_.outlier.assign(mixture.size(), false);
  }

  /// To be called once.
  Consolidated_surface operator()()
  {
    drop_isolated();
    measure_noise();
    result_.noise = strength_;
    if(strength_ > 0)
      take_noise_off();
    else {
      drop_all_thin();
      result_.tree = finest().tree();
    }
    return std::move(result_);
  }

private:
  static constexpr int most_passes = 4; // the first halves the noise, the last finds nothing to do

  void take_noise_off()
  {
    // If all passes together are half a step, a window shows the same in each of them.
    constexpr double little = 0.5;
    const int passes = most_passes * strength_ < little ? 1 : most_passes;
    for(int pass = 0; pass < passes; ++pass) {
      move(most_passes * strength_ / passes);
      drop_thin();
    }
  }

  /// What is left to do without noise. Only what has seen a component that was dropped is measured again.
  void drop_all_thin()
  {
    for(std::size_t i = 0; i < density_.size(); ++i)
      if(size_for(i) > 0) // known in the narrowest window only
        density_[i] = unknown;
    for(int pass = 0; pass < most_passes; ++pass) {
      measure_densities();
      const std::vector<std::size_t> dropped = drop_thin();
      if(dropped.empty())
        return;
      for(std::size_t i : dropped)
        forget_densities_around(i);
    }
  }

  /// Distance of every component to its fourth neighbour.
  std::vector<double> spacings() const
  {
    const std::size_t fourth = std::min<std::size_t>(4, nearest_.k() - 1);
    std::vector<double> result;
    for(std::size_t i = 0; i < mixture_.size(); ++i)
      result.push_back(std::sqrt(nearest_[i].begin()[fourth].squared_distance));
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
  static constexpr double unknown = -1; // density

  /// Radius of a window size: from two spacings, the narrowest with a plane in it, by steps of 1.4.
  double radius(std::size_t size) const { return radii_[size]; }

  std::array<double, sizes> radii() const
  {
    std::array<double, sizes> result;
    for(std::size_t size = 0; size < sizes; ++size)
      result[size] = 2 * spacing_ * std::pow(1.4, static_cast<double>(size));
    return result;
  }

  /// What is left of the mixture, where it is now.
  const Mixture_tree& finest()
  {
    if(finest_)
      return *finest_;
    const auto& outlier = result_.outlier;
    if(tree_ && std::none_of(outlier.begin(), outlier.end(), [](bool is) { return is; })) {
      finest_.emplace(&mixture_, tree_);
      kept_ = tree_->order();
      return *finest_;
    }
    Gaussians components;
    std::vector<std::size_t> kept;
    for(std::size_t i = 0; i < mixture_.size(); ++i)
      if(!outlier[i]) {
        components.push_back({mixture_[i].weight, result_.positions[i], mixture_[i].covariance});
        kept.push_back(i);
      }
    finest_.emplace(std::move(components), ConcurrencyTag());
    kept_.clear();
    for(std::size_t k : finest_->tree().order())
      kept_.push_back(kept[k]);
    return *finest_;
  }

  void make_window(std::size_t size)
  {
    if(!windows_[size])
      windows_[size] = std::make_unique<Mixture_window>(finest(), spacing_, radius(size),
                                                         ConcurrencyTag());
  }

  /// The windows around the points of a box.
  class Views
  {
  public:
    Views(const Surface_consolidation& surface, const Box& box) : surface_(surface), box_(box) {}

    Window_view& operator[](std::size_t size)
    {
      if(!views_[size])
        views_[size] = surface_.windows_[size]->around(box_);
      return *views_[size];
    }

  private:
    const Surface_consolidation& surface_;
    Box box_;
    std::array<std::optional<Window_view>, sizes> views_;
  };

  /// Calls `visit(i, views)` for every component that is left. The windows must be there.
  template <typename Visit>
  void for_each_kept(const Visit& visit)
  {
    constexpr std::size_t most = 64; // components: about as many as one of them sees
    const Box_tree& tree = finest().tree();
    std::vector<std::size_t> groups;
    for(std::size_t n = 0; n < tree.nodes().size();) {
      const Box_tree::Node& node = tree.nodes()[n];
      const bool small = node.end - node.begin <= most;
      if(small)
        groups.push_back(n);
      n = small ? node.after : n + 1;
    }
    parallel_for<ConcurrencyTag>(groups.size(), [&](std::size_t g) {
      const Box_tree::Node& node = tree.nodes()[groups[g]];
      Views views(*this, tree.boxes()[groups[g]]);
      for(std::size_t k = node.begin; k < node.end; ++k)
        visit(kept_[k], views);
    });
  }

  /// The same for all: an outlier shows what is around it, too.
  template <typename Visit>
  void for_each(const Visit& visit)
  {
    for_each_kept(visit);
    parallel_for<ConcurrencyTag>(mixture_.size(), [&](std::size_t i) {
      if(!result_.outlier[i])
        return;
      Box box;
      box.add(result_.positions[i]);
      Views views(*this, box);
      visit(i, views);
    });
  }

  /// What a window of one size shows around every n-th component; nothing of the others.
  std::vector<Local_shape> fits(std::size_t size, std::size_t every)
  {
    make_window(size);
    std::vector<Local_shape> result(mixture_.size());
    for_each([&](std::size_t i, Views& views) {
      if(i % every == 0)
        result[i] = views[size](result_.positions[i]);
    });
    return result;
  }

  /// To be called when components have moved or been dropped.
  void forget_windows()
  {
    tree_ = nullptr;
    finest_.reset();
    windows_ = {};
  }

  /// Chooses the size of the window and how much the components move, from nothing to all the way.
  void measure_noise()
  {
    constexpr double smooth = 0.15;  // noise of a fifth of the window's radius
    constexpr std::size_t every = 7; // some hundreds are enough
    double least = std::numeric_limits<double>::infinity();
    for(std::size_t size = 0; size < sizes; ++size) {
      const std::vector<Local_shape> fits = this->fits(size, size == 0 ? 1 : every);
      std::vector<double> sphericity, thickness;
      for(std::size_t i = 0; i < fits.size(); i += every) {
        sphericity.push_back(fits[i].sphericity);
        thickness.push_back(fits[i].thickness);
      }
      const double quartile = quantile(sphericity, 0.25);
      // Uneven sampling alone measures up to 0.03, noise of a quarter of the spacing 0.05 and more.
      // So much noise that it fills a volume evenly has no scatter, but nothing is smooth.
      if(size == 0) {
        density_.clear();
        for(const Local_shape& fit : fits)
          density_.push_back(fit.density);
        strength_ = std::min(1.0, std::max({0.0, (scatter(fits) - 0.03) / 0.03,
                                            (quartile - 0.3) / 0.2}));
      }
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
  double scatter(const std::vector<Local_shape>& narrowest) const
  {
    std::vector<Vector3> offset;
    for(std::size_t i = 0; i < narrowest.size(); ++i)
      offset.push_back(narrowest[i].mean - result_.positions[i]);
    std::vector<double> off(mixture_.size());
    parallel_for<ConcurrencyTag>(mixture_.size(), [&](std::size_t i) {
      const Neighbor* const nearest = nearest_[i].begin(); // nothing has moved yet
      const std::size_t size = std::min<std::size_t>(9, nearest_.k());
      Vector3 mean = Vector3::Zero();
      for(std::size_t k = 0; k < size; ++k)
        mean += offset[nearest[k].index] / static_cast<double>(size);
      off[i] = std::abs(narrowest[i].normal.dot(offset[i] - mean)) / radius(0);
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
  double drowned(const Local_shape& fit) const
  {
    return std::min(1.0, std::max(0.0, 2 * (1.65 - fit.thickness / noise_)));
  }

  /// What a component sees through its window. Where that shows a limb all around, narrower ones are
  /// tried, as long as they show something flatter.
  Local_shape fit_through(Views& views, std::size_t size, const Vector3& position) const
  {
    constexpr double round = 0.2; // sphericity
    Local_shape fit = views[size](position);
    while(size-- > 0 && fit.sphericity > round && drowned(fit) < 0.5) {
      const Local_shape narrower = views[size](position);
      if(narrower.sphericity > fit.sphericity)
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
      make_window(size);
    return result;
  }

  /// Measures the densities that are unknown.
  void measure_densities()
  {
    const std::vector<std::size_t> size = window_sizes();
    for(std::size_t i = 0; i < mixture_.size(); ++i)
      if(result_.outlier[i])
        density_[i] = 0;
    for_each_kept([&](std::size_t i, Views& views) {
      if(density_[i] == unknown)
        density_[i] = views[size[i]].density(result_.positions[i]);
    });
  }

  /// Forgets the densities at all places that have seen a component, which is dropped.
  void forget_densities_around(std::size_t component)
  {
    // In windows of coarser components it is part of one up to a cell away.
    constexpr double sight = Window_view::reach + 0.6; // in radii: the diagonal of 1/3
    const Box_tree& tree = finest().tree();
    tree.visit_within(result_.positions[component], sight * radius(sizes - 1),
                      [&](std::size_t k, double squared_distance) {
                        const double far = sight * radius(size_for(kept_[k]));
                        if(squared_distance < far * far)
                          density_[kept_[k]] = unknown;
                      });
  }

  /// Moves components by a share of their way to the surface.
  void move(double share)
  {
    const std::vector<std::size_t> size = window_sizes();
    density_.assign(mixture_.size(), 0);
    for_each_kept([&](std::size_t i, Views& views) {
      Vector3& position = result_.positions[i]; // the windows keep the ones before
      const Local_shape fit = fit_through(views, size[i], position);
      density_[i] = fit.density;
      const double blob = std::min(1.0, std::max(0.0, (fit.sphericity - 0.1) / 0.2));
      const Vector3 step = fit.mean - position;
      // Along a twig nothing moves, or its points would gather in lumps.
      const Vector3 across = step - fit.linearity * fit.axis.dot(step) * fit.axis;
      position += share * ((1 - blob) * fit.normal.dot(step) * fit.normal +
                           blob * drowned(fit) * across);
    });
    forget_windows();
  }

  /// A thin cloud beside a dense surface is the tail of its noise. Returns what is dropped.
  std::vector<std::size_t> drop_thin()
  {
    constexpr double apart = 1.5;
    constexpr double thin = 0.3; // Gaussian noise at 1.6 standard deviations
    const Box_tree& tree = finest().tree();
    std::vector<double> densities; // in the order of the tree
    for(std::size_t i : kept_)
      densities.push_back(density_[i]);
    const auto at = [&](std::size_t k) {
      return densities.begin() + static_cast<std::ptrdiff_t>(k);
    };
    std::vector<double> densest; // of every node of the tree
    for(const Box_tree::Node& node : tree.nodes())
      densest.push_back(*std::max_element(at(node.begin), at(node.end)));
    std::vector<char> drop(mixture_.size(), 0);
    parallel_for<ConcurrencyTag>(mixture_.size(), [&](std::size_t i) {
      if(result_.outlier[i])
        return;
      // What lies apart from the others is compared with the surface further away.
      const double reach = (spacings_[i] > apart * spacing_ ? 1.5 : 1) * radius(size_);
      const Vector3& position = result_.positions[i];
      const auto may_tell = [&](std::size_t node) {
        return !drop[i] && density_[i] < thin * densest[node] &&
               tree.boxes()[node].squared_distance(position) < reach * reach;
      };
      tree.visit_leaves(may_tell, [&](std::size_t begin, std::size_t end) {
        for(std::size_t k = begin; k < end; ++k)
          if(density_[i] < thin * densities[k] &&
             (tree.positions()[k] - position).squaredNorm() < reach * reach)
            drop[i] = true;
      });
    });
    std::vector<std::size_t> dropped;
    for(std::size_t i = 0; i < mixture_.size(); ++i)
      if(drop[i]) {
        result_.outlier[i] = true;
        dropped.push_back(i);
      }
    if(!dropped.empty())
      forget_windows();
    return dropped;
  }

  const Gaussians& mixture_;
  const Box_tree* tree_; ///< Over the mixture, as long as nothing has moved.
  const K_nearest_neighbors& nearest_;
  std::vector<double> spacings_;
  double spacing_;
  std::array<double, sizes> radii_; ///< Of the windows.
  std::vector<double> density_; ///< Of every component, in its window; may be `unknown`.
  std::size_t size_ = 0;
  double strength_ = 0;
  std::vector<std::size_t> kept_; ///< The components of `finest_`, in its order.
  std::optional<Mixture_tree> finest_;
  std::array<std::unique_ptr<Mixture_window>, sizes> windows_;
  double noise_ = 0; ///< Thickness of the noisy surface: one standard deviation.
  Consolidated_surface result_;
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CONSOLIDATION_CONSOLIDATE_H
