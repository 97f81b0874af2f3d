// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_EXTEND_OPEN_TIPS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_EXTEND_OPEN_TIPS_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Curve_options.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Skeleton_graph.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/refine_curve.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/Box_tree.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/K_nearest_neighbors.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Returns the path through some points to the furthest away from a ball that may be an end, by
/// shortest paths in the nearest-neighbour graph (Dijkstra); the first point is the one next to the
/// ball. Empty if there is none, or only behind a gap. O(n log n).
/// \param gap no two consecutive points are further apart
/// \param is_end tells for a point whether the path may end there
template <typename Is_end>
std::vector<Vector3> longest_path_from_ball(const Vector3& center, double radius,
                                            const std::vector<Vector3>& points, double gap,
                                            const Is_end& is_end)
{
  constexpr std::size_t neighbors = 8; // a ring around a point of a sheet
  constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const K_nearest_neighbors nearest =
    k_nearest_neighbors(Box_tree(points), neighbors + 1, Concurrency::sequential);
  std::vector<double> length(points.size(), infinity); // outside the ball
  std::vector<std::size_t> before(points.size(), none);
  using Reached = std::pair<double, std::size_t>;
  std::priority_queue<Reached, std::vector<Reached>, std::greater<Reached>> queue;
  for(std::size_t i = 0; i < points.size(); ++i)
    if((points[i] - center).norm() <= radius) {
      length[i] = 0;
      queue.push({0, i});
    }
  std::size_t last = none;
  while(!queue.empty()) {
    const auto [so_far, i] = queue.top();
    queue.pop();
    if(so_far > length[i])
      continue;
    if(before[i] != none && is_end(points[i]))
      last = i;
    for(const Neighbor& neighbor : nearest[i]) {
      const double step = std::sqrt(neighbor.squared_distance);
      if(step <= gap && so_far + step < length[neighbor.index]) {
        length[neighbor.index] = so_far + step;
        before[neighbor.index] = i;
        queue.push({so_far + step, neighbor.index});
      }
    }
  }
  std::vector<Vector3> path;
  for(; last != none && before[last] != none; last = before[last])
    path.push_back(points[last]);
  std::reverse(path.begin(), path.end());
  return path;
}

/// Continues limbs whose other side was not seen (leaves, twigs of a few points) to the end of
/// their points: no separator cuts the last piece of a limb, and there is no inside that a straight
/// continuation could stay in. The path leads through the points of the tip, ahead and without a
/// gap. O(n log n).
/// \param points the surface points of each vertex, without noise: it would lead beyond the end
/// \param spreads median distance of the points of each vertex that is centred on them
inline void extend_open_tips(Skeleton_graph& graph, const std::vector<std::vector<Vector3>>& points,
                             const std::vector<double>& spreads, const Curve_options& options)
{
  constexpr double half_width = 2; // spreads, of points that are spread evenly across
  const auto adjacency = graph.adjacency();
  for(std::size_t tip = 0; tip < adjacency.size(); ++tip) {
    if(adjacency[tip].size() != 1 || !is_open(graph.vertices[tip]) || points[tip].empty())
      continue;
    Skeleton_graph::Vertex vertex = graph.vertices[tip];
    const Vector3 direction = tip_direction(tip, graph, adjacency);
    const auto is_ahead = [&](const Vector3& p) {
      return direction.dot((p - vertex.position).normalized()) >= options.aligned;
    };
    const std::vector<Vector3> path = longest_path_from_ball(
      vertex.position, (std::max)(vertex.resolution, half_width * spreads[tip]), points[tip],
      options.thin_gap * vertex.resolution, is_ahead);
    std::size_t last = tip;
    for(const Vector3& position : path) {
      vertex.position = position;
      graph.edges.emplace_back(last, graph.vertices.size());
      last = graph.vertices.size();
      graph.vertices.push_back(vertex);
    }
  }
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_EXTEND_OPEN_TIPS_H
