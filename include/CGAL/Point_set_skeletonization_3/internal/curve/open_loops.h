// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_OPEN_LOOPS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_OPEN_LOOPS_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Union_find.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Curve_evidence.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Skeleton_graph.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// The vertices of a loop, in their order around it, each once.
using Loop = std::vector<std::size_t>;

/// Calls `visit(v, w)` for each edge of a loop. O(length of the loop).
template <typename Visit>
void visit_edges(const Loop& loop, const Visit& visit)
{
  for(std::size_t k = 0; k < loop.size(); ++k)
    visit(loop[k], loop[k + 1 < loop.size() ? k + 1 : 0]);
}

/// How well a loop was seen. O(length of the loop).
inline Curve_evidence evidence_along(const Loop& loop, const Skeleton_graph& graph)
{
  Curve_evidence result;
  visit_edges(loop, [&](std::size_t v, std::size_t w) {
    result.add(graph.vertices[v], graph.vertices[w]);
  });
  return result;
}

/// Whether there is room for a hole in a loop: it is wider than its limbs are thick, and than three
/// spacings. A limb that looks like two side by side, and two that touch twice, make loops without
/// one, and narrower holes are gaps between points.
///
/// The radius of a circle is twice its area over its length. The same ratio is that of any loop,
/// with the area of the triangles between its edges and its middle; it is small where a loop only
/// runs to and fro. It is compared with the mean radius at the separators: a sheet around a hole
/// may be much wider than the hole. O(length of the loop).
inline bool has_room_for_hole(const Loop& loop, const Skeleton_graph& graph)
{
  constexpr double no_hole = 1.5; // spacings: gaps in strips have up to 1.2, wire frames 40

  Vector3 middle = Vector3::Zero();
  double radii = 0, separators = 0;
  for(std::size_t v : loop) {
    const Skeleton_graph::Vertex& vertex = graph.vertices[v];
    middle += vertex.position / static_cast<double>(loop.size());
    if(vertex.is_cross_section) {
      radii += (std::max)(vertex.radius, no_hole * vertex.resolution);
      ++separators;
    }
  }
  double area = 0, length = 0;
  visit_edges(loop, [&](std::size_t v, std::size_t w) {
    const Vector3 &a = graph.vertices[v].position, &b = graph.vertices[w].position;
    area += (a - middle).cross(b - middle).norm() / 2;
    length += (b - a).norm();
  });
  return 2 * area * separators >= radii * length;
}

/// The edges of a skeleton graph that are added one by one, and the loops that they close.
class Loop_search
{
public:
  explicit Loop_search(std::size_t vertices) : adjacency_(vertices), before_(vertices, none) {}

  /// O(1).
  void add_vertex()
  {
    adjacency_.emplace_back();
    before_.push_back(none);
  }

  /// O(1).
  void add(const Skeleton_graph::Edge& edge)
  {
    adjacency_[edge.first].push_back(edge.second);
    adjacency_[edge.second].push_back(edge.first);
  }

  /// The loop of fewest edges that `edge` closes with those that were added; empty if there is
  /// none. Breadth-first search: O(vertices that are no further along the edges).
  Loop closed_by(const Skeleton_graph::Edge& edge)
  {
    const auto [from, to] = edge;
    std::vector<std::size_t> reached = {from};
    before_[from] = from;
    for(std::size_t next = 0; next < reached.size() && before_[to] == none; ++next)
      for(std::size_t w : adjacency_[reached[next]])
        if(before_[w] == none) {
          before_[w] = reached[next];
          reached.push_back(w);
        }
    Loop result;
    if(before_[to] != none) {
      for(std::size_t v = to; v != from; v = before_[v])
        result.push_back(v);
      result.push_back(from);
    }
    for(std::size_t v : reached)
      before_[v] = none;
    return result;
  }

private:
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  std::vector<std::vector<std::size_t>> adjacency_;
  std::vector<std::size_t> before_; ///< On the way from where a search began, during it.
};

/// Part 3c: returns the graph with loops opened where their evidence is least, unless
/// `is_kept(loop)`. Edges are added in the order of their evidence, that of the weaker end. Of one
/// that closes loops the shortest is asked: around a narrow hole, not the long way beside it.
/// O(n log n + loops times the vertices as near as their length).
template <typename IsKept>
Skeleton_graph with_loops_opened(Skeleton_graph graph, const IsKept& is_kept)
{
  const auto weaker_end = [&](const Skeleton_graph::Edge& e) {
    return (std::min)(graph.vertices[e.first].evidence, graph.vertices[e.second].evidence);
  };
  std::vector<Skeleton_graph::Edge> edges = graph.edges, opened;
  std::stable_sort(edges.begin(), edges.end(),
                   [&](const auto& a, const auto& b) { return weaker_end(a) > weaker_end(b); });
  Union_find sets(graph.vertices.size());
  Loop_search loops(graph.vertices.size());
  for(const Skeleton_graph::Edge& edge : edges)
    if(sets.join(edge.first, edge.second) || is_kept(loops.closed_by(edge)))
      loops.add(edge);
    else
      opened.push_back(edge);
  std::sort(opened.begin(), opened.end());
  const auto is_opened = [&](const Skeleton_graph::Edge& edge) {
    return std::binary_search(opened.begin(), opened.end(), edge);
  };
  graph.edges.erase(std::remove_if(graph.edges.begin(), graph.edges.end(), is_opened),
                    graph.edges.end());
  return graph;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_OPEN_LOOPS_H
