// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_LOOSE_ENDS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_LOOSE_ENDS_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Union_find.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Blocks.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Curve_evidence.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Skeleton_graph.h>

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

/// What was seen along all edges. O(n).
inline Curve_evidence evidence_along(const Skeleton_graph& graph)
{
  Curve_evidence result;
  for(const Skeleton_graph::Edge& e : graph.edges)
    result.add(graph.vertices[e.first], graph.vertices[e.second]);
  return result;
}

/// Of what was not seen from all sides, the share of the length that is on no loop of a frame; 1 if
/// there is none, which is no evidence for loops. Where the tree is longer, the frame left twigs
/// out, and what is loose counts as many times more: the share may exceed 1. O(n log n).
inline double loose_open_share(const Skeleton_graph& frame, const Skeleton_graph& tree)
{
  const Curve_evidence all = evidence_along(frame);
  if(all.open_length() == 0)
    return 1;
  const Blocks blocks = blocks_of(frame);
  Curve_evidence loose;
  for(std::size_t e = 0; e < frame.edges.size(); ++e)
    if(blocks.is_bridge[e])
      loose.add(frame.vertices[frame.edges[e].first], frame.vertices[frame.edges[e].second]);
  const double left_out = (std::max)(1.0, evidence_along(tree).length() / all.length());
  return left_out * loose.open_length() / all.open_length();
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_LOOSE_ENDS_H
