// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PUBLISHED_PUBLISHED_METHOD_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PUBLISHED_PUBLISHED_METHOD_H

#include <CGAL/Point_set_skeletonization_3/internal/published/Point_search.h>
#include <CGAL/Point_set_skeletonization_3/internal/interface/Skeletonization_stages.h>
#include <CGAL/Point_set_skeletonization_3/internal/published/branch_detection.h>
#include <CGAL/Point_set_skeletonization_3/internal/published/branch_merging.h>
#include <CGAL/Point_set_skeletonization_3/internal/published/hierarchical_em.h>
#include <CGAL/Point_set_skeletonization_3/internal/published/nearest_neighbor_gaussians.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel_for.h>
#include <CGAL/Point_set_skeletonization_3/internal/published/published_projection.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Points of the input that become samples. The paper says "a small subset"; Huang et al. (2013)
/// take a twentieth. Never so few that a limb goes without.
inline std::size_t published_number_of_samples(std::size_t points)
{
  constexpr std::size_t fraction = 20, least = 500;
  return std::min(points, std::max(points / fraction, least));
}

/// The method as published: kNN start, hierarchical EM, samples drawn from the points, a fixed
/// number of iterations with linearly growing kernels, Algorithm 1 on a mixture of the samples.
template <typename ConcurrencyTag>
class Published_stages : public Skeletonization_stages
{
public:
  Published_stages(unsigned int random_seed, const Published_projection_options& options)
    : projection_(options)
  {
    em_.random_seed = random_seed;
  }

  void read(const Point_blocks& points) override
  {
    for(std::size_t b = 0; b < points.number_of_blocks(); ++b) {
      const Point_blocks::Block block = points.block(b);
      points_.insert(points_.end(), block.begin(), block.end());
    }
  }

  bool fit(const Progress& progress) override
  {
    if(points_.empty())
      return progress(1);
    Gaussians start =
      nearest_neighbor_gaussians<ConcurrencyTag>(points_, Nearest_neighbor_options());
    const double h = initial_kernel_radius(points_.size());
    const std::vector<double> density =
      densities<ConcurrencyTag>(points_, [&](std::size_t) { return h; });
    for(std::size_t i = 0; i < start.size(); ++i)
      start[i].weight /= density[i]; // Eq. 7: alpha_j / v_j
    if(!progress(0.5))
      return false;
    mixture = hierarchical_em<ConcurrencyTag>(std::move(start), em_);
    return progress(1);
  }

  bool project(const Progress& progress) override
  {
    samples = drawn_samples();
    outcome = project_as_published<ConcurrencyTag>(
      samples, mixture.empty() ? Gaussians() : mixture.back(), projection_, progress);
    if(outcome.reason == Projection_stop_reason::cancelled)
      return false;
    if(!mixture.empty()) {
      const Point_search surface(mixture.back().size(),
                                    [&](std::size_t i) { return mixture.back()[i].mean; });
      for(Sample& s : samples)
        s.radius = std::sqrt(surface.nearest(s.position).squared_distance);
    }
    return true;
  }

  bool link(const Progress& progress) override
  {
    if(samples.empty())
      return progress(1);
    std::vector<Vector3> positions;
    for(const Sample& s : samples)
      positions.push_back(s.position);
    const Gaussians skeleton_mixture =
      hierarchical_em<ConcurrencyTag>(
        nearest_neighbor_gaussians<ConcurrencyTag>(positions, Nearest_neighbor_options()), em_)
        .back();
    if(!progress(0.3))
      return false;
    graph = link_branches(skeleton_mixture,
                          detect_longest_branches(skeleton_mixture, Branch_detection_options()));
    if(!progress(0.8))
      return false;
    assign_points(positions);
    return progress(1);
  }

  const Gaussians& components() const override { return mixture.back(); }

  std::size_t number_of_points() const override { return points_.size(); }

  std::size_t vertex_of_point(std::size_t p) const override { return vertex_of_point_[p]; }

private:
  /// A seeded choice by the position of a point, not by its index: independent of the order.
  std::vector<Sample> drawn_samples() const
  {
    std::vector<std::pair<std::uint64_t, std::size_t>> order;
    for(std::size_t i = 0; i < points_.size(); ++i)
      order.emplace_back(position_hash(points_[i], em_.random_seed), i);
    std::sort(order.begin(), order.end());
    order.resize(published_number_of_samples(order.size()));
    std::vector<Sample> drawn(order.size());
    for(std::size_t k = 0; k < drawn.size(); ++k) {
      drawn[k].origin = drawn[k].position = points_[order[k].second];
      drawn[k].kernel_radius = initial_kernel_radius(points_.size());
    }
    return drawn;
  }

  /// A point belongs to the sample that started nearest to it, a sample to the nearest vertex.
  void assign_points(const std::vector<Vector3>& positions)
  {
    const Point_search vertices(graph.vertices.size(),
                                   [&](std::size_t v) { return graph.vertices[v].position; });
    std::vector<std::size_t> vertex_of_sample(samples.size());
    std::vector<double> count(graph.vertices.size(), 0);
    for(std::size_t i = 0; i < samples.size(); ++i) {
      const std::size_t v = vertex_of_sample[i] = vertices.nearest(positions[i]).index;
      graph.vertices[v].radius += (samples[i].radius - graph.vertices[v].radius) / ++count[v];
    }
    const Point_search origins(samples.size(), [&](std::size_t i) { return samples[i].origin; });
    vertex_of_point_.resize(points_.size());
    parallel_for<ConcurrencyTag>(points_.size(), [&](std::size_t p) {
      vertex_of_point_[p] = vertex_of_sample[origins.nearest(points_[p]).index];
    });
  }

  Hierarchical_em_options em_;
  Published_projection_options projection_;
  std::vector<Vector3> points_;
  std::vector<std::size_t> vertex_of_point_;
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PUBLISHED_PUBLISHED_METHOD_H
