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

/// The loops of a skeleton graph that evidence closes last: each is closed by an edge that is not
/// in the maximum spanning forest of the evidence, and no edge of the loop has less.
class Weakest_loops
{
public:
  /// An edge has the evidence of its weaker end. Refers to the graph. O(n log n).
  explicit Weakest_loops(const Skeleton_graph& graph)
    : graph_(graph), parent_(graph.vertices.size(), none),
      depth_(graph.vertices.size(), 0)
  {
    std::vector<Skeleton_graph::Edge> edges = graph.edges;
    std::stable_sort(edges.begin(), edges.end(),
                     [&](const auto& a, const auto& b) { return weaker_end(a) > weaker_end(b); });
    Skeleton_graph forest;
    forest.vertices.resize(graph.vertices.size());
    Union_find sets(graph.vertices.size());
    for(const Skeleton_graph::Edge& e : edges)
      (sets.join(e.first, e.second) ? forest.edges : closing_).push_back(e);
    root(forest.adjacency());
  }

  /// The edges that close the loops, those of most evidence first.
  const std::vector<Skeleton_graph::Edge>& closing_edges() const { return closing_; }

  /// The loop that `edge` closes. O(length of the loop). \pre it is one of `closing_edges()`
  Loop loop(const Skeleton_graph::Edge& edge) const
  {
    Loop result, back;
    auto [v, w] = edge;
    while(v != w)
      if(depth_[v] >= depth_[w]) {
        result.push_back(v);
        v = parent_[v];
      } else {
        back.push_back(w);
        w = parent_[w];
      }
    result.push_back(v);
    result.insert(result.end(), back.rbegin(), back.rend());
    return result;
  }

private:
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  double weaker_end(const Skeleton_graph::Edge& e) const
  {
    return (std::min)(graph_.vertices[e.first].evidence, graph_.vertices[e.second].evidence);
  }

  /// Roots each tree of the forest, by breadth-first search.
  void root(const std::vector<std::vector<std::size_t>>& adjacency)
  {
    std::vector<std::size_t> reached;
    for(std::size_t start = 0; start < adjacency.size(); ++start) {
      if(parent_[start] != none)
        continue;
      parent_[start] = start;
      reached.assign(1, start);
      for(std::size_t next = 0; next < reached.size(); ++next)
        for(std::size_t w : adjacency[reached[next]])
          if(parent_[w] == none) {
            parent_[w] = reached[next];
            depth_[w] = depth_[reached[next]] + 1;
            reached.push_back(w);
          }
    }
  }

  const Skeleton_graph& graph_;
  std::vector<Skeleton_graph::Edge> closing_;
  std::vector<std::size_t> parent_, depth_; ///< In the forest.
};

/// Part 3c: returns the graph with loops opened where their evidence is least, unless
/// `is_kept(loop)`. O(n log n + loops times their length).
template <typename IsKept>
Skeleton_graph with_loops_opened(Skeleton_graph graph, const IsKept& is_kept)
{
  const Weakest_loops loops(graph);
  std::vector<Skeleton_graph::Edge> opened;
  for(const Skeleton_graph::Edge& edge : loops.closing_edges())
    if(!is_kept(loops.loop(edge)))
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
