// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_TWO_EDGE_CONNECTED_COMPONENTS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_TWO_EDGE_CONNECTED_COMPONENTS_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Union_find.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Skeleton_graph.h>

#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Returns the part of each vertex: an edge is a bridge, that is, its ends are not connected
/// without it, if and only if they are in different parts. O(n log n).
///
/// Each edge outside a spanning forest closes a cycle, which is one part. Done here because
/// `boost::biconnected_components()` makes the pruning take half as long again to compile.
inline std::vector<std::size_t> two_edge_connected_components(const Skeleton_graph& graph)
{
  const std::size_t size = graph.vertices.size();
  std::vector<std::vector<std::size_t>> edges_at(size);
  for(std::size_t e = 0; e < graph.edges.size(); ++e) {
    edges_at[graph.edges[e].first].push_back(e);
    edges_at[graph.edges[e].second].push_back(e);
  }
  // Vertices by their rank in the order of a breadth-first search: after their parents.
  constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();
  std::vector<std::size_t> rank(size, none), vertex_at, parent;
  std::vector<bool> is_in_forest(graph.edges.size(), false);
  const auto visit = [&](std::size_t v, std::size_t parent_of_v) {
    rank[v] = vertex_at.size();
    vertex_at.push_back(v);
    parent.push_back(parent_of_v);
  };
  for(std::size_t root = 0; root < size; ++root) {
    if(rank[root] != none)
      continue;
    visit(root, none);
    for(std::size_t r = rank[root]; r < vertex_at.size(); ++r)
      for(std::size_t e : edges_at[vertex_at[r]]) {
        const auto [v, w] = graph.edges[e];
        const std::size_t next = v == vertex_at[r] ? w : v;
        if(rank[next] != none)
          continue;
        visit(next, r);
        is_in_forest[e] = true;
      }
  }
  Union_find parts(size); // of ranks; the smallest of a part is nearest to the root
  for(std::size_t e = 0; e < graph.edges.size(); ++e) {
    if(is_in_forest[e])
      continue;
    std::size_t a = parts.find(rank[graph.edges[e].first]);
    std::size_t b = parts.find(rank[graph.edges[e].second]);
    while(a != b) {
      if(a < b)
        std::swap(a, b);
      parts.join(a, parent[a]);
      a = parts.find(a);
    }
  }
  std::vector<std::size_t> result;
  for(std::size_t r : rank)
    result.push_back(parts.find(r));
  return result;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_TWO_EDGE_CONNECTED_COMPONENTS_H
