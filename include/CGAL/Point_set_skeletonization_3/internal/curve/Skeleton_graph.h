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

/// The vertices of a branch in order, between vertices whose degree is not 2. A closed branch
/// repeats its first vertex at the end; an isolated vertex is a branch.
using Branch = std::vector<std::size_t>;

/// A curve skeleton in normalised coordinates.
struct Skeleton_graph
{
  struct Vertex
  {
    Vector3 position = Vector3::Zero();
    double radius = 0;
    double resolution = 0; ///< Typical distance of the surface points around.
    bool is_cross_section = false; ///< Represents a separator, not a piece in between.
    bool is_on_line = false; ///< A cross-section that stays where it is: a point of a twig, or a
                             ///< place in the middle of points of a limb that is not resolved,
                             ///< unless they are on one side of a circle.
    double evidence = 0; ///< For a limb there, in [0, 1], see `Limb_evidence`.
    double open = 0; ///< Share of the patches around it whose other side was not seen, in [0, 1].
    double half_width = 0; ///< Mean distance of the patches around it.
    double facing = 0; ///< Share of the patches around it that face another limb, in [0, 1]: what is
                       ///< between is not their limb.
  };
  using Edge = std::pair<std::size_t, std::size_t>;

  std::vector<Vertex> vertices;
  std::vector<Edge> edges;

  /// Returns the neighbours of each vertex, in the order of the edges. O(n).
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

/// Half the distance of the points of a line, in distances to the fifth neighbour, which is the
/// second or third of one side.
constexpr double half_a_spacing = 0.2;

/// Returns the positions of the vertices, in the same order. O(n).
inline std::vector<Vector3> positions_of(const Skeleton_graph& graph)
{
  std::vector<Vector3> result;
  result.reserve(graph.vertices.size());
  for(const Skeleton_graph::Vertex& vertex : graph.vertices)
    result.push_back(vertex.position);
  return result;
}

/// Whether the other side of most of the limb around a vertex was not seen: it is a sheet, scattered
/// or a line.
inline bool is_open(const Skeleton_graph::Vertex& vertex)
{
  return vertex.open > 0.5;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_SKELETON_GRAPH_H
