// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_LONGEST_PATH_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_LONGEST_PATH_H

#include <CGAL/Point_set_skeletonization_3/internal/curve/Skeleton_graph.h>

#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Returns the vertex of the component of `from` that is farthest from it along the edges, and its
/// distance. Dijkstra: O(k log k) for a component of k vertices.
inline std::pair<std::size_t, double>
farthest_vertex(std::size_t from, const Skeleton_graph& graph,
                const std::vector<std::vector<std::size_t>>& adjacency)
{
  std::map<std::size_t, double> distances = {{from, 0.}};
  std::set<std::pair<double, std::size_t>> front = {{0., from}};
  std::pair<double, std::size_t> last;
  while(!front.empty()) {
    last = *front.begin();
    front.erase(front.begin());
    const auto [distance, v] = last;
    for(const std::size_t w : adjacency[v]) {
      const double over_v =
        distance + (graph.vertices[v].position - graph.vertices[w].position).norm();
      const auto [known, is_new] = distances.emplace(w, over_v);
      if(!is_new) {
        if(known->second <= over_v)
          continue;
        front.erase({known->second, w});
        known->second = over_v;
      }
      front.emplace(over_v, w);
    }
  }
  return {last.second, last.first};
}

/// Returns the length of the longest shortest path in the component of a vertex: from one end to
/// the farthest other one. Exact without cycles, at most too short with them. O(k log k) for a
/// component of k vertices.
inline double longest_path(std::size_t v, const Skeleton_graph& graph,
                           const std::vector<std::vector<std::size_t>>& adjacency)
{
  const std::size_t end = farthest_vertex(v, graph, adjacency).first;
  return farthest_vertex(end, graph, adjacency).second;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_LONGEST_PATH_H
