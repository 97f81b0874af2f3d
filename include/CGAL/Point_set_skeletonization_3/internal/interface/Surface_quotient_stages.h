// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_INTERFACE_SURFACE_QUOTIENT_STAGES_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_INTERFACE_SURFACE_QUOTIENT_STAGES_H

#include <CGAL/Point_set_skeletonization_3/internal/spatial/Box_tree.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Surface.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/fit_curve.h>
#include <CGAL/Point_set_skeletonization_3/internal/interface/Skeletonization_stages.h>
#include <CGAL/Point_set_skeletonization_3/internal/mixture/merge_by_cell.h>
#include <CGAL/Point_set_skeletonization_3/internal/mixture/Grid_mixture.h>
#include <CGAL/Point_set_skeletonization_3/internal/separators/Ball_overlaps.h>
#include <CGAL/Point_set_skeletonization_3/internal/separators/local_separators.h>
#include <CGAL/Point_set_skeletonization_3/internal/medial/medial_balls.h>
#include <CGAL/Point_set_skeletonization_3/internal/medial/medial_samples.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel_for.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/prune_spurs.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/stray_components.h>
#include <CGAL/Point_set_skeletonization_3/internal/consolidation/consolidate.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/surface_quotient.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Projects the patches of a mixture level, `components`, to their local medians, one sample per patch.
template <typename ConcurrencyTag>
Projection_outcome project_patches(const Gaussians& components,
                                   const Surface<ConcurrencyTag>& surface,
                                   const Projection_options& options, const Progress& progress,
                                   std::vector<Sample>& samples)
{
  const std::vector<double> balls =
    medial_ball_radii<ConcurrencyTag>(surface.patches, surface.confidence, surface.tree);
  if(!progress(0.5)) {
    Projection_outcome cancelled;
    cancelled.reason = Projection_stop_reason::cancelled;
    return cancelled;
  }
  samples = medial_samples<ConcurrencyTag>(surface.patches, surface.confidence,
                                           *surface.winding_number, balls, options);
  const Projection_outcome outcome =
    project_samples<ConcurrencyTag>(samples, components, surface, options, progress.part(0.6, 0.9));
  bring_back_lost_samples<ConcurrencyTag>(samples, surface.patches, *surface.winding_number);
  return outcome;
}

struct Surface_quotient_options
{
  Projection_options projection;
  bool single_component = false;
};

/// The default: patches of a grid, orientation, medial balls and gated projection, surface quotient.
template <typename ConcurrencyTag>
class Surface_quotient_stages : public Skeletonization_stages
{
public:
  explicit Surface_quotient_stages(const Surface_quotient_options& options) : options_(options) {}

  /// For points that were streamed: all that is left of them are their moments.
  Surface_quotient_stages(const Surface_quotient_options& options, const Moment_grid& streamed)
    : options_(options), grid_(grid_moments(streamed, Grid_options(), number_of_levels))
  {}

  void read(const Point_blocks& points) override
  {
    grid_ = grid_moments<ConcurrencyTag>(points, Grid_options(), number_of_levels);
  }

  bool fit(const Progress& progress) override
  {
    mixture.clear(); // of an earlier call
    for(const Grid_level& level : grid_.levels)
      mixture.push_back(level.gaussians());
    return progress(1);
  }

  bool project(const Progress& progress) override
  {
    if(mixture.empty())
      return progress(1);
    Box_tree tree = tree_of_means<ConcurrencyTag>(mixture.front());
    K_nearest_neighbors nearest = patch_neighborhoods<ConcurrencyTag>(tree);
    const Gaussians clean = consolidated(tree, nearest);
    if(!progress(0.3))
      return false;
    surface_ =
      std::make_unique<Surface<ConcurrencyTag>>(clean, std::move(tree), nearest);
    if(!progress(0.6))
      return false;
    outcome = project_patches<ConcurrencyTag>(clean, *surface_, options_.projection,
                                              progress.part(0.6, 0.9), samples);
    return outcome.reason != Projection_stop_reason::cancelled && progress(1);
  }

  bool link(const Progress& progress) override
  {
    if(samples.empty())
      return progress(1);
    std::vector<std::size_t> seeds;
    std::optional<Ball_overlaps> joints;
    parallel_invoke<ConcurrencyTag>(
      [&] { seeds = separator_seeds<ConcurrencyTag>(samples); },
      // In clean data the ball of a patch is unknown where limbs touch; noise hides it in any thin limb.
      [&] { joints.emplace(surface_->patches, samples, noise_, ConcurrencyTag()); });
    if(!progress(0.1))
      return false;
    const std::vector<Local_separator> separators = disjoint_separators<ConcurrencyTag>(
      surface_->patches, samples, seeds, *joints, *surface_->winding_number);
    if(!progress(0.6))
      return false;
    const std::vector<bool> outlier = connect(*joints, separators);
    if(!progress(0.7))
      return false;
    const std::vector<Surface_point> points = surface_points(outlier);
    Skeleton_fitting<ConcurrencyTag> fitting(graph, *surface_, samples, points, noise_);
    fitting.fit(options_.single_component);
    assign_components(fitting.vertices_of_samples());
    return progress(1);
  }

  const Gaussians& components() const override { return mixture.front(); }

  std::size_t number_of_points() const override { return grid_.cell_of_point.size(); }

  std::size_t vertex_of_point(std::size_t p) const override
  {
    return vertex_of_component_[grid_.cell_of_point[p]];
  }

  void forget_points_below(std::size_t end) override { grid_.cell_of_point.forget_below(end); }

private:
  static constexpr std::size_t number_of_levels = 3; // for who reads the mixture; we read the first

  /// Patches from the mixture without its noise and outliers. The tree and the neighbourhoods are those
  /// of the components, and become those of the patches.
  Gaussians consolidated(Box_tree& tree, K_nearest_neighbors& nearest)
  {
    Consolidated_surface clean =
      Surface_consolidation<ConcurrencyTag>(mixture.front(), tree, nearest)();
    noise_ = clean.noise;
    patch_of_component_.assign(mixture.front().size(), none);
    if(noise_ > 0) {
      const Gaussians patches = merged(clean);
      tree = tree_of_means<ConcurrencyTag>(patches);
      nearest = patch_neighborhoods<ConcurrencyTag>(tree);
      return patches;
    }
    const Gaussians patches = kept(clean); // nothing has moved
    if(patches.size() < patch_of_component_.size()) {
      tree = std::move(clean.tree);
      nearest = renumbered<ConcurrencyTag>(nearest, patch_of_component_, tree);
    }
    return patches;
  }

  /// A patch for every component that is left.
  Gaussians kept(const Consolidated_surface& clean)
  {
    Gaussians patches;
    patches.reserve(clean.positions.size());
    for(std::size_t i = 0; i < clean.positions.size(); ++i)
      if(!clean.outlier[i]) {
        patch_of_component_[i] = patches.size();
        patches.push_back({mixture.front()[i].weight, clean.positions[i], Matrix3::Zero()});
      }
    return patches;
  }

  /// The same where components have moved: those that came to lie in one cell are one patch.
  Gaussians merged(const Consolidated_surface& clean)
  {
    std::vector<std::size_t> left;
    for(std::size_t i = 0; i < clean.positions.size(); ++i)
      if(!clean.outlier[i])
        left.push_back(i);
    const Grid_cells cells = grid_cells(
      left.size(), [&](std::size_t k) { return clean.positions[left[k]]; },
      grid_.levels.front().grid.cell_size());
    std::vector<std::optional<Moments>> moments(cells.size);
    for(std::size_t k = 0; k < left.size(); ++k) {
      const std::size_t i = left[k], patch = cells.cell_of[k];
      patch_of_component_[i] = patch;
      if(!moments[patch])
        moments[patch].emplace(clean.positions[i]);
      moments[patch]->add(mixture.front()[i].weight, clean.positions[i]);
    }
    Gaussians patches;
    for(const std::optional<Moments>& of_patch : moments)
      patches.push_back(of_patch->gaussian());
    return patches;
  }

  /// The graph: the surface quotient without spurs and outliers. Returns which patches are outliers.
  std::vector<bool> connect(const Ball_overlaps& joints,
                            const std::vector<Local_separator>& separators)
  {
    const Surface_quotient quotient =
      surface_quotient<ConcurrencyTag>(surface_->patches, samples, joints, separators);
    graph = quotient.graph;
    const auto patches_of = patches_of_vertices(quotient.vertex_of_patch, graph.vertices.size());
    const std::vector<bool> stray = stray_vertices(graph, weights(patches_of));
    std::vector<bool> removed =
      Spur_pruning(graph, separators.size(), surface_->patches, patches_of).spurs();
    for(std::size_t v = 0; v < removed.size(); ++v)
      removed[v] = removed[v] || stray[v];
    mark_caps(graph, separators.size(), removed);
    graph = without(graph, removed);
    std::vector<bool> outlier(samples.size());
    for(std::size_t i = 0; i < samples.size(); ++i)
      outlier[i] = stray[quotient.vertex_of_patch[i]];
    return outlier;
  }

  /// The number of points of every vertex.
  std::vector<double> weights(const std::vector<std::vector<std::size_t>>& patches_of) const
  {
    std::vector<double> result(patches_of.size(), 0);
    for(std::size_t v = 0; v < patches_of.size(); ++v)
      for(std::size_t i : patches_of[v])
        result[v] += surface_->patches[i].weight;
    return result;
  }

  /// The points of the surface, those of one sample after the other; none of outliers. Where there is
  /// noise they are those of the mixture as it was read: taking the noise off moves what is curved to
  /// the inside.
  std::vector<Surface_point> surface_points(const std::vector<bool>& outlier) const
  {
    std::vector<Surface_point> result;
    result.reserve(patch_of_component_.size());
    for(std::size_t i = 0; i < patch_of_component_.size(); ++i)
      if(const std::size_t patch = patch_of_component_[i]; patch != none && !outlier[patch])
        result.push_back({patch, mixture.front()[i].mean});
    if(noise_ > 0) // else they are
      std::stable_sort(result.begin(), result.end(), [](const auto& a, const auto& b) {
        return a.sample < b.sample;
      });
    return result;
  }

  void assign_components(const std::vector<std::size_t>& vertex_of_sample)
  {
    const Gaussians& components = mixture.front();
    double outlier_weight = 0;
    vertex_of_component_.resize(components.size());
    for(std::size_t i = 0; i < components.size(); ++i) {
      const std::size_t patch = patch_of_component_[i];
      vertex_of_component_[i] = patch == none ? none : vertex_of_sample[patch];
      if(vertex_of_component_[i] == none)
        outlier_weight += components[i].weight;
    }
    number_of_outliers = static_cast<std::size_t>(outlier_weight); // a sum of whole numbers
  }

  Surface_quotient_options options_;
  Grid_mixture grid_;
  std::vector<std::size_t> patch_of_component_;  ///< `none` for outliers.
  std::vector<std::size_t> vertex_of_component_; ///< `none` for outliers.
  double noise_ = 0;                             ///< In [0, 1].
  std::unique_ptr<Surface<ConcurrencyTag>> surface_;
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_INTERFACE_SURFACE_QUOTIENT_STAGES_H
