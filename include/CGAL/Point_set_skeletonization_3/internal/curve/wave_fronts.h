// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_WAVE_FRONTS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_WAVE_FRONTS_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Skeleton_graph.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/longest_path.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/surface_quotient.h>
#include <CGAL/Point_set_skeletonization_3/internal/medial/Sample.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch_graph.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
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
      adjacency_(quotient.graph.adjacency()),
      distance_(patches.size(), infinity), before_(patches.size(), none),
      members_(quotient.members), vertex_of_patch_(quotient.vertex_of_patch),
      is_replaced_(adjacency_.size(), false)
  {
    find_parents();
  }

  /// Returns the quotient with fronts for the pieces that are mostly of marked patches. O(n log n).
  Surface_quotient with_fronts_of(const std::vector<bool>& is_marked, const Samples& samples)
  {
    for(std::size_t v = 0; v < adjacency_.size(); ++v) {
      const std::vector<std::size_t>& members = quotient_.members[v];
      const bool is_piece = !quotient_.graph.vertices[v].is_cross_section &&
                            quotient_.vertex_of_patch[members.front()] == v;
      if(is_piece && are_mostly(members, is_marked))
        replace(v);
    }
    return result(samples);
  }

private:
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();
  static constexpr double infinity = std::numeric_limits<double>::infinity();

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
    std::vector<std::size_t> order = spread(domain, start_of(piece, domain));
    if(parent_[piece] == none) { // from the other end
      const std::size_t last = order.back();
      clear(domain);
      order = spread(domain, {{0., last}});
    }
    order.erase(std::remove_if(order.begin(), order.end(),
                               [&](std::size_t i) { return !is_in(piece, i); }),
                order.end());
    if(!order.empty() && level(piece, order.back()) > level(piece, order.front()))
      divide(piece, order);
    clear(domain);
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

  using Reached = std::pair<double, std::size_t>; ///< Distance, patch.

  /// Where a wave starts: beside the parent of the piece, or anywhere if it has none.
  std::vector<Reached> start_of(std::size_t piece, const std::vector<std::size_t>& domain) const
  {
    if(parent_[piece] == none)
      return {{0., quotient_.members[piece].front()}};
    std::vector<Reached> result;
    for(std::size_t i : quotient_.members[parent_[piece]])
      for(const auto& edge : graph_[i])
        if(std::binary_search(domain.begin(), domain.end(), edge.patch))
          result.emplace_back(edge.length, edge.patch);
    return result;
  }

  /// Finds the distances of the patches of a domain from a start (Dijkstra); returns those that are
  /// reached, by distance.
  std::vector<std::size_t> spread(const std::vector<std::size_t>& domain,
                                  const std::vector<Reached>& start)
  {
    std::priority_queue<Reached, std::vector<Reached>, std::greater<Reached>> queue;
    const auto reach = [&](double distance, std::size_t i, std::size_t before) {
      if(distance < distance_[i]) {
        distance_[i] = distance;
        before_[i] = before;
        queue.push({distance, i});
      }
    };
    for(const auto& [distance, i] : start)
      reach(distance, i, none);
    std::vector<std::size_t> order;
    while(!queue.empty()) {
      const auto [distance, i] = queue.top();
      queue.pop();
      if(distance > distance_[i])
        continue;
      order.push_back(i);
      for(const auto& edge : graph_[i])
        if(std::binary_search(domain.begin(), domain.end(), edge.patch))
          reach(distance + static_cast<double>(edge.length), edge.patch, i);
    }
    return order;
  }

  /// Forgets the distances in a domain.
  void clear(const std::vector<std::size_t>& domain)
  {
    for(std::size_t i : domain) {
      distance_[i] = infinity;
      before_[i] = none;
    }
  }

  /// The time at which the wave reaches a patch of a piece.
  std::size_t level(std::size_t piece, std::size_t i) const
  {
    // Spacings: what is smaller than the surroundings that are known to be scattered is no shape.
    constexpr double step = 3;
    return static_cast<std::size_t>(distance_[i] /
                                    (step * quotient_.graph.vertices[piece].resolution));
  }

  /// Makes a vertex of each front of a piece; `order` are its patches that the wave reached.
  void divide(std::size_t piece, const std::vector<std::size_t>& order)
  {
    const std::size_t first = members_.size(), parent = parent_[piece];
    is_replaced_[piece] = true;
    for(std::size_t i : order) {
      if(vertex_of_patch_[i] != piece)
        continue;
      add_front(piece, i);
      std::size_t before = before_[i]; // in another front, as this one was not reached before
      while(before != none && !is_in(piece, before))
        before = before_[before];
      if(before != none)
        edges_.emplace_back(members_.size() - 1, vertex_of_patch_[before]);
      else if(parent != none)
        edges_.emplace_back(members_.size() - 1, parent);
    }
    for(std::size_t i : quotient_.members[piece]) // not reached: held by the parent alone
      if(vertex_of_patch_[i] == piece) {
        vertex_of_patch_[i] = first;
        members_[first].push_back(i);
      }
    for(std::size_t v : adjacency_[piece])
      if(v != parent)
        edges_.emplace_back(v, front_beside(v, piece, first));
  }

  /// Adds the front of a patch: the patches of its level that are connected with it.
  void add_front(std::size_t piece, std::size_t patch)
  {
    const std::size_t vertex = members_.size();
    std::vector<std::size_t> front{patch};
    vertex_of_patch_[patch] = vertex;
    for(std::size_t next = 0; next < front.size(); ++next)
      for(const auto& edge : graph_[front[next]])
        if(vertex_of_patch_[edge.patch] == piece && distance_[edge.patch] < infinity &&
           level(piece, edge.patch) == level(piece, patch)) {
          vertex_of_patch_[edge.patch] = vertex;
          front.push_back(edge.patch);
        }
    members_.push_back(std::move(front));
  }

  /// The first front of a piece that reaches a neighbour; `otherwise` if none does.
  std::size_t front_beside(std::size_t neighbor, std::size_t piece, std::size_t otherwise) const
  {
    Reached nearest{infinity, none};
    const auto offer = [&](std::size_t i, double further) {
      if(is_in(piece, i))
        nearest = (std::min)(nearest, Reached{distance_[i] + further, i});
    };
    for(std::size_t i : quotient_.members[neighbor]) {
      offer(i, 0);
      for(const auto& edge : graph_[i])
        offer(edge.patch, static_cast<double>(edge.length));
    }
    return nearest.first < infinity ? vertex_of_patch_[nearest.second] : otherwise;
  }

  /// The quotient with the fronts in place of the pieces.
  Surface_quotient result(const Samples& samples)
  {
    for(const Skeleton_graph::Edge& e : quotient_.graph.edges)
      if(!is_replaced_[e.first] && !is_replaced_[e.second])
        edges_.push_back(e);
    std::vector<std::size_t> index(members_.size(), none);
    Surface_quotient result;
    for(std::size_t v = 0; v < members_.size(); ++v) {
      const bool is_front = v >= is_replaced_.size();
      if(!is_front && is_replaced_[v])
        continue;
      index[v] = result.members.size();
      result.graph.vertices.push_back(is_front ? middle(members_[v], patches_, samples)
                                               : quotient_.graph.vertices[v]);
      result.graph.vertices.back().is_cross_section |= is_front;
      result.members.push_back(std::move(members_[v]));
    }
    for(const Skeleton_graph::Edge& e : edges_)
      result.graph.edges.emplace_back(index[e.first], index[e.second]);
    for(std::size_t v : vertex_of_patch_)
      result.vertex_of_patch.push_back(index[v]);
    return result;
  }

  const Surface_quotient& quotient_;
  const Patches& patches_;
  Patch_graph graph_;
  std::vector<std::vector<std::size_t>> adjacency_; ///< Of the quotient.
  std::vector<std::size_t> parent_;                 ///< Of each vertex of the quotient.

  // For each patch that the wave has reached.
  std::vector<double> distance_;
  std::vector<std::size_t> before_; ///< The patch before it on the way.

  // The result, with the fronts after the vertices of the quotient, among them those replaced.
  std::vector<std::vector<std::size_t>> members_;
  std::vector<std::size_t> vertex_of_patch_;
  std::vector<bool> is_replaced_;
  std::vector<Skeleton_graph::Edge> edges_;
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
