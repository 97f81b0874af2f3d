// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_LIMB_ROOTS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_LIMB_ROOTS_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/surface_quotient.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch_graph.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch_groups.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Shortest_paths.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// The roots of limbs: a limb goes on beyond its last separator, in the piece that it sticks out of,
/// up to where another limb begins. Separators are disjoint and few, so that a short limb may have a
/// single one, near its tip. Fronts around a handle divide the piece for the curve only.
class Limb_roots
{
public:
  /// Refers to all arguments. O(n).
  /// \param components surface points, and `groups` those of each patch
  Limb_roots(const Surface_quotient& quotient, const Patches& patches,
             const std::vector<Patch_pair>& pairs, const std::vector<Vector3>& components,
             const Patch_groups& groups)
    : quotient_(quotient), patches_(patches), components_(components), groups_(groups),
      graph_(patches, pairs), paths_(graph_, patches.size())
  {}

  /// Calls `visit(ring, root)` for rings around a limb in a piece, the furthest first: the points
  /// of the ring, and those of the piece from the limb to the ring, with it. A ring near the limb
  /// begins with the last patches of that, and so has no gap. O(n log n) for the n patches of the
  /// piece, and linear in n for each ring.
  /// \param junction vertex of the piece
  /// \param limb vertices of the limb from its tip; the last one is beside the junction
  /// \pre the junction is of a piece
  template <typename Visit>
  void for_rings(std::size_t junction, const std::vector<std::size_t>& limb, const Visit& visit)
  {
    constexpr double ring_width = 1.5; // spacings; adjacent patches are seldom further apart
    const std::size_t piece = quotient_.piece_of[junction];
    const std::vector<std::size_t>& order = spread(piece, limb);
    const double reach = this->reach(piece, limb, order);
    double spacing = 0, number = 0;
    for(std::size_t i : order)
      if(paths_.distance(i) <= reach) {
        spacing += patches_[i].spacing;
        ++number;
      }
    const double width = number > 0 ? ring_width * spacing / number : 0;
    for(double end = reach; width > 0 && end > 0; end -= width / 2) {
      std::vector<Vector3> ring, root;
      for(std::size_t i : order) {
        const double distance = paths_.distance(i);
        if(distance <= end)
          add_points(i, root);
        if(distance <= end && distance > end - width)
          add_points(i, ring);
      }
      if(end < width)
        for(std::size_t i : quotient_.members[limb.back()])
          add_points(i, ring);
      visit(ring, root);
    }
  }

private:
  void add_points(std::size_t patch, std::vector<Vector3>& points) const
  {
    for(std::size_t k : groups_[patch])
      points.push_back(components_[k]);
  }

  bool is_in(const std::vector<std::size_t>& limb, std::size_t patch) const
  {
    return std::find(limb.begin(), limb.end(), quotient_.vertex_of_patch[patch]) != limb.end();
  }

  bool is_of(std::size_t piece, std::size_t patch) const
  {
    return quotient_.piece_of[quotient_.vertex_of_patch[patch]] == piece;
  }

  /// Finds the distances of the patches of a piece from a limb; returns them, the nearest first.
  const std::vector<std::size_t>& spread(std::size_t piece, const std::vector<std::size_t>& limb)
  {
    std::vector<Shortest_paths::Reached> start;
    for(std::size_t v : limb)
      for(std::size_t i : quotient_.members[v])
        for(const auto& edge : graph_[i])
          if(quotient_.vertex_of_patch[i] == v && is_of(piece, edge.patch))
            start.emplace_back(edge.length, edge.patch);
    return paths_.spread(start, [&](std::size_t i) { return is_of(piece, i); });
  }

  /// The distance from the limb at which another begins, or the piece ends. \pre spread()
  double reach(std::size_t piece, const std::vector<std::size_t>& limb,
               const std::vector<std::size_t>& order) const
  {
    double result = order.empty() ? 0 : paths_.distance(order.back());
    for(std::size_t i : order)
      for(const auto& edge : graph_[i])
        if(!is_of(piece, edge.patch) && !is_in(limb, edge.patch))
          result = (std::min)(result, paths_.distance(i) + static_cast<double>(edge.length));
    return result;
  }

  const Surface_quotient& quotient_;
  const Patches& patches_;
  const std::vector<Vector3>& components_;
  const Patch_groups& groups_;
  Patch_graph graph_;
  Shortest_paths paths_;
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_LIMB_ROOTS_H
