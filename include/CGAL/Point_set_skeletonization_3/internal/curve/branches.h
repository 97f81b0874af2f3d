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

/// Returns the vertex at the share `t` in [0, 1] of the way from `a` to `b`.
inline Skeleton_graph::Vertex between(const Skeleton_graph::Vertex& a,
                                      const Skeleton_graph::Vertex& b, double t)
{
  const auto mean = [t](double x, double y) { return x + t * (y - x); };
  Skeleton_graph::Vertex result{Vector3(a.position + t * (b.position - a.position)),
                                mean(a.radius, b.radius),
                                mean(a.resolution, b.resolution),
                                true,
                                a.is_on_line && b.is_on_line,
                                mean(a.evidence, b.evidence),
                                mean(a.open, b.open)};
  result.facing = mean(a.facing, b.facing);
  return result;
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
