// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_LOOP_CLOSING_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_LOOP_CLOSING_H

#include <CGAL/Point_set_skeletonization_3/internal/Skeleton_graph.h>
#include <CGAL/Point_set_skeletonization_3/internal/skeleton_branches.h>
#include <CGAL/Point_set_skeletonization_3/internal/solid_side.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// The path between two vertices of a forest.
inline std::vector<std::size_t> forest_path(std::size_t from, std::size_t to,
                                            const std::vector<std::vector<std::size_t>>& forest)
{
  std::vector<std::size_t> previous(forest.size(), forest.size()), front{from};
  previous[from] = from;
  for(std::size_t k = 0; k < front.size() && previous[to] == forest.size(); ++k)
    for(std::size_t v : forest[front[k]])
      if(previous[v] == forest.size()) {
        previous[v] = front[k];
        front.push_back(v);
      }
  std::vector<std::size_t> path{to};
  while(path.back() != from)
    path.push_back(previous[path.back()]);
  return path;
}

/// An edge of a loop that is blocked more than this leads through a contact of two limbs. A tube
/// blocks its axis hardly, a bend or a junction on the way to a third.
constexpr double contact = 0.4;

/// The points of a closed curve half a turn away from its vertices, with their radii.
inline std::vector<Skeleton_graph::Vertex> half_a_turn_away(const std::vector<std::size_t>& loop,
                                                            const Skeleton_graph& graph)
{
  Branch twice(loop.begin(), loop.end());
  twice.insert(twice.end(), loop.begin(), loop.end());
  twice.push_back(loop.front());
  const double half = length(twice, graph) / 4;
  std::vector<Skeleton_graph::Vertex> result;
  double s = 0;
  for(std::size_t k = 0; k < loop.size(); ++k) {
    result.push_back(point_at(s + half, twice, graph));
    s += (graph.vertices[twice[k + 1]].position - graph.vertices[twice[k]].position).norm();
  }
  return result;
}

/// Whether opposite balls of a closed curve keep clear of each other. Around a hole they do: there
/// is the hole between them. A curve that runs back along itself is no loop.
inline bool is_open(const std::vector<std::size_t>& loop, const Skeleton_graph& graph,
                    double spacing)
{
  constexpr double overlap = 0.75; // balls of patches, not of points, may overlap a little
  const std::vector<Skeleton_graph::Vertex> opposite = half_a_turn_away(loop, graph);
  for(std::size_t k = 0; k < loop.size(); ++k) {
    const Skeleton_graph::Vertex& v = graph.vertices[loop[k]];
    // A hole narrower than half a patch cannot be seen.
    if((v.position - opposite[k].position).norm() <
       overlap * (v.radius + opposite[k].radius) + spacing / 2)
      return false;
  }
  return true;
}

/// Whether a closed curve goes around air. Every surface that spans the loop of a solid leaves the
/// solid; so if only one - here the fan from the centre of gravity - stays in it, the loop can be
/// contracted and is none.
inline bool spans_air(const std::vector<std::size_t>& loop, const Skeleton_graph& graph,
                      const Solid_side& side)
{
  if(!is_open(loop, graph, side.spacing()))
    return false;
  Vector3 center = Vector3::Zero();
  for(std::size_t v : loop)
    center += graph.vertices[v].position / static_cast<double>(loop.size());
  for(std::size_t k = 0; k < loop.size(); ++k) {
    const Vector3& a = graph.vertices[loop[k]].position;
    const Vector3& b = graph.vertices[loop[(k + 1) % loop.size()]].position;
    if(side.leaves_solid(a, center) || side.leaves_solid((a + b) / 2, center))
      return true;
  }
  return false;
}

/// The edge of a loop that is blocked most, and how much. Edges shorter than half a patch do not
/// count: their middle is as good as their ends.
inline std::pair<Skeleton_graph::Edge, double> most_blocked(const std::vector<std::size_t>& loop,
                                                            const Skeleton_graph& graph,
                                                            const Solid_side& side)
{
  std::pair<Skeleton_graph::Edge, double> worst{{0, 0}, 0};
  for(std::size_t k = 0; k < loop.size(); ++k) {
    const std::size_t u = loop[k], v = loop[(k + 1) % loop.size()];
    const Vector3& a = graph.vertices[u].position;
    const Vector3& b = graph.vertices[v].position;
    const double blocked = (b - a).norm() > side.spacing() / 2 ? side.blocked(a, b) : 0;
    if(blocked > worst.second)
      worst = {{std::min(u, v), std::max(u, v)}, blocked};
  }
  return worst;
}

/// Adds to a forest the edges that close loops around air. A loop through a contact is opened
/// there, which may be anywhere on it, and not where it happened to be closed.
inline void close_loops(Skeleton_graph& graph, const std::vector<Skeleton_graph::Edge>& closing,
                        const Solid_side& side)
{
  std::vector<Skeleton_graph::Edge> loops;
  for(const Skeleton_graph::Edge& e : closing) {
    const std::vector<std::size_t> loop = forest_path(e.first, e.second, graph.adjacency());
    if(!spans_air(loop, graph, side))
      continue;
    const auto worst = most_blocked(loop, graph, side);
    if(worst.second <= contact)
      loops.push_back(e);
    else
      std::replace(graph.edges.begin(), graph.edges.end(), worst.first, e); // if it is not e itself
  }
  graph.edges.insert(graph.edges.end(), loops.begin(), loops.end());
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_LOOP_CLOSING_H
