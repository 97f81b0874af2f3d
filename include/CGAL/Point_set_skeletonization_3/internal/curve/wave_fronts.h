// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_WAVE_FRONTS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_WAVE_FRONTS_H

#include <CGAL/Point_set_skeletonization_3/internal/curve/Refined_quotient.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/longest_path.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/surface_quotient.h>
#include <CGAL/Point_set_skeletonization_3/internal/medial/Sample.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch_graph.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Shortest_paths.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Whether more than half of some patches are marked.
inline bool are_mostly(const std::vector<std::size_t>& members, const std::vector<bool>& is_marked)
{
  const auto marked = std::count_if(members.begin(), members.end(),
                                    [&](std::size_t i) { return is_marked[i]; });
  return 2 * static_cast<std::size_t>(marked) > members.size();
}

/// Replaces pieces of a quotient by trees of wave fronts. Where points are scattered, as in a crown
/// in leaf, nothing has a cross-section, and a piece may be a whole crown. A wave runs through the
/// piece, from the side where the rest of the shape is longest. What it reaches at one time is a
/// front, each connected part for itself, and the curve leads from the middle of each front to
/// that of the next (Verroust & Lazarus 2000): inside the crown, with limbs where the crown
/// divides. A piece becomes a tree, so that the cycles stay those around separators.
class Wave_fronts
{
public:
  /// Refers to all arguments.
  Wave_fronts(const Surface_quotient& quotient, const Patches& patches,
              const std::vector<Patch_pair>& pairs)
    : quotient_(quotient), patches_(patches), graph_(patches, pairs),
      adjacency_(quotient.graph.adjacency()), paths_(graph_, patches.size()), result_(quotient)
  {
    find_parents();
  }

  /// Returns the quotient with fronts for the pieces that are mostly of marked patches. To be
  /// called once. O(n log n).
  Surface_quotient with_fronts_of(const std::vector<bool>& is_marked, const Samples& samples)
  {
    for(std::size_t v = 0; v < adjacency_.size(); ++v)
      if(is_piece(v, quotient_) && are_mostly(quotient_.members[v], is_marked))
        replace(v);
    return result_.take(patches_, samples);
  }

private:
  static constexpr std::size_t none = Shortest_paths::none;
  using Reached = Shortest_paths::Reached;

  /// Finds the neighbour of each vertex towards the root of its component, an end of a longest
  /// path: the foot of a tree, or the tip of its longest limb.
  void find_parents()
  {
    parent_.assign(adjacency_.size(), none);
    std::vector<bool> is_reached(adjacency_.size(), false);
    for(std::size_t v = 0; v < adjacency_.size(); ++v) {
      if(is_reached[v])
        continue;
      std::vector<std::size_t> reached = {
        farthest_vertex(v, quotient_.graph, adjacency_).first};
      is_reached[reached.front()] = true;
      for(std::size_t next = 0; next < reached.size(); ++next)
        for(std::size_t w : adjacency_[reached[next]])
          if(!is_reached[w]) {
            is_reached[w] = true;
            parent_[w] = reached[next];
            reached.push_back(w);
          }
    }
  }

  /// Replaces a piece by its fronts, if there is more than one.
  void replace(std::size_t piece)
  {
    const std::vector<std::size_t> domain = domain_of(piece);
    const auto is_inside = [&](std::size_t i) {
      return std::binary_search(domain.begin(), domain.end(), i);
    };
    std::vector<std::size_t> order = paths_.spread(start_of(piece), is_inside);
    if(parent_[piece] == none) // from the other end
      order = paths_.spread({{0., order.back()}}, is_inside);
    order.erase(std::remove_if(order.begin(), order.end(),
                               [&](std::size_t i) { return !is_in(piece, i); }),
                order.end());
    if(!order.empty() && level(piece, order.back()) > level(piece, order.front()))
      divide(piece, order);
  }

  bool is_in(std::size_t piece, std::size_t patch) const
  {
    return quotient_.vertex_of_patch[patch] == piece;
  }

  /// The patches that a wave may pass, ascending: of the piece and of the separators around it,
  /// which may be all that it is connected by.
  std::vector<std::size_t> domain_of(std::size_t piece) const
  {
    std::vector<std::size_t> result = quotient_.members[piece];
    for(std::size_t v : adjacency_[piece])
      if(v != parent_[piece])
        result.insert(result.end(), quotient_.members[v].begin(), quotient_.members[v].end());
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  /// Where a wave starts: beside the parent of the piece, or anywhere if it has none.
  std::vector<Reached> start_of(std::size_t piece) const
  {
    if(parent_[piece] == none)
      return {{0., quotient_.members[piece].front()}};
    std::vector<Reached> result;
    for(std::size_t i : quotient_.members[parent_[piece]])
      for(const auto& edge : graph_[i])
        result.emplace_back(edge.length, edge.patch);
    return result;
  }

  /// The time at which the wave reaches a patch of a piece.
  std::size_t level(std::size_t piece, std::size_t i) const
  {
    return static_cast<std::size_t>(
      paths_.distance(i) / (front_distance * quotient_.graph.vertices[piece].resolution));
  }

  /// Makes a vertex of each front of a piece; `order` are its patches that the wave reached.
  void divide(std::size_t piece, const std::vector<std::size_t>& order)
  {
    const std::size_t first = result_.number_of_vertices(), parent = parent_[piece];
    result_.remove(piece);
    for(std::size_t i : order) {
      if(result_.vertex_of(i) != piece)
        continue;
      const std::size_t front = add_front(piece, i);
      std::size_t before = paths_.before(i); // in another front, as this was not reached before
      while(before != none && !is_in(piece, before))
        before = paths_.before(before);
      if(before != none)
        result_.add_edge(front, result_.vertex_of(before));
      else if(parent != none)
        result_.add_edge(front, parent);
    }
    for(std::size_t i : quotient_.members[piece]) // not reached: held by the parent alone
      if(result_.vertex_of(i) == piece)
        result_.add_to_front(first, i);
    for(std::size_t v : adjacency_[piece])
      if(v != parent)
        result_.add_edge(v, front_beside(v, piece, first));
  }

  /// Adds the front of a patch: the patches of its level that are connected with it.
  std::size_t add_front(std::size_t piece, std::size_t patch)
  {
    const std::size_t result = result_.add_front();
    std::vector<std::size_t> front{patch};
    result_.add_to_front(result, patch);
    for(std::size_t next = 0; next < front.size(); ++next)
      for(const auto& edge : graph_[front[next]])
        if(result_.vertex_of(edge.patch) == piece && paths_.is_reached(edge.patch) &&
           level(piece, edge.patch) == level(piece, patch)) {
          result_.add_to_front(result, edge.patch);
          front.push_back(edge.patch);
        }
    return result;
  }

  /// The first front of a piece that reaches a neighbour; `otherwise` if none does.
  std::size_t front_beside(std::size_t neighbor, std::size_t piece, std::size_t otherwise) const
  {
    Reached nearest{Shortest_paths::infinity, none};
    const auto offer = [&](std::size_t i, double further) {
      if(is_in(piece, i))
        nearest = (std::min)(nearest, Reached{paths_.distance(i) + further, i});
    };
    for(std::size_t i : quotient_.members[neighbor]) {
      offer(i, 0);
      for(const auto& edge : graph_[i])
        offer(edge.patch, static_cast<double>(edge.length));
    }
    return nearest.first < Shortest_paths::infinity ? result_.vertex_of(nearest.second) : otherwise;
  }

  const Surface_quotient& quotient_;
  const Patches& patches_;
  Patch_graph graph_;
  std::vector<std::vector<std::size_t>> adjacency_; ///< Of the quotient.
  std::vector<std::size_t> parent_;                 ///< Of each vertex of the quotient.
  Shortest_paths paths_;
  Refined_quotient result_;
};

/// Part 3b: returns a quotient with wave fronts for the pieces that are mostly of marked patches.
/// O(n log n); O(n) without marks.
/// \param pairs adjacent patches, `Ball_overlaps::pairs()`
inline Surface_quotient with_wave_fronts(Surface_quotient quotient, const Patches& patches,
                                         const Samples& samples,
                                         const std::vector<Patch_pair>& pairs,
                                         const std::vector<bool>& is_marked)
{
  if(std::find(is_marked.begin(), is_marked.end(), true) == is_marked.end())
    return quotient;
  return Wave_fronts(quotient, patches, pairs).with_fronts_of(is_marked, samples);
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_WAVE_FRONTS_H
