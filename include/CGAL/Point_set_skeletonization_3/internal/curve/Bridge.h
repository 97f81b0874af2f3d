// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_BRIDGE_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_BRIDGE_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Union_find.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/minimum_spanning_forest.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Skeleton_graph.h>

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// An edge to be, between two vertices of a skeleton graph.
struct Bridge
{
  std::size_t a, b;
  double length;

  /// Shorter ones come first.
  bool operator<(const Bridge& other) const
  {
    return std::tie(length, a, b) < std::tie(other.length, other.a, other.b);
  }
};

/// Returns the bridge between two vertices.
inline Bridge bridge(std::size_t v, std::size_t w, const Skeleton_graph& graph)
{
  return {v, w, (graph.vertices[v].position - graph.vertices[w].position).norm()};
}

/// How long a limb is of which some points were seen, if they are as dense as those of vertex `w`,
/// at which it goes on. A few points in the air, far from each other, are no limb as long as they
/// are apart.
inline double length_seen(double points, std::size_t w, const Skeleton_graph& graph)
{
  return points * graph.vertices[w].resolution;
}

/// Returns the connected components as sets of vertices. O(n).
inline Union_find components_of(const Skeleton_graph& graph)
{
  Union_find result(graph.vertices.size());
  for(const Skeleton_graph::Edge& e : graph.edges)
    result.join(e.first, e.second);
  return result;
}

/// Adds the bridges of a minimum spanning forest of the components: the shorter first, and none
/// closes a cycle. O(n log n).
inline void add_forest(Skeleton_graph& graph, std::vector<Bridge> bridges)
{
  Union_find components = components_of(graph);
  bridges = minimum_spanning_forest(components, graph.vertices.size(), std::move(bridges));
  std::sort(bridges.begin(), bridges.end());
  for(const Bridge& added : bridges)
    graph.edges.emplace_back(added.a, added.b);
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_BRIDGE_H
