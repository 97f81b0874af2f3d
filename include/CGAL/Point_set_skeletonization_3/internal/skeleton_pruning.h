// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SKELETON_PRUNING_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SKELETON_PRUNING_H

#include <CGAL/Point_set_skeletonization_3/internal/skeleton_branches.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// A limb's end reaches out of every other ball of the skeleton by this factor; less is a bump of
/// the surface, or what is left of a thick body's medial sheet.
constexpr double prominence = 1.25;

/// The graph without the vertices marked `removed` and their edges; the order of the rest is kept.
inline Skeleton_graph without(const Skeleton_graph& graph, const std::vector<bool>& removed)
{
  std::vector<std::size_t> index(graph.vertices.size(), 0);
  Skeleton_graph result;
  for(std::size_t v = 0; v < graph.vertices.size(); ++v)
    if(!removed[v]) {
      index[v] = result.vertices.size();
      result.vertices.push_back(graph.vertices[v]);
    }
  for(const Skeleton_graph::Edge& e : graph.edges)
    if(!removed[e.first] && !removed[e.second])
      result.edges.emplace_back(index[e.first], index[e.second]);
  return result;
}

/// How far a branch that hangs on a junction reaches out of the balls of all other vertices, in
/// radii of the ball that holds it best; infinite for branches between two junctions or two ends.
inline double branch_prominence(const Branch& branch, const Skeleton_graph& graph,
                                const std::vector<std::vector<std::size_t>>& adjacency)
{
  constexpr double none = std::numeric_limits<double>::infinity();
  const std::size_t a = branch.front(), b = branch.back();
  const bool ends_at_a = adjacency[a].size() == 1 && adjacency[b].size() > 2;
  const bool ends_at_b = adjacency[b].size() == 1 && adjacency[a].size() > 2;
  if(!ends_at_a && !ends_at_b)
    return none;
  const Skeleton_graph::Vertex& end = graph.vertices[ends_at_a ? a : b];
  std::vector<bool> in_branch(graph.vertices.size(), false);
  for(std::size_t v : branch)
    in_branch[v] = adjacency[v].size() < 3;
  double least = none;
  for(std::size_t v = 0; v < graph.vertices.size(); ++v)
    if(!in_branch[v] && graph.vertices[v].radius > 0)
      least = std::min(least, ((end.position - graph.vertices[v].position).norm() + end.radius) /
                                graph.vertices[v].radius);
  return least;
}

/// Removes spurs, the least prominent first, until every end reaches out of its junction: removing
/// one may turn its junction into a plain vertex and two short branches into a long one.
inline Skeleton_graph pruned(Skeleton_graph graph)
{
  for(;;) {
    const auto adjacency = graph.adjacency();
    double least = prominence;
    Branch spur;
    for(const Branch& branch : branches(graph)) {
      const double p = branch_prominence(branch, graph, adjacency);
      if(p < least) {
        least = p;
        spur = branch;
      }
    }
    if(spur.empty())
      return graph;
    std::vector<bool> removed(graph.vertices.size(), false);
    for(std::size_t v : spur)
      removed[v] = adjacency[v].size() < 3;
    graph = without(graph, removed);
  }
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SKELETON_PRUNING_H
