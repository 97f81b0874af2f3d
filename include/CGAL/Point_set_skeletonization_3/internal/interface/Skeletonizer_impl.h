// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_INTERFACE_SKELETONIZER_IMPL_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_INTERFACE_SKELETONIZER_IMPL_H

#include <CGAL/Point_set_skeletonization_3/internal/consolidation/cloud_of_lines.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Normalization.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Normalized_points.h>
#include <CGAL/Point_set_skeletonization_3/internal/interface/Skeletonizer.h>
#include <CGAL/Point_set_skeletonization_3/internal/interface/fill_indices.h>
#include <CGAL/Point_set_skeletonization_3/internal/interface/plain_conversion.h>
#include <CGAL/Point_set_skeletonization_3/internal/medial/sample_kinds.h>
#include <CGAL/Point_set_skeletonization_3/internal/medial/span_holes.h>
#include <CGAL/Point_set_skeletonization_3/internal/mixture/Grid_mixture.h>
#include <CGAL/Point_set_skeletonization_3/internal/mixture/Moment_grid.h>
#include <CGAL/Point_set_skeletonization_3/internal/pipeline/Options.h>
#include <CGAL/Point_set_skeletonization_3/internal/pipeline/link_objects.h>
#include <CGAL/Point_set_skeletonization_3/internal/pipeline/medial_objects.h>

#include <algorithm>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

struct Skeletonizer::State
{
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();
  static constexpr std::size_t number_of_levels = 3; // stages 2 and 3 use the first

  Concurrency concurrency;
  Options options;
  double smallest_feature = 0; ///< In the unit of the input; 0: as thin as the points allow.

  Normalization normalization;
  Cells_of_points cell_of_point;  ///< In the finest level; empty for points from a builder.
  Cell_numbers cells;             ///< Of the finest level, for points from a builder.
  std::vector<Gaussians> mixture; ///< Finest level first.
  double cell_size = 0;           ///< Of the finest level.

  std::vector<Medial_object> objects;

  Skeleton_graph graph;
  std::vector<std::size_t> vertex_of_sample, vertex_of_component; ///< `none` for outliers.
  std::size_t number_of_outliers = 0;
  std::size_t number_of_far = 0; ///< Points that are in no component, outliers as well.

  /// \pre `normalization` is that of the points
  Grid_options mixture_options() const
  {
    Grid_options result = options.mixture;
    if(smallest_feature > 0)
      result.smallest_feature = smallest_feature / normalization.diagonal();
    return result;
  }

  void set_mixture(Grid_mixture grid)
  {
    for(const Grid_level& level : grid.levels)
      mixture.push_back(level.gaussians(concurrency));
    if(!grid.levels.empty())
      cell_size = grid.levels.front().grid.cell_size();
    cell_of_point = std::move(grid.cell_of_point);
  }

  void forget_mixture()
  {
    forget_samples();
    mixture.clear();
    cell_of_point = Cells_of_points();
    cells = Cell_numbers();
    number_of_far = 0;
    cell_size = 0;
  }

  void forget_samples()
  {
    forget_skeleton();
    objects.clear();
  }

  void forget_skeleton()
  {
    graph = Skeleton_graph();
    vertex_of_sample.clear();
    vertex_of_component.clear();
    number_of_outliers = 0;
  }

  /// Which samples and surface points are of an object.
  struct Samples_of_object
  {
    std::vector<std::size_t> samples, surface;
  };

  /// Adds an object of which the samples are known. The surface points replace the components of
  /// the mixture; without any, the patches do.
  /// \param place of each sample among those of its object
  void add_object(const Plain_samples& plain, const Samples_of_object& of_object,
                  const std::vector<std::size_t>& place, double noise)
  {
    Consolidated_mixture consolidated;
    consolidated.noise = noise;
    std::vector<std::size_t> components, patch_of_component;
    const auto add_component = [&](std::size_t merged_into, const Gaussian& measured) {
      consolidated.merged_into.push_back(merged_into);
      components.push_back(mixture.front().size());
      mixture.front().push_back(measured);
    };
    std::map<Plain_point, std::size_t> component_at;
    for(std::size_t k : of_object.surface) {
      const Plain_surface_point& p = plain.surface[k];
      const auto [found, is_new] =
        component_at.emplace(p.denoised, consolidated.components.size());
      if(is_new) {
        consolidated.components.push_back(
          {0, normalization.to_unit(to_vector(p.denoised)), Matrix3::Zero()});
        patch_of_component.push_back(place[p.sample]);
      }
      consolidated.components[found->second].weight += p.weight;
      add_component(found->second,
                    {p.weight, normalization.to_unit(to_vector(p.point)), Matrix3::Zero()});
    }
    Samples samples;
    for(std::size_t i : of_object.samples) {
      const Plain_sample& sample = plain.samples[i];
      samples.push_back({normalization.to_unit(to_vector(sample.point)),
                         sample.radius / normalization.diagonal()});
      if(plain.surface.empty()) {
        patch_of_component.push_back(patch_of_component.size());
        consolidated.components.push_back(from_plain(sample.patch, normalization));
        add_component(place[i], consolidated.components.back());
      }
    }
    consolidated.tree = Box_tree(means_of(consolidated.components), concurrency);
    consolidated.neighbors =
      k_nearest_neighbors(consolidated.tree, surface_neighbors + 1, concurrency);
    Surface surface = build_surface(
      consolidated.components, consolidated.tree,
      estimate_patches(consolidated.components, consolidated.neighbors, options.medial.surface,
                       concurrency),
      Patch_groups(std::move(patch_of_component), samples.size()),
      is_cloud_of_lines(consolidated.components, consolidated.tree, consolidated.neighbors),
      options.medial.surface, concurrency);
    span_holes(surface, samples, options.medial.samples, concurrency);
    objects.push_back({std::move(components),
                       {std::move(consolidated), std::move(surface), std::move(samples)}});
  }

  void assign_components()
  {
    vertex_of_component.assign(mixture.front().size() + 1, none); // the last: of points far away
    std::size_t first_sample = 0;
    for(const Medial_object& object : objects) {
      for(std::size_t k = 0; k < object.components.size(); ++k)
        if(const std::size_t patch = object.patch_of(k); patch != Medial_object::none)
          vertex_of_component[object.components[k]] = vertex_of_sample[first_sample + patch];
      first_sample += object.medial.samples.size();
    }
    double outlier_weight = 0;
    for(std::size_t i = 0; i < mixture.front().size(); ++i)
      outlier_weight += vertex_of_component[i] == none ? mixture.front()[i].weight : 0;
    number_of_outliers =
      number_of_far + static_cast<std::size_t>(outlier_weight); // a sum of integers
  }

  template <typename Forget>
  void fill_point_indices(const Index_lists& lists, const Forget& forget_points_below) const
  {
    fill_indices(
      cell_of_point.size(), graph.vertices.size(),
      [this](std::size_t p) { return vertex_of_component[cell_of_point[p]]; },
      forget_points_below, lists, concurrency);
  }
};

CGAL_POINT_SET_SKELETONIZATION_3_INLINE
Skeletonizer::Skeletonizer(Concurrency concurrency, const Known_topology& known)
  : state_(std::make_unique<State>())
{
  state_->concurrency = concurrency;
  state_->options.linking.known = known;
}

CGAL_POINT_SET_SKELETONIZATION_3_INLINE
Skeletonizer::Skeletonizer(Concurrency concurrency, const Options& options)
  : Skeletonizer(concurrency)
{
  state_->options = options;
}

CGAL_POINT_SET_SKELETONIZATION_3_INLINE
void Skeletonizer::limit_cells(std::size_t maximum_cells)
{
  state_->options.mixture.limit_cells(maximum_cells);
}

CGAL_POINT_SET_SKELETONIZATION_3_INLINE
void Skeletonizer::limit_features(double smallest_feature)
{
  state_->smallest_feature = smallest_feature;
}

CGAL_POINT_SET_SKELETONIZATION_3_INLINE
Skeletonizer::Skeletonizer(Skeletonizer&&) noexcept = default;

CGAL_POINT_SET_SKELETONIZATION_3_INLINE
Skeletonizer& Skeletonizer::operator=(Skeletonizer&&) noexcept = default;

CGAL_POINT_SET_SKELETONIZATION_3_INLINE
Skeletonizer::~Skeletonizer() = default;

CGAL_POINT_SET_SKELETONIZATION_3_INLINE
void Skeletonizer::fit_mixture(const Point_source& points, const Progress& progress)
{
  State& state = *state_;
  state.forget_mixture();
  const Bulk bulk = bulk_of(points, state.concurrency, progress.part(0, 0.2));
  state.normalization = bulk.box().normalization();
  state.number_of_far = bulk.number_of_far();
  state.set_mixture(grid_mixture({points, state.normalization, state.number_of_far},
                                 state.mixture_options(), State::number_of_levels,
                                 state.concurrency, progress.part(0.2, 1)));
}

CGAL_POINT_SET_SKELETONIZATION_3_INLINE
void Skeletonizer::fit_mixture(const Moment_grid& points, const Normalization& normalization,
                               std::size_t number_of_far)
{
  state_->forget_mixture();
  state_->number_of_far = number_of_far;
  state_->normalization = normalization;
  Grid_mixture grid = grid_mixture(points, state_->mixture_options(), State::number_of_levels);
  if(!grid.levels.empty())
    state_->cells = {grid.levels.front().grid, grid.levels.front().cells.cells()};
  state_->set_mixture(std::move(grid));
}

CGAL_POINT_SET_SKELETONIZATION_3_INLINE
void Skeletonizer::set_mixture(const Plain_mixture& mixture)
{
  State& state = *state_;
  state.forget_mixture();
  if(mixture.levels.empty() || mixture.levels.front().empty())
    return;
  state.normalization =
    normalization_of(mixture.box, mixture.levels.front(),
                     [](const Plain_gaussian& g) -> const Plain_gaussian& { return g; });
  for(const std::vector<Plain_gaussian>& level : mixture.levels) {
    state.mixture.emplace_back();
    for(const Plain_gaussian& g : level)
      state.mixture.back().push_back(from_plain(g, state.normalization));
  }
  state.cell_size = mixture.cell_size / state.normalization.diagonal();
}

CGAL_POINT_SET_SKELETONIZATION_3_INLINE
void Skeletonizer::project(const Progress& progress)
{
  State& state = *state_;
  state.forget_samples();
  if(!state.mixture.empty())
    state.objects = medial_objects(state.mixture.front(), state.cell_size,
                                   state.options.scene_options(), state.options.medial,
                                   state.concurrency, progress);
}

CGAL_POINT_SET_SKELETONIZATION_3_INLINE
void Skeletonizer::set_samples(const Plain_samples& plain)
{
  State& state = *state_;
  state.forget_mixture();
  if(plain.samples.empty())
    return;
  state.normalization =
    normalization_of(plain.box, plain.samples,
                     [](const Plain_sample& s) -> const Plain_gaussian& { return s.patch; });

  Extent surface_extent; // throws
  for(std::size_t i = 0; i < plain.surface.size(); ++i) {
    surface_extent.add(i, to_vector(plain.surface[i].point));
    surface_extent.add(i, to_vector(plain.surface[i].denoised));
  }

  std::vector<State::Samples_of_object> objects;
  std::vector<std::size_t> place(plain.samples.size()); // among the samples of its object
  for(std::size_t i = 0; i < plain.samples.size(); ++i) {
    const std::size_t object = plain.samples[i].object;
    if(object >= objects.size())
      objects.resize(object + 1);
    place[i] = objects[object].samples.size();
    objects[object].samples.push_back(i);
  }
  for(std::size_t k = 0; k < plain.surface.size(); ++k)
    objects[plain.samples[plain.surface[k].sample].object].surface.push_back(k);
  state.mixture.emplace_back();
  for(std::size_t object = 0; object < objects.size(); ++object)
    if(!objects[object].samples.empty())
      state.add_object(plain, objects[object], place,
                       object < plain.noise.size() ? plain.noise[object] : 0);
}

CGAL_POINT_SET_SKELETONIZATION_3_INLINE
void Skeletonizer::link(const Progress& progress)
{
  State& state = *state_;
  state.forget_skeleton();
  if(state.objects.empty())
    return;
  Linked_samples linked = link_objects(state.objects, state.mixture.front(),
                                       state.options.linking, state.concurrency, progress);
  state.graph = std::move(linked.graph);
  state.vertex_of_sample = std::move(linked.vertex_of_sample);
  state.assign_components();
}

CGAL_POINT_SET_SKELETONIZATION_3_INLINE
Plain_mixture Skeletonizer::mixture() const
{
  return to_plain(state_->mixture, state_->cell_size, state_->normalization);
}

CGAL_POINT_SET_SKELETONIZATION_3_INLINE
Plain_samples Skeletonizer::samples() const
{
  Plain_samples result;
  const Normalization& normalization = state_->normalization;
  result.box = plain_box(normalization);
  for(const Medial_object& object : state_->objects) {
    const Medial_surface& medial = object.medial;
    const std::size_t first = result.samples.size();
    const std::vector<Medial_sample_kind> kinds =
      sample_kinds(medial.surface, medial.samples, state_->options.linking.separators.overlap);
    for(std::size_t i = 0; i < medial.samples.size(); ++i)
      result.samples.push_back({to_plain(medial.surface.gaussians[i], normalization),
                                to_plain(medial.samples[i].position, normalization),
                                medial.samples[i].radius * normalization.diagonal(), kinds[i],
                                result.noise.size()});
    result.noise.push_back(medial.consolidated.noise);
    for(std::size_t k = 0; k < object.components.size(); ++k) {
      const std::size_t component = medial.consolidated.merged_into[k];
      if(component == Consolidated_mixture::none)
        continue;
      const Gaussian& measured = state_->mixture.front()[object.components[k]];
      result.surface.push_back(
        {to_plain(measured.mean, normalization),
         to_plain(medial.consolidated.components[component].mean, normalization), measured.weight,
         first + medial.surface.groups.group_of()[component]});
    }
  }
  return result;
}

CGAL_POINT_SET_SKELETONIZATION_3_INLINE
Plain_skeleton Skeletonizer::skeleton() const
{
  return to_plain(state_->graph, state_->normalization);
}

CGAL_POINT_SET_SKELETONIZATION_3_INLINE
Plain_assignment Skeletonizer::assignment() const
{
  Plain_assignment result;
  result.box = {to_plain(state_->normalization.lower()), to_plain(state_->normalization.upper())};
  result.cells = state_->cells;
  for(std::size_t i = 0; i < state_->cells.cells.size(); ++i)
    result.vertex_of_cell.push_back(state_->vertex_of_component[i]);
  return result;
}

CGAL_POINT_SET_SKELETONIZATION_3_INLINE
std::size_t Skeletonizer::number_of_components() const
{
  return state_->mixture.empty() ? 0 : state_->mixture.front().size();
}

CGAL_POINT_SET_SKELETONIZATION_3_INLINE
std::size_t Skeletonizer::number_of_samples() const
{
  std::size_t result = 0;
  for(const Medial_object& object : state_->objects)
    result += object.medial.samples.size();
  return result;
}

CGAL_POINT_SET_SKELETONIZATION_3_INLINE
std::size_t Skeletonizer::number_of_outliers() const { return state_->number_of_outliers; }

CGAL_POINT_SET_SKELETONIZATION_3_INLINE
std::size_t Skeletonizer::number_of_points() const { return state_->cell_of_point.size(); }

CGAL_POINT_SET_SKELETONIZATION_3_INLINE
void Skeletonizer::fill_point_indices(const Index_lists& lists) const
{
  state_->fill_point_indices(lists, [](std::size_t) {});
}

CGAL_POINT_SET_SKELETONIZATION_3_INLINE
void Skeletonizer::fill_point_indices_and_forget(const Index_lists& lists)
{
  state_->mixture.clear();
  state_->objects.clear();
  state_->fill_point_indices(
    lists, [this](std::size_t end) { state_->cell_of_point.forget_below(end); });
}

CGAL_POINT_SET_SKELETONIZATION_3_INLINE
void Skeletonizer::fill_sample_indices(const Index_lists& lists) const
{
  const std::vector<std::size_t>& vertex_of_sample = state_->vertex_of_sample;
  fill_indices(
    vertex_of_sample.size(), state_->graph.vertices.size(),
    [&](std::size_t i) { return vertex_of_sample[i]; }, [](std::size_t) {}, lists,
    state_->concurrency);
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_INTERFACE_SKELETONIZER_IMPL_H
