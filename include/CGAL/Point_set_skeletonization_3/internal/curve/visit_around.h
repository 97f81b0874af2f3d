// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_VISIT_AROUND_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_VISIT_AROUND_H

#include <CGAL/Point_set_skeletonization_3/internal/curve/Skeleton_graph.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Calls `visit(u, way)` for the vertices connected with `v`, itself first, in the order of their
/// distance along the graph (Dijkstra 1959), until it returns false. O(m^2) for m visited.
/// \param adjacency of the graph
/// \param leads `leads(u, w)` tells whether the way goes on from u to its neighbour w
template <typename Leads, typename Visit>
void visit_around(const Skeleton_graph& graph,
                  const std::vector<std::vector<std::size_t>>& adjacency, std::size_t v,
                  const Leads& leads, const Visit& visit)
{
  using Reached = std::pair<double, std::size_t>;
  std::priority_queue<Reached, std::vector<Reached>, std::greater<Reached>> reached;
  std::vector<std::size_t> visited;
  reached.emplace(0, v);
  while(!reached.empty()) {
    const auto [way, u] = reached.top();
    reached.pop();
    if(std::find(visited.begin(), visited.end(), u) != visited.end())
      continue;
    visited.push_back(u);
    if(!visit(u, way))
      return;
    for(std::size_t w : adjacency[u])
      if(leads(u, w))
        reached.emplace(way + (graph.vertices[u].position - graph.vertices[w].position).norm(),
                        w);
  }
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_VISIT_AROUND_H
