// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CONSOLIDATION_CONSOLIDATE_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CONSOLIDATION_CONSOLIDATE_H

#include <CGAL/Point_set_skeletonization_3/internal/consolidation/Scale_space.h>
#include <CGAL/Point_set_skeletonization_3/internal/consolidation/measure_noise.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/quantile.h>
#include <CGAL/Point_set_skeletonization_3/internal/mixture/merge_by_cell.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/Box_tree.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/K_nearest_neighbors.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// How noise and outliers are told from the surface.
struct Consolidation_options
{
  Noise_options noise;

  /// Median spacings; a component whose neighbours are further away is an outlier. Density falls by
  /// the square root of 8 in spacing over a badly sampled shape, and outliers are spread in space, not
  /// on a surface.
  double isolated = 3;

  /// Share of the highest density around below which a component is dropped: the tail of Gaussian
  /// noise from 1.6 standard deviations on.
  double thin = 0.3;

  /// Spacings of a component that its window is wide at least: where points are sparse it has to be
  /// wider to show anything.
  double sparse = 1.6;

  /// Median spacings; what is further from its neighbours is compared with densities this much further
  /// away.
  double apart = 1.5;

  /// Sphericity from which on the fitted plane gives way to the mean, and over how much. Halfway
  /// narrower windows are tried.
  double plane = 0.1, plane_to_blob = 0.2;

  /// Thickness over that of the noise, over which a limb stops to be drowned in it: its radius is that
  /// of the noise at 1.2, twice that at 1.7.
  double drowned = 1.15, resolved = 1.65;

  void check() const
  {
    noise.check();
    CGAL_precondition(isolated > 1 && apart >= 1 && sparse > 0);
    CGAL_precondition(thin > 0 && thin < 1);
    CGAL_precondition(plane >= 0 && plane_to_blob > 0);
    CGAL_precondition(drowned < resolved);
  }

  /// Calls `visit(name, value)` for every option.
  template <typename Visit>
  void visit(const Visit& visit)
  {
    noise.visit(visit);
    visit("isolated", isolated);
    visit("thin", thin);
    visit("sparse", sparse);
    visit("apart", apart);
    visit("plane", plane);
    visit("plane_to_blob", plane_to_blob);
    visit("drowned", drowned);
    visit("resolved", resolved);
  }
};

/// A mixture without its noise and outliers: what is left are patches of a surface.
struct Consolidated_mixture
{
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  Gaussians patches;
  std::vector<std::size_t> patch_of_component; ///< `none` for outliers.
  double noise = 0;              ///< In [0, 1]: how much was taken off.
  Box_tree tree;                 ///< Over the means of the patches.
  K_nearest_neighbors neighbors; ///< Of the patches, themselves included.
};

/// Moves the components of a mixture to the surface that they scatter around, and drops those that
/// belong to none.
///
/// A component moves to the plane fitted in its window, or in a narrower one where that shows a limb
/// all around; in a twig as thin as the noise across it to the mean, as mean shift does (Comaniciu and
/// Meer 2002). Without noise nothing moves.
class Consolidation
{
public:
  /// Refers to the mixture, to the tree over its means and to their neighbours, of nine or more.
  Consolidation(const Gaussians& mixture, const Box_tree& tree, const K_nearest_neighbors& nearest,
                const Consolidation_options& options, Concurrency concurrency)
    : options_(options), concurrency_(concurrency), tree_(tree), nearest_(nearest),
      spacings_(spacings(nearest)),
      spacing_(std::max(quantile(spacings_, 0.5), std::numeric_limits<double>::min())),
      radii_(spacing_), moving_{mixture, means_of(mixture), isolated_components()}
  {}

  /// To be called once. Merges what comes to lie in one cell of this size.
  Consolidated_mixture run(double cell_size)
  {
    Scale_space space = initial_scale_space();
    noise_ = measure_noise(space, moving_, nearest_, radii_, options_.noise, concurrency_);
    if(noise_.strength > 0) {
      take_noise_off(std::move(space));
      return merged(cell_size);
    }
    return kept(without_thin_components(std::move(space)));
  }

private:
  static constexpr int most_passes = 4; // the first halves the noise, the last finds nothing to do

  /// Distance of every component to its fourth neighbour.
  static std::vector<double> spacings(const K_nearest_neighbors& nearest)
  {
    const auto fourth = static_cast<std::ptrdiff_t>(std::min<std::size_t>(4, nearest.k() - 1));
    std::vector<double> result;
    for(std::size_t i = 0; i < nearest.size(); ++i)
      result.push_back(std::sqrt(nearest[i][fourth].squared_distance));
    return result;
  }

  std::vector<bool> isolated_components() const
  {
    std::vector<bool> result(spacings_.size());
    for(std::size_t i = 0; i < result.size(); ++i)
      result[i] = spacings_[i] > options_.isolated * spacing_;
    return result;
  }

  Scale_space initial_scale_space() const
  {
    const std::vector<bool>& is_outlier = moving_.is_outlier;
    if(std::find(is_outlier.begin(), is_outlier.end(), true) == is_outlier.end())
      return Scale_space(moving_.mixture, tree_, spacing_, concurrency_);
    return Scale_space(moving_, spacing_, concurrency_);
  }

  Scale_space scale_space() const { return Scale_space(moving_, spacing_, concurrency_); }

  void take_noise_off(Scale_space space)
  {
    // If all passes together are half a step, a window shows the same in each of them.
    constexpr double little = 0.5;
    const int passes = most_passes * noise_.strength < little ? 1 : most_passes;
    for(int pass = 0; pass < passes; ++pass) {
      const std::vector<double> densities = move(space, most_passes * noise_.strength / passes);
      space = scale_space();
      if(!drop_thin(space, densities).empty() && pass + 1 < passes)
        space = scale_space();
    }
  }

  /// Drops thin components where nothing moves. Returns the tree over what is left.
  Box_tree without_thin_components(Scale_space space)
  {
    // Only what has seen a component that was dropped is measured again.
    std::vector<double> densities = noise_.densities;
    for(std::size_t i = 0; i < densities.size(); ++i)
      if(size_for(i) > 0) // known in the narrowest window only
        densities[i] = unknown;
    for(int pass = 0; pass < most_passes; ++pass) {
      measure_densities(space, densities);
      const std::vector<std::size_t> dropped = drop_thin(space, densities);
      if(dropped.empty())
        break;
      space = scale_space();
      for(std::size_t i : dropped)
        forget_densities_around(i, space, densities);
    }
    return space.tree();
  }

  static constexpr double unknown = -1; // density

  /// The window for a component.
  std::size_t size_for(std::size_t i) const
  {
    std::size_t size = noise_.size;
    while(size + 1 < Window_radii::size && radii_[size] < options_.sparse * spacings_[i])
      ++size;
    return size;
  }

  /// The size of the window for every component that is left. Makes them, and all narrower ones.
  std::vector<std::size_t> window_sizes(Scale_space& space) const
  {
    std::vector<std::size_t> result(spacings_.size(), 0);
    for(std::size_t i = 0; i < result.size(); ++i)
      if(!moving_.is_outlier[i])
        result[i] = size_for(i);
    for(std::size_t size = 0; size <= *std::max_element(result.begin(), result.end()); ++size)
      space.make_window(size);
    return result;
  }

  /// How far a limb that a window shows all around is drowned in the noise, in [0, 1].
  double drowned(const Local_shape& shape) const
  {
    const double ratio = shape.thickness / noise_.thickness;
    return std::min(
      1.0, std::max(0.0, (options_.resolved - ratio) / (options_.resolved - options_.drowned)));
  }

  /// What a component sees through its window. Where that shows a limb all around, narrower ones are
  /// tried, as long as they show something flatter.
  Local_shape shape_through(Scale_space::Views& views, std::size_t size,
                            const Vector3& position) const
  {
    Local_shape shape = views[size].shape(position);
    while(size-- > 0 && shape.sphericity > options_.plane + options_.plane_to_blob / 2 && drowned(shape) < 0.5) {
      const Local_shape narrower = views[size].shape(position);
      if(narrower.sphericity > shape.sphericity)
        break;
      const double density = shape.density; // of windows of one size only, they are compared
      shape = narrower;
      shape.density = density;
    }
    return shape;
  }

  /// Moves components by a share of their way to the surface. Returns the densities where they were.
  std::vector<double> move(Scale_space& space, double share)
  {
    const std::vector<std::size_t> size = window_sizes(space);
    std::vector<double> densities(spacings_.size(), 0);
    space.for_each([&](std::size_t i, Scale_space::Views& views) {
      Vector3& position = moving_.positions[i]; // the windows keep the ones before
      const Local_shape shape = shape_through(views, size[i], position);
      densities[i] = shape.density;
      const double blob =
        std::min(1.0, std::max(0.0, (shape.sphericity - options_.plane) / options_.plane_to_blob));
      const Vector3 step = shape.mean - position;
      // Along a twig nothing moves, or its points would gather in lumps.
      const Vector3 across = step - shape.linearity * shape.axis.dot(step) * shape.axis;
      position += share * ((1 - blob) * shape.normal.dot(step) * shape.normal +
                           blob * drowned(shape) * across);
    });
    return densities;
  }

  /// Measures the densities that are unknown.
  void measure_densities(Scale_space& space, std::vector<double>& densities) const
  {
    const std::vector<std::size_t> size = window_sizes(space);
    for(std::size_t i = 0; i < densities.size(); ++i)
      if(moving_.is_outlier[i])
        densities[i] = 0;
    space.for_each([&](std::size_t i, Scale_space::Views& views) {
      if(densities[i] == unknown)
        densities[i] = views[size[i]].density(moving_.positions[i]);
    });
  }

  /// Forgets the densities at all places that have seen a component, which was dropped.
  void forget_densities_around(std::size_t component, const Scale_space& space,
                               std::vector<double>& densities) const
  {
    // In windows of coarser components it is part of one up to a cell away.
    constexpr double sight = Window_view::reach + 0.6; // in radii: the diagonal of 1/3
    const double farthest = sight * radii_[Window_radii::size - 1];
    space.tree().visit_within(moving_.positions[component], farthest,
                              [&](std::size_t k, double squared_distance) {
                                const std::size_t i = space.kept()[k];
                                const double far = sight * radii_[size_for(i)];
                                if(squared_distance < far * far)
                                  densities[i] = unknown;
                              });
  }

  /// A thin cloud beside a dense surface is the tail of its noise. Returns what is dropped. `space` is
  /// of what was left until now.
  std::vector<std::size_t> drop_thin(const Scale_space& space,
                                     const std::vector<double>& densities)
  {
    const Box_tree& tree = space.tree();
    std::vector<double> in_order; // densities in the order of the tree
    for(std::size_t i : space.kept())
      in_order.push_back(densities[i]);
    const auto at = [&](std::size_t k) { return in_order.begin() + static_cast<std::ptrdiff_t>(k); };
    std::vector<double> densest; // of every node of the tree
    for(const Box_tree::Node& node : tree.nodes())
      densest.push_back(*std::max_element(at(node.begin), at(node.end)));
    const double thin = options_.thin;
    std::vector<char> drop(spacings_.size(), 0);
    parallel_for(concurrency_, drop.size(), [&](std::size_t i) {
      if(moving_.is_outlier[i])
        return;
      const double apart = spacings_[i] > options_.apart * spacing_ ? options_.apart : 1;
      const double reach = apart * radii_[noise_.size];
      const Vector3& position = moving_.positions[i];
      const auto may_tell = [&](std::size_t node) {
        return !drop[i] && densities[i] < thin * densest[node] &&
               squared_distance(tree.boxes()[node], position) < reach * reach;
      };
      tree.visit_leaves(may_tell, [&](std::size_t begin, std::size_t end) {
        for(std::size_t k = begin; k < end; ++k)
          if(densities[i] < thin * in_order[k] &&
             (tree.positions()[k] - position).squaredNorm() < reach * reach)
            drop[i] = true;
      });
    });
    std::vector<std::size_t> dropped;
    for(std::size_t i = 0; i < drop.size(); ++i)
      if(drop[i]) {
        moving_.is_outlier[i] = true;
        dropped.push_back(i);
      }
    return dropped;
  }

  /// A patch for every component that is left, where nothing has moved; `tree` is over them.
  Consolidated_mixture kept(const Box_tree& tree) const
  {
    Consolidated_mixture result;
    result.tree = tree;
    result.patch_of_component.assign(spacings_.size(), Consolidated_mixture::none);
    for(std::size_t i = 0; i < spacings_.size(); ++i)
      if(!moving_.is_outlier[i]) {
        result.patch_of_component[i] = result.patches.size();
        result.patches.push_back(
          {moving_.mixture[i].weight, moving_.positions[i], Matrix3::Zero()});
      }
    result.neighbors = result.patches.size() == spacings_.size()
                         ? nearest_
                         : renumbered(nearest_, result.patch_of_component, tree, concurrency_);
    return result;
  }

  /// The same where components have moved: those that came to lie in one cell are one patch.
  Consolidated_mixture merged(double cell_size) const
  {
    std::vector<std::size_t> left;
    Gaussians points;
    for(std::size_t i = 0; i < spacings_.size(); ++i)
      if(!moving_.is_outlier[i]) {
        left.push_back(i);
        points.push_back({moving_.mixture[i].weight, moving_.positions[i], Matrix3::Zero()});
      }
    const Merged_gaussians merged = merged_by_cell(points, cell_size);
    Consolidated_mixture result;
    result.noise = noise_.strength;
    result.patches = merged.gaussians;
    result.patch_of_component.assign(spacings_.size(), Consolidated_mixture::none);
    for(std::size_t k = 0; k < left.size(); ++k)
      result.patch_of_component[left[k]] = merged.merged_into[k];
    result.tree = Box_tree(means_of(result.patches), concurrency_);
    result.neighbors = k_nearest_neighbors(result.tree, surface_neighbors + 1, concurrency_);
    return result;
  }

  const Consolidation_options& options_;
  Concurrency concurrency_;
  Box_tree tree_; ///< Over the mixture as it was read.
  const K_nearest_neighbors& nearest_;
  std::vector<double> spacings_;
  double spacing_; ///< The median.
  Window_radii radii_;
  Moving_mixture moving_;
  Noise noise_;
};

/// Takes noise and outliers off a mixture. Components that come to lie in one cell of the given size
/// become one patch. O(n log n).
inline Consolidated_mixture consolidate(const Gaussians& mixture, double cell_size,
                                        const Consolidation_options& options,
                                        Concurrency concurrency)
{
  options.check();
  const Box_tree tree(means_of(mixture), concurrency);
  const K_nearest_neighbors nearest =
    k_nearest_neighbors(tree, surface_neighbors + 1, concurrency);
  return Consolidation(mixture, tree, nearest, options, concurrency).run(cell_size);
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CONSOLIDATION_CONSOLIDATE_H
