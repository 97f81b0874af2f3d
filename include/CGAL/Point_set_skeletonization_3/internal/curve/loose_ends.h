// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_LOOSE_ENDS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_LOOSE_ENDS_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Union_find.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Curve_evidence.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Skeleton_graph.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/two_edge_connected_components.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Number of free ends. O(n).
inline std::size_t number_of_tips(const Skeleton_graph& graph)
{
  std::size_t result = 0;
  for(const std::vector<std::size_t>& neighbors : graph.adjacency())
    result += neighbors.size() == 1 ? 1 : 0;
  return result;
}

/// Number of independent loops. O(n).
inline std::size_t number_of_loops(const Skeleton_graph& graph)
{
  Union_find sets(graph.vertices.size());
  std::size_t result = 0;
  for(const Skeleton_graph::Edge& e : graph.edges)
    result += sets.join(e.first, e.second) ? 0 : 1;
  return result;
}

/// Of what was not seen from all sides, the share of the length that is on no loop, in [0, 1]; 1 if
/// there is none, which is no evidence for loops. O(n log n).
inline double loose_open_share(const Skeleton_graph& graph)
{
  const std::vector<std::size_t> part = two_edge_connected_components(graph);
  Curve_evidence all, loose;
  for(const Skeleton_graph::Edge& e : graph.edges) {
    all.add(graph.vertices[e.first], graph.vertices[e.second]);
    if(part[e.first] != part[e.second])
      loose.add(graph.vertices[e.first], graph.vertices[e.second]);
  }
  return all.open_length() > 0 ? loose.open_length() / all.open_length() : 1;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_LOOSE_ENDS_H
