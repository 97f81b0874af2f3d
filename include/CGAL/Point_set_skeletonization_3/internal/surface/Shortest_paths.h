// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_SHORTEST_PATHS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_SHORTEST_PATHS_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Progress.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch_graph.h>

#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Shortest paths along the edges of a patch graph (Dijkstra). One object makes one search after
/// the other; the time of each depends on the patches that it reaches only.
class Shortest_paths
{
public:
  using Reached = std::pair<double, std::size_t>; ///< Distance, patch.

  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  /// Refers to the graph. O(n).
  Shortest_paths(const Patch_graph& graph, std::size_t patches)
    : graph_(graph), distance_(patches, infinity), before_(patches, none)
  {}

  /// Finds the shortest paths from a start through the patches with `is_inside(i)`, and forgets
  /// those before. Returns the patches reached, the nearest first. O(m log m), m their edges.
  template <typename IsInside>
  const std::vector<std::size_t>& spread(const std::vector<Reached>& start,
                                         const IsInside& is_inside)
  {
    for(std::size_t i : order_)
      distance_[i] = infinity;
    order_.clear();
    std::priority_queue<Reached, std::vector<Reached>, std::greater<Reached>> queue;
    const auto reach = [&](double distance, std::size_t i, std::size_t before) {
      if(distance < distance_[i] && is_inside(i)) {
        distance_[i] = distance;
        before_[i] = before;
        queue.push({distance, i});
      }
    };
    for(const auto& [distance, i] : start)
      reach(distance, i, none);
    while(!queue.empty()) {
      const auto [distance, i] = queue.top();
      queue.pop();
      if(distance > distance_[i])
        continue; // a shorter path was found
      Progress::poll();
      order_.push_back(i);
      for(const auto& edge : graph_[i])
        reach(distance + static_cast<double>(edge.length), edge.patch, i);
    }
    return order_;
  }

  /// Whether the last search has reached a patch.
  bool is_reached(std::size_t i) const { return distance_[i] < infinity; }

  /// Length of the path to a patch; infinite if the last search has not reached it.
  double distance(std::size_t i) const { return distance_[i]; }

  /// The patch before one that was reached, on the path to it; `none` if the search started there.
  std::size_t before(std::size_t i) const { return before_[i]; }

private:
  const Patch_graph& graph_;
  std::vector<double> distance_;
  std::vector<std::size_t> before_; ///< Only of patches reached.
  std::vector<std::size_t> order_;  ///< In which patches were reached.
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_SHORTEST_PATHS_H
