// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_REFINED_QUOTIENT_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_REFINED_QUOTIENT_H

#include <CGAL/Point_set_skeletonization_3/internal/curve/Skeleton_graph.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/surface_quotient.h>
#include <CGAL/Point_set_skeletonization_3/internal/medial/Sample.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Distance of one front to the next, in spacings: what is smaller than the surroundings in which
/// the kind of a place is known is no shape.
constexpr double front_distance = 3;

/// A quotient in which pieces are replaced by fronts: parts of the piece, one after the other along
/// a limb, each a vertex in its middle.
class Refined_quotient
{
public:
  /// Refers to the quotient. O(n).
  explicit Refined_quotient(const Surface_quotient& quotient)
    : quotient_(quotient), members_(quotient.members), vertex_of_patch_(quotient.vertex_of_patch),
      is_removed_(quotient.members.size(), false)
  {}

  /// The vertex of a patch: its front, if it has one already.
  std::size_t vertex_of(std::size_t patch) const { return vertex_of_patch_[patch]; }

  std::size_t number_of_vertices() const { return members_.size(); }

  /// Adds a front without patches; returns its vertex. It is a cross-section, unless it is what is
  /// left of a piece.
  std::size_t add_front(bool is_cross_section = true)
  {
    members_.emplace_back();
    is_front_cross_section_.push_back(is_cross_section);
    return members_.size() - 1;
  }

  /// Adds a patch to a front.
  void add_to_front(std::size_t front, std::size_t patch)
  {
    members_[front].push_back(patch);
    vertex_of_patch_[patch] = front;
  }

  /// Adds an edge.
  void add_edge(std::size_t v, std::size_t w) { edges_.emplace_back(v, w); }

  /// Removes a vertex of the quotient and its edges. \pre all its patches are in fronts at the end
  void remove(std::size_t vertex) { is_removed_[vertex] = true; }

  /// Returns the result, with the handles of which no vertex was removed; `this` is empty then.
  /// Separators keep their numbers if none is removed. O(n). \pre no front is empty
  Surface_quotient take(const Patches& patches, const Samples& samples)
  {
    constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();
    for(const Skeleton_graph::Edge& e : quotient_.graph.edges)
      if(!is_removed_[e.first] && !is_removed_[e.second])
        edges_.push_back(e);
    std::vector<std::size_t> index(members_.size(), none);
    Surface_quotient result;
    for(std::size_t v = 0; v < members_.size(); ++v) {
      const bool is_front = v >= is_removed_.size();
      if(!is_front && is_removed_[v])
        continue;
      index[v] = result.members.size();
      result.graph.vertices.push_back(
        is_front ? middle(members_[v], patches, samples, Average::mean)
                 : quotient_.graph.vertices[v]);
      if(is_front)
        result.graph.vertices.back().is_cross_section =
          is_front_cross_section_[v - is_removed_.size()];
      result.members.push_back(std::move(members_[v]));
    }
    for(const Skeleton_graph::Edge& e : edges_)
      result.graph.edges.emplace_back(index[e.first], index[e.second]);
    for(const Surface_quotient::Handle& handle : quotient_.handles)
      if(index[handle.separator] != none && index[handle.piece] != none &&
         index[handle.extra] != none)
        result.handles.push_back(
          {index[handle.separator], index[handle.piece], index[handle.extra]});
    for(std::size_t v : vertex_of_patch_)
      result.vertex_of_patch.push_back(index[v]);
    return result;
  }

private:
  const Surface_quotient& quotient_;

  // Of the vertices of the quotient, then of the fronts.
  std::vector<std::vector<std::size_t>> members_;
  std::vector<std::size_t> vertex_of_patch_;
  std::vector<bool> is_removed_; ///< Of the vertices of the quotient only.
  std::vector<bool> is_front_cross_section_; ///< Of the fronts only.
  std::vector<Skeleton_graph::Edge> edges_; ///< New ones.
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_REFINED_QUOTIENT_H
