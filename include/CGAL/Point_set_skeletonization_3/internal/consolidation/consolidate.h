// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CONSOLIDATION_CONSOLIDATE_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CONSOLIDATION_CONSOLIDATE_H

#include <CGAL/Point_set_skeletonization_3/internal/consolidation/Neighborhood.h>
#include <CGAL/Point_set_skeletonization_3/internal/consolidation/Scale_space.h>
#include <CGAL/Point_set_skeletonization_3/internal/consolidation/cloud_of_lines.h>
#include <CGAL/Point_set_skeletonization_3/internal/consolidation/measure_noise.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/quantile.h>
#include <CGAL/Point_set_skeletonization_3/internal/mixture/merge_by_cell.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/Box_tree.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/K_nearest_neighbors.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/Neighbor.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Options of part 2a: what is noise and what is an outlier.
struct Consolidation_options
{
  Noise_options noise;

  /// Median spacings, > 1; a component whose fourth neighbour is further away is an outlier, or on
  /// a thin twig. On a badly sampled surface the spacing varies by the square root of 8; outliers
  /// are spread in space.
  double isolated = 3;

  /// Share of the highest density nearby, in (0, 1), below which a component is dropped: the tail
  /// of Gaussian noise beyond 1.6 standard deviations.
  double thin = 0.3;

  /// Least radius of the window, in spacings of the component, > 0: sparse points need wider
  /// windows.
  double sparse = 1.6;

  /// Radii of the window, in (0, 1); width of the cells of a noisy mixture. What is finer than the
  /// noise is no detail.
  double resolution = 0.25;

  /// Checks all ranges.
  void check() const
  {
    noise.check();
    CGAL_precondition(isolated > 1 && sparse > 0);
    CGAL_precondition(thin > 0 && thin < 1);
    CGAL_precondition(resolution > 0 && resolution < 1);
  }

  /// Calls `visit(name, value)` for every option.
  template <typename Visit>
  void visit(const Visit& visit)
  {
    noise.visit(visit);
    visit("isolated", isolated);
    visit("thin", thin);
    visit("sparse", sparse);
    visit("resolution", resolution);
  }
};

/// A mixture without noise and outliers: its components are on a surface.
struct Consolidated_mixture
{
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  Gaussians components;
  Box_tree tree; ///< Over the means of the components.
  std::vector<std::size_t> merged_into; ///< For each component before; `none` for outliers.
  double noise = 0;              ///< Strength of the noise removed, in [0, 1].
  double cell_size = 0;          ///< Edge length of the cells of the components; 0: no cells.
  bool is_of_lines = false;      ///< See `is_cloud_of_lines()`; before anything was dropped.
  K_nearest_neighbors neighbors; ///< Of the components, each first itself, until they were used.
};

/// Moves the components of a mixture to the surface that they scatter around, and drops outliers.
///
/// A component moves to the plane fitted in its window, or in a narrower one if the window contains
/// a whole limb. If that shows no plane either, it moves towards the local mean, by the share of
/// noise in what the window shows across the limb (the best linear estimate of where it was, Wiener
/// 1949), but not along the limb: a limb thinner than the noise becomes a line (mean shift,
/// Comaniciu and Meer 2002). What is a line of components in a narrow window stays where it is: a
/// twig of a few points across is no noise. Without noise, and in a cloud of lines, nothing moves.
class Consolidation
{
public:
  /// Refers to mixture and options. O(n log n).
  Consolidation(const Gaussians& mixture, Neighborhood neighborhood,
                const Consolidation_options& options, Concurrency concurrency)
    : options_(options), concurrency_(concurrency), tree_(std::move(neighborhood.tree)),
      nearest_(std::move(neighborhood.nearest)),
      spacings_(spacings(nearest_)),
      spacing_(std::max(quantile(spacings_, 0.5), (std::numeric_limits<double>::min)())),
      is_of_lines_(is_cloud_of_lines(mixture, tree_, nearest_)),
      radii_(spacing_), moving_{mixture, means_of(mixture), isolated_components(mixture)},
      is_on_line_(mixture.size(), false)
  {}

  /// Measures the noise; there is none in a cloud of lines. Returns the radius of the window that
  /// it needs; 0 if there is none, or if the narrowest window does.
  /// \param is_averaged whether the components are means of noisy ones
  double measure(bool is_averaged = false)
  {
    space_.emplace(initial_scale_space());
    noise_ = measure_noise(*space_, moving_, nearest_, radii_, options_.noise, concurrency_);
    const auto are_tubes = [&] { // means on both sides of a sheet look so, too
      return noise_.strength > 0 && !is_averaged &&
             are_limbs_hollow(*space_, moving_, nearest_, options_.noise, concurrency_);
    };
    if(is_of_lines_ || are_tubes()) { // what looks like noise is the distance of twigs or walls
      noise_.strength = 0;
      noise_.size = 0;
    }
    return noise_.strength > 0 && noise_.size > 0 ? radii_[noise_.size] : 0;
  }

  /// Whether most components are on lines, which are no noise. \pre the noise is measured
  bool is_mostly_lines()
  {
    const std::vector<char> is_on_line = components_on_lines(*space_);
    const auto lines = std::count(is_on_line.begin(), is_on_line.end(), char(true));
    return 2 * static_cast<std::size_t>(lines) > is_on_line.size();
  }

  /// Returns the components left. Those that move into one cell of this edge length are merged. To
  /// be called once. \pre the noise is measured
  Consolidated_mixture run(double cell_size)
  {
    if(noise_.strength > 0) {
      take_noise_off(std::move(*space_));
      return merged(cell_size);
    }
    return kept(without_thin_components(std::move(*space_)), cell_size);
  }

private:
  static constexpr int most_passes = 4; // the first halves the noise, the last does little

  static std::vector<double> spacings(const K_nearest_neighbors& nearest)
  {
    std::vector<double> result;
    for(std::size_t i = 0; i < nearest.size(); ++i)
      result.push_back(spacing_of(i, nearest));
    return result;
  }

  /// Components far from all others are outliers; unless nearly all of these are on lines: then
  /// they are twigs thinner than the spacing, whose few points are further apart, and only those
  /// that are not on lines are outliers. Of such twigs 87 % and more are; of what a scanner sees
  /// between two limbs, which is spread along its rays, up to 63 %.
  std::vector<bool> isolated_components(const Gaussians& mixture) const
  {
    constexpr double nearly_all = 0.75;
    std::vector<bool> result(spacings_.size());
    std::vector<std::size_t> far, on_lines;
    for(std::size_t i = 0; i < result.size(); ++i)
      if(result[i] = spacings_[i] > options_.isolated * spacing_; result[i]) {
        far.push_back(i);
        if(is_on_lines(i, mixture, nearest_))
          on_lines.push_back(i);
      }
    if(static_cast<double>(on_lines.size()) > nearly_all * static_cast<double>(far.size()))
      for(std::size_t i : on_lines)
        result[i] = false;
    return result;
  }

  /// Whether a component is on a line of a cloud of lines: it is no outlier, however sparse.
  bool is_twig(std::size_t i, const Gaussians& mixture) const
  {
    return is_of_lines_ && is_on_lines(i, mixture, nearest_);
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
    is_on_line_ = components_on_lines(space);
    // With weak noise one pass is enough: windows would show the same in each pass.
    constexpr double little = 0.5;
    const int passes = most_passes * noise_.strength < little ? 1 : most_passes;
    for(int pass = 0; pass < passes; ++pass) {
      const std::vector<double> densities = move(space, most_passes * noise_.strength / passes);
      space = scale_space();
      if(!drop_thin(densities).empty() && pass + 1 < passes)
        space = scale_space();
    }
  }

  /// Which components are on a line: of the windows up to that of the noise, the first that shows
  /// either a line or a plane shows a line.
  std::vector<char> components_on_lines(Scale_space& space) const
  {
    enum Dimension : char { unclear, line, plane };
    std::vector<char> dimension(spacings_.size(), unclear);
    for(std::size_t size = 0; size <= noise_.size; ++size) {
      space.make_window(size);
      space.for_each([&](std::size_t i, Scale_space::Views& views) {
        if(dimension[i] != unclear)
          return;
        const Local_shape shape = views[size].shape(moving_.positions[i]);
        if(shape.linearity >= options_.noise.line)
          dimension[i] = line;
        else if(shape.sphericity <= options_.noise.flat())
          dimension[i] = plane;
      });
    }
    for(char& d : dimension)
      d = d == line;
    return dimension;
  }

  /// Drops thin components without moving any. Returns the tree over the rest.
  Box_tree without_thin_components(Scale_space space)
  {
    // Densities are measured again only where a dropped component was in the window.
    std::vector<double> densities = noise_.densities;
    std::size_t widest = 0;
    for(std::size_t i = 0; i < densities.size(); ++i)
      if(const std::size_t size = size_for(i); size > 0) { // measured in the narrowest window only
        densities[i] = unknown;
        widest = (std::max)(widest, size);
      }
    for(int pass = 0; pass < most_passes; ++pass) {
      measure_densities(space, densities);
      const std::vector<std::size_t> dropped = drop_thin(densities);
      if(dropped.empty())
        break;
      space = scale_space();
      for(std::size_t i : dropped)
        forget_densities_around(i, space, widest, densities);
    }
    return space.tree();
  }

  static constexpr double unknown = -1; // density

  /// Index of the window for a component.
  std::size_t size_for(std::size_t i) const
  {
    std::size_t size = noise_.size;
    while(size + 1 < Window_radii::size && radii_[size] < options_.sparse * spacings_[i])
      ++size;
    return size;
  }

  /// Index of the window for each remaining component. Makes these windows and all narrower ones.
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

  /// The share of noise in what varies across a limb that is entirely in a window, in [0, 1]: half
  /// for a tube with a radius of sqrt(2) noises. If it is less, the middle of the tube is empty.
  /// Each pass leaves less noise, but is as strong: limbs hardly wider become lines, which can be
  /// linked.
  double share_of_noise(const Local_shape& shape) const
  {
    const double noise = variance_seen(noise_.variance, shape.radius);
    return noise < shape.variance ? noise / shape.variance : 1;
  }

  /// Features of the window around a component. If it contains a whole limb, narrower windows are
  /// tried as long as they are flatter.
  Local_shape shape_through(Scale_space::Views& views, std::size_t size,
                            const Vector3& position) const
  {
    Local_shape shape = views[size].shape(position);
    while(size-- > 0 && shape.sphericity > options_.noise.round && share_of_noise(shape) < 0.5) {
      const Local_shape narrower = views[size].shape(position);
      if(narrower.sphericity > shape.sphericity)
        break;
      const double density = shape.density; // densities are comparable within one window size
      shape = narrower;
      shape.density = density;
    }
    return shape;
  }

  /// Moves components by `share` of their way to the surface. Returns the densities before.
  std::vector<double> move(Scale_space& space, double share)
  {
    const std::vector<std::size_t> size = window_sizes(space);
    std::vector<double> densities(spacings_.size(), 0);
    space.for_each([&](std::size_t i, Scale_space::Views& views) {
      if(is_on_line_[i]) {
        densities[i] = views[size[i]].density(moving_.positions[i]);
        return;
      }
      Vector3& position = moving_.positions[i]; // the windows keep the old positions
      const Local_shape shape = shape_through(views, size[i], position);
      densities[i] = shape.density;
      const double blob = options_.noise.roundness(shape.sphericity);
      const Vector3 step = shape.mean - position;
      // Not along a limb, or its components would form clusters.
      const Vector3 across = step - shape.linearity * shape.axis.dot(step) * shape.axis;
      position += share * ((1 - blob) * shape.normal.dot(step) * shape.normal +
                           blob * share_of_noise(shape) * across);
    });
    return densities;
  }

  /// Measures the unknown densities.
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

  /// Forgets the densities of components whose windows, of up to the size `widest`, contained a
  /// dropped one.
  void forget_densities_around(std::size_t component, const Scale_space& space, std::size_t widest,
                               std::vector<double>& densities) const
  {
    // In a coarsened window it is part of a component up to a cell away.
    constexpr double sight = Window_view::reach + 0.6; // radii; 0.6: diagonal of a cell of 1/3
    const double farthest = sight * radii_[widest];
    space.tree().visit_within(moving_.positions[component], farthest,
                              [&](std::size_t k, double squared_distance) {
                                const std::size_t i = space.kept()[k];
                                const double far = sight * radii_[size_for(i)];
                                if(squared_distance < far * far)
                                  densities[i] = unknown;
                              });
  }

  /// Drops components of low density near a dense surface, the tail of its noise, and returns them.
  /// A thin limb moves away from its tail and becomes dense: what is near is told by the places
  /// before anything moved, and what has become denser itself is no tail. Neither are twigs.
  std::vector<std::size_t> drop_thin(const std::vector<double>& densities)
  {
    if(first_densities_.empty())
      first_densities_ = densities;
    std::vector<double> in_order; // densities in the order of the tree
    for(std::size_t i : tree_.order())
      in_order.push_back(moving_.is_outlier[i] ? 0 : densities[i]);
    const auto at = [&](std::size_t k) {
      return in_order.begin() + static_cast<std::ptrdiff_t>(k);
    };
    std::vector<double> densest; // maximum of each node of the tree
    for(const Box_tree::Node& node : tree_.nodes())
      densest.push_back(*std::max_element(at(node.begin), at(node.end)));
    const double thin = options_.thin;
    // Halfway to being isolated, a component is compared with others as many times farther away.
    const double halfway = (std::max)(1.0, options_.isolated / 2);
    std::vector<char> drop(spacings_.size(), 0);
    parallel_for(concurrency_, drop.size(), [&](std::size_t i) {
      if(moving_.is_outlier[i] || is_on_line_[i] || densities[i] > first_densities_[i])
        return;
      const double apart = spacings_[i] > halfway * spacing_ ? halfway : 1;
      const double reach = apart * radii_[noise_.size];
      const Vector3& position = moving_.mixture[i].mean;
      const auto may_tell = [&](std::size_t node) {
        return !drop[i] && densities[i] < thin * densest[node] &&
               squared_distance(tree_.boxes()[node], position) < reach * reach;
      };
      tree_.visit_leaves(may_tell, [&](std::size_t begin, std::size_t end) {
        for(std::size_t k = begin; k < end; ++k)
          if(densities[i] < thin * in_order[k] &&
             (tree_.positions()[k] - position).squaredNorm() < reach * reach)
            drop[i] = true;
      });
    });
    std::vector<std::size_t> dropped;
    for(std::size_t i = 0; i < drop.size(); ++i)
      if(drop[i] && !is_twig(i, moving_.mixture)) {
        moving_.is_outlier[i] = true;
        dropped.push_back(i);
      }
    return dropped;
  }

  /// The remaining components, without moves; `tree` is over them.
  Consolidated_mixture kept(const Box_tree& tree, double cell_size)
  {
    Consolidated_mixture result;
    result.is_of_lines = is_of_lines_;
    result.cell_size = cell_size;
    result.merged_into.assign(spacings_.size(), Consolidated_mixture::none);
    result.components.reserve(tree.order().size());
    result.tree = tree;
    for(std::size_t i = 0; i < spacings_.size(); ++i)
      if(!moving_.is_outlier[i]) {
        result.merged_into[i] = result.components.size();
        result.components.push_back(
          {moving_.mixture[i].weight, moving_.positions[i], Matrix3::Zero()});
      }
    result.neighbors = result.components.size() == spacings_.size()
                         ? std::move(nearest_)
                         : renumbered(nearest_, result.merged_into, tree, concurrency_);
    return result;
  }

  /// The same after moves: components in one cell are merged.
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
    result.is_of_lines = is_of_lines_;
    result.noise = noise_.strength;
    result.cell_size = cell_size;
    result.components = merged.gaussians;
    result.merged_into.assign(spacings_.size(), Consolidated_mixture::none);
    for(std::size_t k = 0; k < left.size(); ++k)
      result.merged_into[left[k]] = merged.merged_into[k];
    result.tree = Box_tree(means_of(result.components), concurrency_);
    result.neighbors = k_nearest_neighbors(result.tree, surface_neighbors + 1, concurrency_);
    return result;
  }

  const Consolidation_options& options_;
  Concurrency concurrency_;
  Box_tree tree_; ///< Over the original mixture.
  K_nearest_neighbors nearest_;
  std::vector<double> spacings_;
  double spacing_; ///< The median.
  bool is_of_lines_;
  Window_radii radii_;
  Moving_mixture moving_;
  Noise noise_;
  std::vector<char> is_on_line_; ///< Of each component; not `bool`: threads write to it.
  std::vector<double> first_densities_; ///< Of each component, before anything moved.
  std::optional<Scale_space> space_; ///< Before anything moves.
};

/// Part 2a: returns the mixture without noise and outliers. Components that move into one cell of
/// edge length `cell_size` are merged, or of a coarser grid if the noise is much wider than a cell
/// (unless most are on lines: what looks like noise is the thickness of twigs); 0: none are.
/// O(n log n). \pre there is a component, and `neighborhood` is that of the mixture
inline Consolidated_mixture consolidate(const Gaussians& mixture, Neighborhood neighborhood,
                                        double cell_size, const Consolidation_options& options,
                                        Concurrency concurrency)
{
  options.check();
  double coarser = 0;
  { // what was measured is forgotten before the coarser one
    Consolidation fine(mixture, std::move(neighborhood), options, concurrency);
    coarser = options.resolution * fine.measure();
    // Cells that are hardly wider would only move the borders between the components.
    constexpr double worthwhile = 1.2;
    if(!(cell_size > 0 && coarser > worthwhile * cell_size) || fine.is_mostly_lines())
      return fine.run(cell_size);
  }
  const Merged_gaussians merged = merged_by_cell(mixture, coarser);
  Consolidation coarse(merged.gaussians, Neighborhood(merged.gaussians, concurrency), options,
                       concurrency);
  constexpr bool is_averaged = true;
  coarse.measure(is_averaged);
  Consolidated_mixture result = coarse.run(coarser);
  std::vector<std::size_t> merged_into;
  for(std::size_t i : merged.merged_into)
    merged_into.push_back(result.merged_into[i]);
  result.merged_into = std::move(merged_into);
  return result;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CONSOLIDATION_CONSOLIDATE_H
