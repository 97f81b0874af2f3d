// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_INTERFACE_PUBLISHED_SKELETONIZER_IMPL_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_INTERFACE_PUBLISHED_SKELETONIZER_IMPL_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Normalization.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Normalized_points.h>
#include <CGAL/Point_set_skeletonization_3/internal/interface/Published_skeletonizer.h>
#include <CGAL/Point_set_skeletonization_3/internal/interface/fill_indices.h>
#include <CGAL/Point_set_skeletonization_3/internal/interface/plain_conversion.h>
#include <CGAL/Point_set_skeletonization_3/internal/published/published_method.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

struct Published_skeletonizer::State
{
  Concurrency concurrency;
  Published_options options;

  Normalization normalization;
  Copied_points points;
  std::vector<Gaussians> mixture; ///< Finest level first.
  Projected_samples projected;
  Published_skeleton skeleton;
};

CGAL_POINT_SET_SKELETONIZATION_3_INLINE
Published_skeletonizer::Published_skeletonizer(Concurrency concurrency,
                                               const Published_options& options)
  : state_(std::make_unique<State>())
{
  state_->concurrency = concurrency;
  state_->options = options;
}

CGAL_POINT_SET_SKELETONIZATION_3_INLINE
Published_skeletonizer::Published_skeletonizer(Published_skeletonizer&&) noexcept = default;

CGAL_POINT_SET_SKELETONIZATION_3_INLINE
Published_skeletonizer&
Published_skeletonizer::operator=(Published_skeletonizer&&) noexcept = default;

CGAL_POINT_SET_SKELETONIZATION_3_INLINE
Published_skeletonizer::~Published_skeletonizer() = default;

CGAL_POINT_SET_SKELETONIZATION_3_INLINE
void Published_skeletonizer::fit_mixture(const Point_source& points, const Progress& progress)
{
  State& state = *state_;
  state.mixture.clear();
  state.projected = Projected_samples();
  state.skeleton = Published_skeleton();
  const Bulk bulk = bulk_of(points, state.concurrency, progress.part(0, 0.1));
  state.normalization = bulk.box().normalization();
  state.points = copied_points({points, state.normalization, bulk.number_of_far()});
  state.mixture = published_mixture(state.points.bulk, state.options, state.concurrency,
                                    progress.part(0.1, 1));
}

CGAL_POINT_SET_SKELETONIZATION_3_INLINE
void Published_skeletonizer::project(const Progress& progress)
{
  State& state = *state_;
  state.projected = Projected_samples();
  state.skeleton = Published_skeleton();
  state.projected = published_samples(state.points.bulk, state.mixture, state.options,
                                    state.concurrency, progress);
}

CGAL_POINT_SET_SKELETONIZATION_3_INLINE
void Published_skeletonizer::link(const Progress& progress)
{
  State& state = *state_;
  state.skeleton = Published_skeleton();
  state.skeleton = published_skeleton(state.points.bulk, state.projected.samples, state.options,
                                      state.concurrency, progress);
}

CGAL_POINT_SET_SKELETONIZATION_3_INLINE
Plain_mixture Published_skeletonizer::mixture() const
{
  return to_plain(state_->mixture, 0, state_->normalization);
}

CGAL_POINT_SET_SKELETONIZATION_3_INLINE
std::vector<Plain_l1_sample> Published_skeletonizer::samples() const
{
  const Normalization& normalization = state_->normalization;
  std::vector<Plain_l1_sample> result;
  for(const L1_sample& s : state_->projected.samples)
    result.push_back({to_plain(s.origin, normalization), to_plain(s.position, normalization),
                      s.kernel_radius * normalization.diagonal(),
                      s.radius * normalization.diagonal()});
  return result;
}

CGAL_POINT_SET_SKELETONIZATION_3_INLINE
Plain_skeleton Published_skeletonizer::skeleton() const
{
  Plain_skeleton result = to_plain(state_->skeleton.graph, state_->normalization);
  result.number_of_bridges = state_->skeleton.number_of_bridges;
  return result;
}

CGAL_POINT_SET_SKELETONIZATION_3_INLINE
std::size_t Published_skeletonizer::number_of_components() const
{
  return state_->mixture.empty() ? 0 : state_->mixture.back().size();
}

CGAL_POINT_SET_SKELETONIZATION_3_INLINE
std::size_t Published_skeletonizer::number_of_samples() const
{
  return state_->projected.samples.size();
}

CGAL_POINT_SET_SKELETONIZATION_3_INLINE
std::size_t Published_skeletonizer::number_of_iterations() const
{
  return state_->projected.iterations;
}

CGAL_POINT_SET_SKELETONIZATION_3_INLINE
std::size_t Published_skeletonizer::number_of_points() const { return state_->points.size(); }

CGAL_POINT_SET_SKELETONIZATION_3_INLINE
std::size_t Published_skeletonizer::number_of_outliers() const
{
  return state_->points.far.size();
}

CGAL_POINT_SET_SKELETONIZATION_3_INLINE
void Published_skeletonizer::fill_point_indices(const Index_lists& lists) const
{
  const Copied_points& points = state_->points;
  const std::size_t vertices = state_->skeleton.graph.vertices.size();
  fill_indices(
    points.size(), vertices,
    [&](std::size_t p) {
      const std::optional<std::size_t> place = points.place_in_bulk(p);
      return place ? state_->skeleton.vertex_of_point[*place] : vertices;
    },
    [](std::size_t) {}, lists, state_->concurrency);
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_INTERFACE_PUBLISHED_SKELETONIZER_IMPL_H
