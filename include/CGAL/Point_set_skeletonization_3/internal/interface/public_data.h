// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_INTERFACE_PUBLIC_DATA_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_INTERFACE_PUBLIC_DATA_H

#include <CGAL/Curve_skeleton_3.h>
#include <CGAL/Gaussian_mixture_3.h>
#include <CGAL/Medial_sample_3.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Normalization.h>
#include <CGAL/Point_set_skeletonization_3/internal/interface/Skeletonization_stages.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel_for.h>
#include <CGAL/Point_set_skeletonization_3/internal/medial/Sample.h>

#include <boost/graph/adjacency_list.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

// Normalised internals to public data in the coordinates of the input, and back.

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

template <typename GeomTraits>
Gaussian_mixture_3<GeomTraits> public_mixture(const std::vector<Gaussians>& levels,
                                              const Normalization& normalization)
{
  using FT = typename GeomTraits::FT;
  Gaussian_mixture_3<GeomTraits> result;
  for(const Gaussians& level : levels) {
    result.levels.emplace_back();
    for(const Gaussian& g : level)
      result.levels.back().push_back({static_cast<FT>(g.weight),
                                      normalization.point<GeomTraits>(g.mean),
                                      normalization.covariance<FT>(g.covariance)});
  }
  return result;
}

template <typename GeomTraits>
Gaussians normalized_level(const std::vector<Gaussian_component_3<GeomTraits>>& level,
                           const Normalization& normalization)
{
  Gaussians result;
  for(const auto& c : level)
    result.push_back({static_cast<double>(c.weight),
                      normalization.to_unit(Normalization::vector(c.mean)),
                      normalization.unit_covariance(c.covariance)});
  return result;
}

template <typename GeomTraits>
std::vector<Medial_sample_3<GeomTraits>> public_samples(const std::vector<Sample>& samples,
                                                        const Normalization& normalization)
{
  using FT = typename GeomTraits::FT;
  const double scale = normalization.diagonal();
  std::vector<Medial_sample_3<GeomTraits>> result;
  for(const Sample& s : samples)
    result.push_back({normalization.point<GeomTraits>(s.origin),
                      normalization.point<GeomTraits>(s.position),
                      static_cast<FT>(s.kernel_radius * scale), static_cast<FT>(s.radius * scale),
                      s.frozen});
  return result;
}

/// The list of the points that a vertex of `Graph` stands for; `void` if it has none.
template <typename Graph, typename = void>
struct Indices_of
{
  using type = void;
};

template <typename Graph>
struct Indices_of<Graph, std::void_t<decltype(boost::vertex_bundle_type<Graph>::type::indices)>>
{
  using type = decltype(boost::vertex_bundle_type<Graph>::type::indices);
};

/// The points of every vertex, ascending. Of ten million points they are most of the memory: no more
/// of it than they need, and what `stages` keep of points that are done is forgotten, unless `const`.
/// \throws std::length_error if the points outnumber the values of an index
template <typename ConcurrencyTag, typename Indices, typename Stages>
std::vector<Indices> points_of_vertices(Stages& stages)
{
  using Index = typename Indices::value_type;
  const std::size_t points = stages.number_of_points(), vertices = stages.graph.vertices.size();
  constexpr auto greatest = static_cast<std::uintmax_t>(std::numeric_limits<Index>::max());
  if(points > 0 && points - 1 > greatest)
    throw std::length_error("indices of " + std::to_string(points) +
                            " points do not fit into those of the skeleton's vertices, of which the "
                            "greatest is " + std::to_string(greatest) + "; use a wider type");
  // The points are split into rounds, and these into parts: there is work for so many threads.
  constexpr std::size_t rounds = 8, parts = 8;
  const auto first = [&](std::size_t part) { return part * points / (rounds * parts); };
  const auto for_each_point = [&](std::size_t part, const auto& visit) {
    for(std::size_t p = first(part); p < first(part + 1); ++p)
      if(const std::size_t v = stages.vertex_of_point(p); v != Skeletonization_stages::none)
        visit(p, v);
  };
  // Where the next point of a part goes in the list of a vertex; at first the number of its points.
  std::vector<std::vector<std::size_t>> place(rounds * parts + 1,
                                              std::vector<std::size_t>(vertices, 0));
  parallel_for<ConcurrencyTag>(rounds * parts, [&](std::size_t part) {
    for_each_point(part, [&](std::size_t, std::size_t v) { ++place[part][v]; });
  });
  std::vector<Indices> result(vertices);
  for(std::size_t v = 0; v < vertices; ++v) {
    std::size_t size = 0;
    for(std::vector<std::size_t>& part : place)
      size += std::exchange(part[v], size);
    result[v].reserve(size);
  }
  for(std::size_t begin = 0, end = parts; end < place.size(); begin = end, end += parts) {
    parallel_for<ConcurrencyTag>(vertices, [&](std::size_t v) { result[v].resize(place[end][v]); });
    parallel_for<ConcurrencyTag>(parts, [&](std::size_t k) {
      for_each_point(begin + k, [&](std::size_t p, std::size_t v) {
        result[v][place[begin + k][v]++] = static_cast<Index>(p);
      });
    });
    if constexpr(!std::is_const<Stages>::value)
      stages.forget_points_below(first(end));
  }
  return result;
}

/// Replaces `skeleton` by the result of the last stage. `stages` that are not `const` are used up.
template <typename GeomTraits, typename ConcurrencyTag, typename Stages, typename SkeletonGraph>
void set_public_skeleton(Stages& stages, const Normalization& normalization,
                         SkeletonGraph& skeleton)
{
  const Skeleton_graph& graph = stages.graph;
  using FT = typename GeomTraits::FT;
  SkeletonGraph result(graph.vertices.size());
  for(std::size_t v = 0; v < graph.vertices.size(); ++v) {
    auto& bundle = result[vertex(v, result)];
    bundle.point = normalization.point<GeomTraits>(graph.vertices[v].position);
    bundle.radius = static_cast<FT>(graph.vertices[v].radius * normalization.diagonal());
  }
  for(const Skeleton_graph::Edge& e : graph.edges)
    add_edge(vertex(e.first, result), vertex(e.second, result), result);
  // BGL graphs are copied, so without the indices. These come before, as they may not fit.
  using Indices = typename Indices_of<SkeletonGraph>::type;
  if constexpr(std::is_void<Indices>::value)
    skeleton = result;
  else {
    std::vector<Indices> indices = points_of_vertices<ConcurrencyTag, Indices>(stages);
    skeleton = result;
    for(std::size_t v = 0; v < indices.size(); ++v)
      skeleton[vertex(v, skeleton)].indices = std::move(indices[v]);
  }
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_INTERFACE_PUBLIC_DATA_H
