// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_BLOCKS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_BLOCKS_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Union_find.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Skeleton_graph.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// The blocks of a graph: two edges are in one block if and only if a cycle leads through both.
struct Blocks
{
  std::vector<std::size_t> of_edge; ///< Of each edge, in their order; the numbers have gaps.
  std::vector<bool> is_bridge;      ///< Of each edge: no cycle leads through it.
};

/// Returns the blocks of a graph. O(n log n). \pre no edge joins a vertex to itself
///
/// Each edge outside a spanning forest closes a cycle, whose edges are in one block; that gives all
/// blocks, whatever the forest. Done here because `boost::biconnected_components()` makes the
/// pruning take half as long again to compile.
inline Blocks blocks_of(const Skeleton_graph& graph)
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
  // An edge of the forest is known by its lower end; the smallest of a block is at its top.
  const auto lower_end = [&](const Skeleton_graph::Edge& e) {
    return (std::max)(rank[e.first], rank[e.second]);
  };
  Union_find blocks(size);
  for(std::size_t e = 0; e < graph.edges.size(); ++e) {
    if(is_in_forest[e])
      continue;
    std::size_t a = rank[graph.edges[e].first], b = rank[graph.edges[e].second];
    while(a != b) {
      if(a < b)
        std::swap(a, b);
      const std::size_t above = parent[blocks.find(a)];
      blocks.join(a, lower_end(graph.edges[e]));
      a = above;
    }
  }
  Blocks result;
  std::vector<std::size_t> sizes(size, 0);
  for(const Skeleton_graph::Edge& e : graph.edges) {
    result.of_edge.push_back(blocks.find(lower_end(e)));
    ++sizes[result.of_edge.back()];
  }
  for(std::size_t block : result.of_edge)
    result.is_bridge.push_back(sizes[block] == 1);
  return result;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_BLOCKS_H
