// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_REFINED_QUOTIENT_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_REFINED_QUOTIENT_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Union_find.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Skeleton_graph.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/surface_quotient.h>
#include <CGAL/Point_set_skeletonization_3/internal/medial/Sample.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch_graph.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

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
    places_.emplace_back();
    is_front_cross_section_.push_back(is_cross_section);
    return members_.size() - 1;
  }

  /// Adds a cross-section that is at a place, not in the middle of its patches.
  std::size_t add_front_at(const Vector3& place)
  {
    const std::size_t result = add_front();
    places_.back() = place;
    return result;
  }

  /// Adds a patch to a front.
  void add_to_front(std::size_t front, std::size_t patch)
  {
    members_[front].push_back(patch);
    vertex_of_patch_[patch] = front;
  }

  /// Takes patches out of their pieces, to be added to fronts. Each connected part of what is left
  /// of such a piece is a vertex, with edges to its neighbours where it touches them. Returns the
  /// sets of connected vertices, with room for a front of each patch. To be called once.
  /// O(n log n). \pre the patches are in pieces
  Union_find take_out(const std::vector<bool>& is_out, const std::vector<Patch_pair>& pairs)
  {
    const std::vector<std::size_t>& piece = quotient_.vertex_of_patch;
    Union_find left(is_out.size());
    for(const Patch_pair& pair : pairs)
      if(piece[pair.a] == piece[pair.b] && !is_out[pair.a] && !is_out[pair.b])
        left.join(pair.a, pair.b);
    for(std::size_t i = 0; i < is_out.size(); ++i)
      if(is_out[i])
        remove(piece[i]);
    for(std::size_t v = 0; v < is_removed_.size(); ++v)
      if(is_removed_[v])
        for(std::size_t i : quotient_.members[v]) // ascending; the root of a set is its smallest
          if(!is_out[i])
            add_to_front(left.find(i) == i ? add_front(false) : vertex_of(left.find(i)), i);
    return join_what_is_left(is_out, pairs);
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
      if(is_front) {
        const std::size_t front = v - is_removed_.size();
        result.graph.vertices.back().is_cross_section = is_front_cross_section_[front];
        if(places_[front]) {
          result.graph.vertices.back().position = *places_[front];
          result.graph.vertices.back().is_on_line = true;
        }
      }
      result.members.push_back(std::move(members_[v]));
      result.piece_of.push_back(result.graph.vertices.back().is_cross_section
                                  ? Surface_quotient::no_piece
                                  : index[v]);
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
  /// Adds the edges of removed pieces that are left, without those that would close a cycle through
  /// two parts of one piece, where there was none. Returns the sets of connected vertices.
  Union_find join_what_is_left(const std::vector<bool>& is_out,
                               const std::vector<Patch_pair>& pairs)
  {
    const std::vector<std::size_t>& before = quotient_.vertex_of_patch;
    Union_find sets(number_of_vertices() + is_out.size());
    std::map<Skeleton_graph::Edge, std::size_t> edges_of_removed; // numbered after the vertices
    for(const Skeleton_graph::Edge& e : quotient_.graph.edges)
      if(is_removed_[e.first] || is_removed_[e.second])
        edges_of_removed.emplace(std::minmax(e.first, e.second),
                                 number_of_vertices() + edges_of_removed.size());
      else
        sets.join(e.first, e.second);
    std::set<std::pair<Skeleton_graph::Edge, std::size_t>> left; // part and neighbour, edge before
    for(const Patch_pair& pair : pairs) {
      const auto edge = edges_of_removed.find(std::minmax(before[pair.a], before[pair.b]));
      if(edge == edges_of_removed.end() || is_out[pair.a] || is_out[pair.b])
        continue;
      Skeleton_graph::Edge e(vertex_of(pair.a), vertex_of(pair.b));
      if(is_removed_[before[pair.b]])
        std::swap(e.first, e.second);
      left.emplace(e, edge->second);
    }
    Union_find stars(number_of_vertices() + edges_of_removed.size()); // of each piece for itself
    for(const auto& [e, edge] : left)
      if(stars.join(e.first, edge)) {
        sets.join(e.first, e.second);
        add_edge(e.first, e.second);
      }
    return sets;
  }

  const Surface_quotient& quotient_;

  // Of the vertices of the quotient, then of the fronts.
  std::vector<std::vector<std::size_t>> members_;
  std::vector<std::size_t> vertex_of_patch_;
  std::vector<bool> is_removed_; ///< Of the vertices of the quotient only.
  std::vector<bool> is_front_cross_section_; ///< Of the fronts only.
  std::vector<std::optional<Vector3>> places_; ///< Of the fronts only.
  std::vector<Skeleton_graph::Edge> edges_; ///< New ones.
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_REFINED_QUOTIENT_H
