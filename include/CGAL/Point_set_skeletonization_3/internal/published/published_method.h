// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PUBLISHED_PUBLISHED_METHOD_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PUBLISHED_PUBLISHED_METHOD_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Normalized_points.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Progress.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/sort_polled.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Skeleton_graph.h>
#include <CGAL/Point_set_skeletonization_3/internal/published/Point_search.h>
#include <CGAL/Point_set_skeletonization_3/internal/published/Published_options.h>
#include <CGAL/Point_set_skeletonization_3/internal/published/branch_detection.h>
#include <CGAL/Point_set_skeletonization_3/internal/published/branch_merging.h>
#include <CGAL/Point_set_skeletonization_3/internal/published/densities.h>
#include <CGAL/Point_set_skeletonization_3/internal/published/hierarchical_em.h>
#include <CGAL/Point_set_skeletonization_3/internal/published/nearest_neighbor_gaussians.h>
#include <CGAL/Point_set_skeletonization_3/internal/published/published_projection.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

// The stages of the method as published: kNN Gaussians, hierarchical EM, samples drawn from the
// points, a fixed number of iterations with linearly growing kernels, Algorithm 1 on a mixture of
// the samples.

/// Points of a cloud, normalised; the published method needs them all.
struct Copied_points
{
  std::vector<Vector3> bulk;    ///< Those in the normalised box, in their order.
  std::vector<std::size_t> far; ///< The indices of the others, ascending.

  std::size_t size() const { return bulk.size() + far.size(); }

  /// Place in `bulk` of the `p`-th point of the cloud; none if that is far. O(log far).
  std::optional<std::size_t> place_in_bulk(std::size_t p) const
  {
    const auto next = std::lower_bound(far.begin(), far.end(), p);
    if(next != far.end() && *next == p)
      return std::nullopt;
    return p - static_cast<std::size_t>(next - far.begin());
  }
};

/// Copies the points of a cloud. O(n).
inline Copied_points copied_points(const Normalized_points& points)
{
  Copied_points result;
  result.bulk.reserve(points.bulk_size());
  std::size_t next = 0;
  for(std::size_t b = 0; b < points.number_of_blocks(); ++b) {
    Progress::poll();
    points.visit_block(b, [&](std::size_t i, const Vector3& p) {
      for(; next < i; ++next)
        result.far.push_back(next);
      ++next;
      result.bulk.push_back(p);
    });
  }
  for(; next < points.size(); ++next)
    result.far.push_back(next);
  return result;
}

/// Stage 1: returns a hierarchy of mixtures, finest level first; empty without points. O(n log n)
/// in practice.
inline std::vector<Gaussians> published_mixture(const std::vector<Vector3>& points,
                                                const Published_options& options,
                                                Concurrency concurrency, const Progress& progress)
{
  if(points.empty())
    return {};
  options.check();
  Gaussians start = nearest_neighbor_gaussians(points, options.points, concurrency);
  const std::vector<double> density =
    densities(points, options.projection.kernel_radius_of(points.size()), concurrency);
  for(std::size_t i = 0; i < start.size(); ++i)
    start[i].weight /= density[i]; // Eq. 7: alpha_j / v_j
  progress(0.5);
  std::vector<Gaussians> result = hierarchical_em(std::move(start), options.em, concurrency);
  progress(1);
  return result;
}

/// Returns samples drawn from the points: a seeded random choice by position, independent of the
/// order of the points. O(n log n).
inline std::vector<L1_sample> drawn_samples(const std::vector<Vector3>& points,
                                            const Published_options& options)
{
  std::vector<std::pair<std::uint64_t, std::size_t>> order;
  for(std::size_t i = 0; i < points.size(); ++i)
    order.emplace_back(position_hash(points[i], options.em.random_seed), i);
  sort_polled(order.begin(), order.end());
  order.resize(options.projection.samples_of(points.size()));
  std::vector<L1_sample> drawn(order.size());
  for(std::size_t k = 0; k < drawn.size(); ++k) {
    drawn[k].origin = drawn[k].position = points[order[k].second];
    drawn[k].kernel_radius = options.projection.kernel_radius_of(points.size());
  }
  return drawn;
}

/// Stage 2: returns samples, moved to L1-medians of the coarsest level of the mixture.
inline Projected_samples published_samples(const std::vector<Vector3>& points,
                                           const std::vector<Gaussians>& mixture,
                                           const Published_options& options,
                                           Concurrency concurrency, const Progress& progress)
{
  if(mixture.empty())
    return {};
  Projected_samples result =
    project_as_published(drawn_samples(points, options), mixture.back(),
                         options.projection, concurrency, progress);
  const Point_search surface(means_of(mixture.back()));
  for(L1_sample& s : result.samples)
    s.radius = std::sqrt(surface.nearest(s.position).squared_distance);
  return result;
}

/// A skeleton, and the vertex of each point.
struct Published_skeleton
{
  Skeleton_graph graph;
  std::size_t number_of_bridges = 0; ///< The last edges, which merge branches.
  std::vector<std::size_t> vertex_of_point; ///< In the order of the bulk.
};

/// Stage 3: returns a tree through the samples. A point belongs to the sample with the nearest
/// start, a sample to the nearest vertex. O(n log n) for n points, plus O(k^2 log k) for k
/// components of a mixture of the samples.
inline Published_skeleton published_skeleton(const std::vector<Vector3>& points,
                                             const std::vector<L1_sample>& samples,
                                             const Published_options& options,
                                             Concurrency concurrency, const Progress& progress)
{
  Published_skeleton result;
  if(samples.empty())
    return result;
  std::vector<Vector3> positions, starts;
  for(const L1_sample& s : samples) {
    positions.push_back(s.position);
    starts.push_back(s.origin);
  }
  const Gaussians mixture =
    hierarchical_em(
      nearest_neighbor_gaussians(positions, options.samples, concurrency), options.em,
      concurrency)
      .back();
  progress(0.3);
  Skeleton_graph& graph = result.graph;
  const std::vector<Branch> branches = detect_longest_branches(mixture, options.branches);
  graph = link_branches(mixture, branches);
  result.number_of_bridges = branches.size() - 1;
  progress(0.8);

  std::vector<Vector3> vertices;
  for(const Skeleton_graph::Vertex& vertex : graph.vertices)
    vertices.push_back(vertex.position);
  const Point_search nearest_vertex(vertices);
  std::vector<std::size_t> vertex_of_sample(samples.size());
  std::vector<double> count(vertices.size(), 0);
  for(std::size_t i = 0; i < samples.size(); ++i) {
    const std::size_t v = vertex_of_sample[i] = nearest_vertex.nearest(positions[i]).index;
    graph.vertices[v].radius += (samples[i].radius - graph.vertices[v].radius) / ++count[v];
  }
  const Point_search nearest_start(starts);
  result.vertex_of_point.resize(points.size());
  parallel_for(concurrency, points.size(), [&](std::size_t p) {
    result.vertex_of_point[p] = vertex_of_sample[nearest_start.nearest(points[p]).index];
  });
  progress(1);
  return result;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PUBLISHED_PUBLISHED_METHOD_H
