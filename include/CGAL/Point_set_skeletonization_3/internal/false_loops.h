// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_FALSE_LOOPS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_FALSE_LOOPS_H

#include <CGAL/Point_set_skeletonization_3/internal/Connectivity.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface_quotient.h>
#include <CGAL/Point_set_skeletonization_3/internal/winding_number.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// The shortest path between two vertices, both included; empty if there is none.
inline std::vector<std::size_t> shortest_path(const Skeleton_graph& graph, std::size_t from,
                                              std::size_t to)
{
  constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  const auto adjacency = graph.adjacency();
  std::vector<std::size_t> before(graph.vertices.size(), none);
  using Step = std::tuple<double, std::size_t, std::size_t>; // distance, vertex, the one before
  std::priority_queue<Step, std::vector<Step>, std::greater<Step>> queue;
  queue.emplace(0, from, from);
  while(!queue.empty() && before[to] == none) {
    const Step step = queue.top();
    queue.pop();
    const std::size_t v = std::get<1>(step);
    if(before[v] != none)
      continue;
    before[v] = std::get<2>(step);
    for(std::size_t w : adjacency[v])
      if(before[w] == none)
        queue.emplace(std::get<0>(step) +
                        (graph.vertices[v].position - graph.vertices[w].position).norm(),
                      w, v);
  }
  std::vector<std::size_t> path;
  if(before[to] == none)
    return path;
  for(std::size_t v = to; v != from; v = before[v])
    path.push_back(v);
  path.push_back(from);
  return path;
}

/// Independent loops of a graph, each as its vertices in order.
inline std::vector<std::vector<std::size_t>> loops(const Skeleton_graph& graph)
{
  Connectivity connectivity(graph.vertices.size());
  Skeleton_graph forest{graph.vertices, {}};
  std::vector<std::vector<std::size_t>> result;
  for(const Skeleton_graph::Edge& e : graph.edges) {
    if(connectivity.join(e.first, e.second))
      forest.edges.push_back(e);
    else
      result.push_back(shortest_path(forest, e.first, e.second));
  }
  return result;
}

/// Whether there is air in a loop: a fan spanned into it leaves the solid. A loop around a hole of
/// the data does not: the winding number closes the hole.
inline bool encloses_air(const std::vector<std::size_t>& loop, const Skeleton_graph& graph,
                         const Winding_number& winding_number)
{
  constexpr double outside = 0.4; // 0.5 in the middle of a hole of the data, more behind it
  constexpr int steps = 16;       // a hole is wider than a sixteenth of the loop
  Vector3 center = Vector3::Zero();
  for(std::size_t v : loop)
    center += graph.vertices[v].position / static_cast<double>(loop.size());
  for(std::size_t v : loop)
    for(int step = 0; step < steps; ++step) {
      const double t = static_cast<double>(step) / steps;
      if(winding_number(center + t * (graph.vertices[v].position - center)) < outside)
        return true;
    }
  return false;
}

/// The surface quotient with the loops that enclose air only. Separators that make others - arcs
/// that end in holes of the data - are taken out of `separators`, the longest of a loop first.
inline Surface_quotient quotient_without_false_loops(const std::vector<Patch>& patches,
                                                     const std::vector<Sample>& samples,
                                                     const Winding_number& winding_number,
                                                     std::vector<Local_separator>& separators)
{
  for(;;) {
    Surface_quotient quotient = surface_quotient(patches, samples, separators);
    std::vector<std::size_t> wrong;
    for(const std::vector<std::size_t>& loop : loops(quotient.graph)) {
      if(encloses_air(loop, quotient.graph, winding_number))
        continue;
      std::size_t longest = separators.size();
      for(std::size_t v : loop) // vertices of separators come first
        if(v < separators.size() &&
           (longest == separators.size() || separators[v].length > separators[longest].length))
          longest = v;
      wrong.push_back(longest);
    }
    if(wrong.empty())
      return quotient;
    std::sort(wrong.begin(), wrong.end());
    wrong.erase(std::unique(wrong.begin(), wrong.end()), wrong.end());
    while(!wrong.empty()) {
      separators.erase(separators.begin() + static_cast<std::ptrdiff_t>(wrong.back()));
      wrong.pop_back();
    }
  }
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_FALSE_LOOPS_H
