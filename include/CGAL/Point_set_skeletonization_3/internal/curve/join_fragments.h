// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_JOIN_FRAGMENTS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_JOIN_FRAGMENTS_H

#include <CGAL/Point_set_skeletonization_3/internal/curve/Bridge.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Curve_options.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Measured_components.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Skeleton_graph.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/Box_tree.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Returns the bridges from fragments to what they are pieces of.
/// \param points number of points of each vertex
inline std::vector<Bridge> bridges_of_fragments(const Skeleton_graph& graph,
                                                const std::vector<double>& points,
                                                const Curve_options& options)
{
  const Measured_components components(graph, points);
  const auto is_fragment_of = [&](const Component& a, const Component& b) {
    return a.curve.is_open() && a.points < options.fragment_share * b.points;
  };
  const Component& largest = components.largest();
  double longest = 0;
  for(std::size_t v = 0; v < graph.vertices.size(); ++v)
    if(is_fragment_of(components.of(v), largest))
      longest = (std::max)(longest, components.of(v).curve.length());
  std::vector<Bridge> bridges;
  if(longest == 0)
    return bridges;
  const std::vector<Vector3> positions = positions_of(graph);
  const Box_tree places(positions);
  const std::vector<std::vector<std::size_t>> adjacency = graph.adjacency();
  for(std::size_t v = 0; v < adjacency.size(); ++v) {
    if(adjacency[v].size() != 1)
      continue;
    const Component& a = components.of(v);
    places.visit_within(positions[v], longest, [&](std::size_t k, double) {
      const std::size_t w = places.order()[k];
      if(components.are_connected(v, w))
        return;
      const Component& b = components.of(w);
      const Bridge gap = bridge(v, w, graph);
      if((is_fragment_of(a, b) && gap.length < a.curve.length()) ||
         (is_fragment_of(b, a) && gap.length < b.curve.length()))
        bridges.push_back(gap);
    });
  }
  return bridges;
}

/// Part 3d: joins fragments, pieces of limbs behind something that hid the rest from the scanner,
/// to what they are near. A fragment was not seen from all sides (what was is complete), has few
/// points beside the component that it is joined to, and is longer than the gap. Components count
/// as they are, without what is joined to them: otherwise a forest would grow together. The bridges
/// lead from a tip, the shorter ones come first, and none closes a cycle. O(n log n), times the
/// vertices within the length of the longest fragment.
/// \param points number of points of each vertex
inline void join_fragments(Skeleton_graph& graph, const std::vector<double>& points,
                           const Curve_options& options)
{
  add_forest(graph, bridges_of_fragments(graph, points, options));
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_JOIN_FRAGMENTS_H
