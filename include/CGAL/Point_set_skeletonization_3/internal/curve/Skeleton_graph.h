// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_SKELETON_GRAPH_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_SKELETON_GRAPH_H


#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// The vertices of a branch in order, from end or junction to end or junction. A closed branch
/// names its first vertex again at its end; a single vertex is an isolated one.
using Branch = std::vector<std::size_t>;

/// A curve skeleton in normalised coordinates, as the linkers hand it on.
struct Skeleton_graph
{
  struct Vertex
  {
    Vector3 position = Vector3::Zero();
    double radius = 0;
    bool is_cross_section = false; ///< It stands for a separator, not for a piece between them.
  };
  using Edge = std::pair<std::size_t, std::size_t>;

  std::vector<Vertex> vertices;
  std::vector<Edge> edges;

  /// Neighbours of every vertex, in the order of the edges.
  std::vector<std::vector<std::size_t>> adjacency() const
  {
    std::vector<std::vector<std::size_t>> result(vertices.size());
    for(const Edge& e : edges) {
      result[e.first].push_back(e.second);
      result[e.second].push_back(e.first);
    }
    return result;
  }
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_SKELETON_GRAPH_H
