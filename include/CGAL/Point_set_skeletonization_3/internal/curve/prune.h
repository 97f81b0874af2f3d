// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_PRUNE_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_PRUNE_H

#include <CGAL/Point_set_skeletonization_3/internal/curve/Curve_options.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Limb_roots.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Measured_components.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Skeleton_graph.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Spur_pruning.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Surface_parts.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/stray_components.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/surface_quotient.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch_graph.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch_groups.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Instead of an index.
constexpr std::size_t no_vertex = (std::numeric_limits<std::size_t>::max)();

/// Returns the index of each vertex among those that are not removed; `no_vertex` for these. O(n).
inline std::vector<std::size_t> indices_of_kept(const std::vector<bool>& removed)
{
  std::vector<std::size_t> result(removed.size(), no_vertex);
  std::size_t kept = 0;
  for(std::size_t v = 0; v < removed.size(); ++v)
    if(!removed[v])
      result[v] = kept++;
  return result;
}

/// Returns the graph without the vertices marked `removed` and their edges, in the same order.
/// O(n).
inline Skeleton_graph without(const Skeleton_graph& graph, const std::vector<bool>& removed)
{
  const std::vector<std::size_t> index = indices_of_kept(removed);
  Skeleton_graph result;
  for(std::size_t v = 0; v < graph.vertices.size(); ++v)
    if(!removed[v])
      result.vertices.push_back(graph.vertices[v]);
  for(const Skeleton_graph::Edge& e : graph.edges)
    if(!removed[e.first] && !removed[e.second])
      result.edges.emplace_back(index[e.first], index[e.second]);
  return result;
}

/// Marks the piece beyond the last separator of each limb as removed, unless it is all of a part: a
/// cap has no centre, and the tip is found from the separator before it. O(n).
inline void mark_caps(const Skeleton_graph& graph, Surface_parts parts, std::vector<bool>& removed)
{
  std::vector<std::vector<std::size_t>> adjacency(graph.vertices.size());
  for(const Skeleton_graph::Edge& e : graph.edges)
    if(!removed[e.first] && !removed[e.second]) {
      adjacency[e.first].push_back(e.second);
      adjacency[e.second].push_back(e.first);
    }
  const auto is_cap = [&](std::size_t v) {
    const Skeleton_graph::Vertex& vertex = graph.vertices[v];
    return !vertex.is_cross_section && adjacency[v].size() == 1;
  };
  for(std::size_t v = 0; v < adjacency.size(); ++v) {
    if(!is_cap(v))
      continue;
    // A single separator between two caps keeps them: one vertex has no direction.
    const std::vector<std::size_t>& next = adjacency[adjacency[v].front()];
    removed[v] = std::count_if(next.begin(), next.end(), is_cap) == 1 && !parts.are_last({v});
    if(removed[v])
      parts.remove(v);
  }
}

/// A quotient graph without spurs and stray components.
struct Pruned_quotient
{
  Skeleton_graph graph;
  // For each vertex of the quotient.
  std::vector<bool> is_stray;         ///< It consists of outliers.
  std::vector<std::size_t> vertex_of; ///< Of the graph; `no_vertex` if it was removed.
};

/// Part 3c: removes stray components, unless they may be fragments, spurs and caps. `components`
/// are the positions of the mixture components, `groups` those of each patch, and `pairs` the adjacent
/// patches. O(n log n) in practice.
inline Pruned_quotient prune(const Surface_quotient& quotient, const Patches& patches,
                             const std::vector<Patch_pair>& pairs,
                             const std::vector<Vector3>& components, const Patch_groups& groups,
                             const Curve_options& options)
{
  const Skeleton_graph& graph = quotient.graph;
  std::vector<double> weights(graph.vertices.size(), 0); // numbers of points
  std::vector<std::vector<Vector3>> points(graph.vertices.size());
  for(std::size_t i = 0; i < patches.size(); ++i) {
    const std::size_t v = quotient.vertex_of_patch[i];
    weights[v] += patches[i].weight;
    for(std::size_t k : groups[i])
      points[v].push_back(components[k]);
  }
  Pruned_quotient result;
  result.is_stray = stray_vertices(graph, weights, options.stray_share);
  const Measured_components curves(graph, weights);
  for(std::size_t v = 0; v < weights.size(); ++v) { // fragments may yet be joined
    const Curve_evidence& curve = curves.of(v).curve;
    if(curve.is_open() && curve.evidence() >= options.limb_evidence)
      result.is_stray[v] = false;
  }
  std::optional<Limb_roots> roots; // few shapes have branches that take a look at them
  const auto for_rings = [&](std::size_t junction, const std::vector<std::size_t>& limb,
                             const Spur_pruning::Visit_ring& visit) {
    if(quotient.piece_of[junction] == Surface_quotient::no_piece)
      return; // there is no root in a separator, nor in a twig
    if(!roots)
      roots.emplace(quotient, patches, pairs, components, groups);
    roots->for_rings(junction, limb, visit);
  };
  Surface_parts parts = surface_parts(quotient, patches, pairs, options.stray_share);
  std::vector<bool> removed = Spur_pruning(graph, points, options, for_rings, parts).spurs();
  for(std::size_t v = 0; v < removed.size(); ++v) {
    removed[v] = removed[v] || result.is_stray[v];
    if(removed[v])
      parts.remove(v);
  }
  mark_caps(graph, std::move(parts), removed);
  result.graph = without(graph, removed);
  result.vertex_of = indices_of_kept(removed);
  return result;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_PRUNE_H
