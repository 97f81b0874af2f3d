// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_JOIN_FRAGMENTS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_JOIN_FRAGMENTS_H

#include <CGAL/Point_set_skeletonization_3/internal/curve/Bridge.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Curve_options.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Measured_components.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Skeleton_graph.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/longest_path.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/Box_tree.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Which components of a skeleton graph are fragments: pieces of limbs, whose rest is behind
/// something that hid it from the scanner.
class Fragments
{
public:
  /// Refers to the graph and the options.
  /// \param points number of points of each vertex
  Fragments(const Skeleton_graph& graph, const std::vector<double>& points,
            const Curve_options& options)
    : options_(options), graph_(graph), components_(graph, points), adjacency_(graph.adjacency()),
      span_(graph.vertices.size(), 0)
  {
    for(std::size_t v = 0; v < span_.size(); ++v) {
      const Component& component = components_.of(v);
      if(components_.representative(v) == v && component.curve.is_open() &&
         component.points < options.fragment_share * components_.largest().points)
        span_[v] = longest_path(v, graph, adjacency_);
    }
  }

  /// Returns the shortest bridge from each fragment to what it is a piece of. They lead from a tip
  /// to any vertex, or back.
  std::vector<Bridge> bridges() const
  {
    const auto longest = std::max_element(span_.begin(), span_.end());
    if(longest == span_.end() || *longest == 0)
      return {};
    const double widest = options_.fragment_gap * *longest;
    const std::vector<Vector3> positions = positions_of(graph_);
    const Box_tree places(positions);
    std::vector<Bridge> nearest(graph_.vertices.size(), {0, 0, widest}); // at the representative
    const auto offer = [&](const Bridge& gap, std::size_t from, std::size_t to) {
      Bridge& best = nearest[components_.representative(from)];
      if(gap < best && gap.length < options_.fragment_gap * span_seen(from, to) &&
         is_fragment_of(from, to))
        best = gap;
    };
    for(std::size_t v = 0; v < adjacency_.size(); ++v)
      if(adjacency_[v].size() == 1)
        places.visit_within(positions[v], widest, [&](std::size_t k, double) {
          const std::size_t w = places.order()[k];
          offer(bridge(v, w, graph_), v, w);
          offer(bridge(v, w, graph_), w, v);
        });
    nearest.erase(std::remove_if(nearest.begin(), nearest.end(),
                                 [](const Bridge& gap) { return gap.a == gap.b; }),
                  nearest.end());
    return nearest;
  }

private:
  /// Longest path in the component of a vertex; 0 if that is no fragment.
  double span(std::size_t v) const { return span_[components_.representative(v)]; }

  /// The same, of what vertex `w` is a part of.
  double span_seen(std::size_t v, std::size_t w) const
  {
    return (std::min)(span(v), length_seen(components_.of(v).points, w, graph_));
  }

  /// Whether the component of `v` is a fragment of that of `w`: it has few points, fewer the more
  /// it branches. Its length, in lengths of its longest path, is about how many limbs it has.
  bool is_fragment_of(std::size_t v, std::size_t w) const
  {
    const Component& a = components_.of(v);
    return a.points * a.curve.length() <
           options_.fragment_share * span(v) * components_.of(w).points;
  }

  const Curve_options& options_;
  const Skeleton_graph& graph_;
  Measured_components components_;
  std::vector<std::vector<std::size_t>> adjacency_;
  std::vector<double> span_; ///< At each representative.
};

/// Part 3d: joins fragments, pieces of limbs behind something that hid the rest from the scanner,
/// each to the nearest component that it may be a piece of. A fragment was not seen from all sides
/// (what was is complete), has few points beside the component that it is joined to (fewer the more
/// it branches, as a tree of its own does), and the gap is not much longer than what is seen of it,
/// see `length_seen()`. Since each is joined to one, none joins two trees of a forest that it hangs
/// between; since that one has more points, none closes a cycle. O(n log n), times the vertices
/// within the greatest gap.
/// \param points number of points of each vertex
inline void join_fragments(Skeleton_graph& graph, const std::vector<double>& points,
                           const Curve_options& options)
{
  for(const Bridge& added : Fragments(graph, points, options).bridges())
    graph.edges.emplace_back(added.a, added.b);
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_JOIN_FRAGMENTS_H
