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

  /// How well the loop that `edge` closes was seen. O(length of the loop).
  /// \pre it is one of `closing_edges()`
  Curve_evidence loop(const Skeleton_graph::Edge& edge) const
  {
    Curve_evidence result;
    auto [v, w] = edge;
    result.add(graph_.vertices[v], graph_.vertices[w]);
    while(v != w) {
      if(depth_[v] < depth_[w])
        std::swap(v, w);
      result.add(graph_.vertices[v], graph_.vertices[parent_[v]]);
      v = parent_[v];
    }
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
/// `is_kept(loop)` for the `Curve_evidence` along them. O(n log n + loops times their length).
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
