// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_DOUBLED_TIPS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_DOUBLED_TIPS_H

#include <CGAL/Point_set_skeletonization_3/internal/curve/Skeleton_graph.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/branches.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/refine_curve.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/Box_tree.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Finds the tips of a centred skeleton that are in limbs which have a curve already.
class Doubled_tips
{
public:
  /// Refers to the graph. O(n log n).
  explicit Doubled_tips(const Skeleton_graph& graph)
    : graph_(graph), adjacency_(graph.adjacency()), positions_(positions_of(graph)),
      places_(positions_), way_(graph.vertices.size(), not_on_branch),
      is_doubled_(graph.vertices.size(), false)
  {}

  /// Marks the vertices from each tip up to where the curve is the only one. To be called once.
  /// O(n log n), times the vertices within half a radius.
  std::vector<bool> run()
  {
    for(std::size_t v = 0; v < adjacency_.size(); ++v)
      if(adjacency_[v].size() == 1)
        mark_from(v);
    return is_doubled_;
  }

private:
  static constexpr double not_on_branch = std::numeric_limits<double>::infinity();

  void mark_from(std::size_t tip)
  {
    const Branch branch = follow(tip, adjacency_[tip][0], adjacency_);
    double way = 0;
    for(std::size_t k = 0; k < branch.size(); ++k) {
      way += k > 0 ? (positions_[branch[k]] - positions_[branch[k - 1]]).norm() : 0;
      way_[branch[k]] = way;
    }
    for(std::size_t k = 0; k + 1 < branch.size() && is_beside_another(branch[k]); ++k)
      is_doubled_[branch[k]] = true;
    for(std::size_t v : branch)
      way_[v] = not_on_branch;
  }

  /// Whether another curve runs through the core of the limb at a vertex, and the vertex is in the
  /// core of the limb of that: the curve of another branch, or its own on the way back.
  bool is_beside_another(std::size_t v) const
  {
    constexpr double core = 0.5, back = 3; // radii
    const double radius = graph_.vertices[v].radius;
    bool result = false;
    places_.visit_within(positions_[v], core * radius, [&](std::size_t k, double squared) {
      const std::size_t w = places_.order()[k];
      const double other_core = core * graph_.vertices[w].radius;
      result = result || (!is_doubled_[w] && std::abs(way_[w] - way_[v]) > back * radius &&
                          squared < other_core * other_core);
    });
    return result;
  }

  const Skeleton_graph& graph_;
  std::vector<std::vector<std::size_t>> adjacency_;
  std::vector<Vector3> positions_;
  Box_tree places_;
  std::vector<double> way_; ///< From the tip, of the vertices on its branch.
  std::vector<bool> is_doubled_;
};

/// Part 3d: marks the vertices of a centred skeleton that end in the core of a limb along which
/// another curve runs. Of a limb whose sides were seen from different places, with gaps between
/// them, each may have a curve. Centred, both are on its axis: one of them is enough. O(n log n),
/// times the vertices within half a radius.
inline std::vector<bool> doubled_tips(const Skeleton_graph& graph)
{
  return Doubled_tips(graph).run();
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_DOUBLED_TIPS_H
