// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_BRANCHES_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_BRANCHES_H


#include <CGAL/Point_set_skeletonization_3/internal/curve/Skeleton_graph.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Whether a branch is a cycle.
inline bool is_closed(const Branch& branch)
{
  return branch.size() > 1 && branch.front() == branch.back();
}

/// Returns the length of a branch.
inline double length(const Branch& branch, const Skeleton_graph& graph)
{
  double sum = 0;
  for(std::size_t i = 1; i < branch.size(); ++i)
    sum += (graph.vertices[branch[i]].position - graph.vertices[branch[i - 1]].position).norm();
  return sum;
}

/// Returns the vertex at arc length `s` of a branch, or its last vertex. O(length of the branch).
inline Skeleton_graph::Vertex point_at(double s, const Branch& branch, const Skeleton_graph& graph)
{
  for(std::size_t i = 1; i < branch.size(); ++i) {
    const Skeleton_graph::Vertex& a = graph.vertices[branch[i - 1]];
    const Skeleton_graph::Vertex& b = graph.vertices[branch[i]];
    const double length = (b.position - a.position).norm();
    if(s <= length && length > 0)
      return {a.position + s / length * (b.position - a.position),
              a.radius + s / length * (b.radius - a.radius), false};
    s -= length;
  }
  return graph.vertices[branch.back()];
}

/// Returns the path of vertices of degree 2 from `from` through its neighbour `to`, with its ends.
inline Branch follow(std::size_t from, std::size_t to,
                     const std::vector<std::vector<std::size_t>>& adjacency)
{
  Branch branch{from, to};
  while(adjacency[to].size() == 2 && to != branch.front()) {
    const std::size_t next = adjacency[to][0] == from ? adjacency[to][1] : adjacency[to][0];
    from = to;
    to = next;
    branch.push_back(to);
  }
  return branch;
}

/// Returns the branches of a graph without parallel edges, ordered by their first vertices, then
/// the cycles without junctions. O(n).
inline std::vector<Branch> branches(const Skeleton_graph& graph)
{
  const auto adjacency = graph.adjacency();
  std::vector<Branch> result;
  std::vector<bool> seen(graph.vertices.size(), false);
  const auto add = [&](const Branch& branch) {
    for(std::size_t v : branch)
      seen[v] = true;
    result.push_back(branch);
  };
  for(std::size_t v = 0; v < adjacency.size(); ++v) {
    if(adjacency[v].empty())
      add({v});
    if(adjacency[v].size() == 2)
      continue;
    for(std::size_t w : adjacency[v]) {
      const Branch branch = follow(v, w, adjacency);
      // Each branch is found from both ends: keep one of them.
      if(Branch(branch.rbegin(), branch.rend()) >= branch)
        add(branch);
    }
  }
  for(std::size_t v = 0; v < adjacency.size(); ++v) // cycles without a junction
    if(!seen[v])
      add(follow(v, adjacency[v][0], adjacency));
  return result;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_BRANCHES_H
