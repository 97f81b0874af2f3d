// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_LOOSE_ENDS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_LOOSE_ENDS_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Union_find.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Curve_evidence.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Skeleton_graph.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/two_edge_connected_components.h>

#include <algorithm>
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

/// The length of what was not seen from all sides.
struct Open_length
{
  double all = 0, loose = 0; ///< The latter is on no loop.
};

/// O(n log n).
inline Open_length open_length(const Skeleton_graph& graph)
{
  const std::vector<std::size_t> part = two_edge_connected_components(graph);
  Curve_evidence all, loose;
  for(const Skeleton_graph::Edge& e : graph.edges) {
    all.add(graph.vertices[e.first], graph.vertices[e.second]);
    if(part[e.first] != part[e.second])
      loose.add(graph.vertices[e.first], graph.vertices[e.second]);
  }
  return {all.open_length(), loose.open_length()};
}

/// Of what was not seen from all sides, the share of the length that is on no loop of a frame; 1 if
/// there is none, which is no evidence for loops. Where limbs are longer in the other reading, the
/// frame left twigs out, and what is loose is as much longer: the share may exceed 1. O(n log n).
inline double loose_open_share(const Skeleton_graph& frame, const Skeleton_graph& tree)
{
  const Open_length in_frame = open_length(frame);
  return in_frame.all > 0 ? in_frame.loose * (std::max)(in_frame.all, open_length(tree).all) /
                              (in_frame.all * in_frame.all)
                          : 1;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_LOOSE_ENDS_H
