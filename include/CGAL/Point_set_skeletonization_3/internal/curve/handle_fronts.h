// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_HANDLE_FRONTS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_HANDLE_FRONTS_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Union_find.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/minimum_spanning_forest.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/quantile.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Refined_quotient.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/surface_quotient.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/ways_through_pieces.h>
#include <CGAL/Point_set_skeletonization_3/internal/medial/Sample.h>
#include <CGAL/Point_set_skeletonization_3/internal/separators/Local_separator.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch_graph.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Shortest_paths.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// How far each patch of a piece is on a way through it. Divided into levels of equal length.
struct Way_levels
{
  std::vector<std::size_t> level; ///< Of each patch of the piece, in their order.
  std::size_t number = 0;

  /// Number of levels between two patches of the piece.
  std::size_t between(std::size_t k, std::size_t l) const
  {
    return level[k] > level[l] ? level[k] - level[l] : level[l] - level[k];
  }

  /// Whether the step from one patch to an adjacent one is from one end of the way to the other:
  /// across the separator that the way leads around to.
  bool are_across(std::size_t k, std::size_t l) const { return 2 * between(k, l) > number; }
};

/// Replaces pieces that handles lead through by trees of fronts. Where separators are far between, a
/// piece may be most of the shape: the wall of a pipe but one or two rings, and a curve through its
/// middle is no curve around the pipe. A front is a connected part of it that is equally far on each
/// way through it; the curve leads from the middle of each front to that of the next. The fronts of
/// a piece become a tree, so that the cycles stay those around separators.
class Handle_fronts
{
public:
  /// Refers to all arguments.
  Handle_fronts(const Surface_quotient& quotient, const std::vector<Local_separator>& separators,
                const Patches& patches, const std::vector<Patch_pair>& pairs)
    : quotient_(quotient), separators_(separators), patches_(patches), graph_(patches, pairs),
      paths_(graph_, patches.size()), front_(patches.size(), none), place_(patches.size(), none),
      result_(quotient)
  {}

  /// Returns the quotient with fronts for the pieces of the ways. To be called once. O(m log m) for
  /// each way through a piece of m patches.
  Surface_quotient with_fronts(const Ways_through_pieces& ways, const Samples& samples)
  {
    std::map<std::size_t, std::vector<Handle>> handles_around;
    for(const Handle& handle : quotient_.handles)
      handles_around[handle.piece].push_back(handle);
    for(const auto& [piece, through] : ways)
      replace(piece, handles_around[piece], through);
    join_pieces();
    Surface_quotient result = result_.take(patches_, samples);
    std::map<std::size_t, std::size_t> first_fronts; // of each piece
    for(std::size_t i = 0; i < patches_.size(); ++i)
      if(const std::size_t piece = quotient_.vertex_of_patch[i]; ways.count(piece) > 0) {
        const std::size_t front = result.vertex_of_patch[i];
        result.piece_of[front] = first_fronts.emplace(piece, front).first->second;
      }
    return result;
  }

private:
  static constexpr std::size_t none = Shortest_paths::none;
  using Handle = Surface_quotient::Handle;
  using Fronts = std::vector<std::vector<std::size_t>>; ///< The patches of each.

  /// A vertex of the quotient that is to be adjacent to a front.
  struct Attachment
  {
    std::size_t vertex, front;
  };

  /// Two adjacent fronts.
  struct Contact
  {
    std::size_t a, b;
    std::size_t size; ///< Number of adjacent patches.

    /// Greater contact comes first.
    bool operator<(const Contact& other) const
    {
      return size != other.size ? size > other.size
                                : std::make_pair(a, b) < std::make_pair(other.a, other.b);
    }
  };

  bool is_in(std::size_t piece, std::size_t i) const
  {
    return quotient_.vertex_of_patch[i] == piece;
  }

  /// Replaces a piece by its fronts, if there are several.
  void replace(std::size_t piece, const std::vector<Handle>& handles,
               const std::vector<Way_through>& ways)
  {
    const std::vector<std::size_t>& members = quotient_.members[piece];
    for(std::size_t k = 0; k < members.size(); ++k)
      place_[members[k]] = k;
    std::vector<Way_levels> levels;
    for(const Way_through& way : ways)
      levels.push_back(levels_of(piece, way));
    if(std::all_of(levels.begin(), levels.end(),
                   [](const Way_levels& along) { return along.number == 1; }))
      return;
    const Fronts fronts = fronts_of(piece, levels);
    const std::vector<Contact> tree = spanning_tree(piece, levels, fronts.size());
    const std::vector<Attachment> attached = attach(piece, handles);
    const std::vector<std::size_t> kept = without_dead_ends(fronts.size(), tree, attached);
    result_.remove(piece);
    std::vector<std::size_t> vertex(fronts.size(), none);
    for(std::size_t f = 0; f < fronts.size(); ++f)
      if(kept[f] == f)
        vertex[f] = result_.add_front();
    for(std::size_t f = 0; f < fronts.size(); ++f)
      for(std::size_t i : fronts[f])
        result_.add_to_front(vertex[kept[f]], i);
    for(const Contact& contact : tree)
      if(kept[contact.a] == contact.a && kept[contact.b] == contact.b)
        result_.add_edge(vertex[contact.a], vertex[contact.b]);
    for(const Attachment& attachment : attached) {
      const std::size_t front = vertex[kept[attachment.front]];
      if(is_piece(attachment.vertex, quotient_))
        front_at_piece_[{piece, attachment.vertex}] = front;
      else
        result_.add_edge(attachment.vertex, front);
    }
  }

  /// Adds the edges between the fronts of a piece and other pieces, which may have been replaced by
  /// fronts as well.
  void join_pieces()
  {
    for(const auto& [pieces, front] : front_at_piece_) {
      const auto [piece, other] = pieces;
      const auto found = front_at_piece_.find({other, piece});
      if(found == front_at_piece_.end())
        result_.add_edge(other, front);
      else if(piece < other) // the other comes as well
        result_.add_edge(front, found->second);
    }
  }

  /// The distances of the patches of a piece from some beside or in it.
  std::vector<double> distances(std::size_t piece, const std::vector<std::size_t>& start)
  {
    std::vector<Shortest_paths::Reached> from;
    for(std::size_t i : start)
      from.emplace_back(0., i);
    paths_.spread(from, [&](std::size_t i) { return is_in(piece, i); });
    std::vector<double> result;
    for(std::size_t i : quotient_.members[piece])
      result.push_back(paths_.distance(i));
    return result;
  }

  /// How far the patches of a piece are on a way: the share of it. Halfway if they are not reached.
  Way_levels levels_of(std::size_t piece, const Way_through& way)
  {
    // A curve around a handle needs four fronts, more than eight follow the noise. Between separators
    // there is a part of the way around, half if there are two.
    const double fewest = way.leads_around() ? 4 : 1, most = way.leads_around() ? 8 : 4;
    constexpr double front_distance = 3; // spacings: what is smaller than that is no shape
    const std::vector<std::size_t>& members = quotient_.members[piece];
    const std::vector<double> from = distances(piece, patches_on(way.from)),
                              to = distances(piece, patches_on(way.to));
    std::vector<double> lengths, spacings;
    for(std::size_t k = 0; k < members.size(); ++k) {
      spacings.push_back(patches_[members[k]].spacing);
      if(from[k] + to[k] < Shortest_paths::infinity)
        lengths.push_back(from[k] + to[k]);
    }
    const double length = lengths.empty() ? 0 : quantile(lengths, 0.5);
    const double number = std::round(length / (front_distance * quantile(spacings, 0.5)));
    Way_levels result;
    result.number = static_cast<std::size_t>((std::clamp)(number, fewest, most));
    for(std::size_t k = 0; k < members.size(); ++k) {
      const double total = from[k] + to[k];
      const double share = total > 0 && total < Shortest_paths::infinity ? from[k] / total : 0.5;
      result.level.push_back(
        (std::min)(result.number - 1,
                   static_cast<std::size_t>(static_cast<double>(result.number) * share)));
    }
    return result;
  }

  const std::vector<std::size_t>& patches_on(const Separator_side& side) const
  {
    return separators_[side.separator].sides[side.side];
  }

  /// Divides a piece into fronts: the patches of the same levels that are connected through them
  /// and the levels beside, as far as noise leads.
  Fronts fronts_of(std::size_t piece, const std::vector<Way_levels>& levels)
  {
    const auto between = [&](std::size_t i, std::size_t j) {
      std::size_t most = 0;
      for(const Way_levels& along : levels)
        most = (std::max)(most, along.between(place_[i], place_[j]));
      return most;
    };
    const std::vector<std::size_t>& members = quotient_.members[piece];
    for(std::size_t i : members)
      front_[i] = none;
    Fronts result;
    std::vector<std::size_t> seen(members.size(), none); // the last front whose search saw it
    for(std::size_t first : members) {
      if(front_[first] != none)
        continue;
      std::vector<std::size_t> connected{first}, front;
      seen[place_[first]] = result.size();
      for(std::size_t next = 0; next < connected.size(); ++next) {
        const std::size_t i = connected[next];
        if(between(i, first) == 0) {
          front_[i] = result.size();
          front.push_back(i);
        }
        for(const auto& edge : graph_[i])
          if(is_in(piece, edge.patch) && seen[place_[edge.patch]] != result.size() &&
             between(edge.patch, first) <= 1) {
            seen[place_[edge.patch]] = result.size();
            connected.push_back(edge.patch);
          }
      }
      result.push_back(std::move(front));
    }
    return result;
  }

  /// The contacts that connect the fronts of a piece to a tree, the greatest first, none across a
  /// separator.
  std::vector<Contact> spanning_tree(std::size_t piece, const std::vector<Way_levels>& levels,
                                     std::size_t fronts) const
  {
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> sizes;
    for(std::size_t i : quotient_.members[piece])
      for(const auto& edge : graph_[i])
        if(edge.patch > i && is_in(piece, edge.patch) && front_[i] != front_[edge.patch] &&
           std::none_of(levels.begin(), levels.end(), [&](const Way_levels& along) {
             return along.are_across(place_[i], place_[edge.patch]);
           }))
          ++sizes[std::minmax(front_[i], front_[edge.patch])];
    std::vector<Contact> contacts;
    for(const auto& [pair, size] : sizes)
      contacts.push_back({pair.first, pair.second, size});
    Union_find sets(fronts);
    std::vector<Contact> result = minimum_spanning_forest(sets, fronts, std::move(contacts));
    for(std::size_t f = 0; f < fronts; ++f) // a piece need not be connected
      if(sets.join(0, f))
        result.push_back({0, f, 0});
    return result;
  }

  /// Finds the fronts beside the separators around a piece, among them those of its handles, which
  /// have one on either side.
  std::vector<Attachment> attach(std::size_t piece, const std::vector<Handle>& handles)
  {
    std::vector<Attachment> result;
    std::vector<std::size_t> own;
    for(const Handle& handle : handles) {
      const Local_separator& separator = separators_[handle.separator];
      const std::size_t a = front_beside(piece, separator.sides[0]),
                        b = front_beside(piece, separator.sides[1]);
      result.push_back({handle.separator, a});
      if(a == b)
        result.push_back({handle.extra, b});
      else {
        result.push_back({handle.separator, b});
        result_.remove(handle.extra);
      }
      own.push_back(handle.separator);
      own.push_back(handle.extra);
    }
    for(const Skeleton_graph::Edge& e : quotient_.graph.edges) {
      if(e.first != piece && e.second != piece)
        continue;
      const std::size_t v = e.first == piece ? e.second : e.first;
      if(std::find(own.begin(), own.end(), v) == own.end())
        result.push_back({v, front_beside(piece, quotient_.members[v])});
    }
    return result;
  }

  /// The front of a piece that most of some patches are in or beside.
  std::size_t front_beside(std::size_t piece, const std::vector<std::size_t>& patches) const
  {
    std::map<std::size_t, std::size_t> sizes;
    const auto count = [&](std::size_t i) {
      if(is_in(piece, i))
        ++sizes[front_[i]];
    };
    for(std::size_t i : patches) {
      count(i);
      for(const auto& edge : graph_[i])
        count(edge.patch);
    }
    const auto largest = std::max_element(
      sizes.begin(), sizes.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    return largest == sizes.end() ? 0 : largest->first;
  }

  /// Returns for each front the one that it belongs to: dead ends of the tree of fronts that
  /// nothing is attached to are no limbs, or a separator would cut them off.
  static std::vector<std::size_t> without_dead_ends(std::size_t fronts,
                                                    const std::vector<Contact>& tree,
                                                    const std::vector<Attachment>& attached)
  {
    std::vector<std::vector<std::size_t>> adjacent(fronts);
    std::vector<std::size_t> degree(fronts, 0); // a front with an attachment has one more
    for(const Contact& contact : tree) {
      adjacent[contact.a].push_back(contact.b);
      adjacent[contact.b].push_back(contact.a);
      ++degree[contact.a];
      ++degree[contact.b];
    }
    for(const Attachment& attachment : attached)
      degree[attachment.front] += 2;
    std::vector<std::size_t> result(fronts), dead_ends;
    std::iota(result.begin(), result.end(), std::size_t(0));
    for(std::size_t f = 0; f < fronts; ++f)
      if(degree[f] <= 1)
        dead_ends.push_back(f);
    for(std::size_t k = 0; k < dead_ends.size(); ++k) {
      const std::size_t f = dead_ends[k];
      const auto next = std::find_if(adjacent[f].begin(), adjacent[f].end(),
                                     [&](std::size_t g) { return result[g] == g; });
      result[f] = next != adjacent[f].end() ? *next : attached.front().front;
      if(next != adjacent[f].end() && --degree[*next] == 1)
        dead_ends.push_back(*next);
    }
    for(std::size_t k = dead_ends.size(); k-- > 0;) // the last is beside what stays
      result[dead_ends[k]] = result[result[dead_ends[k]]];
    return result;
  }

  const Surface_quotient& quotient_;
  const std::vector<Local_separator>& separators_;
  const Patches& patches_;
  Patch_graph graph_;
  Shortest_paths paths_;

  // Of each patch of the current piece; of others undefined.
  std::vector<std::size_t> front_; ///< Its front.
  std::vector<std::size_t> place_; ///< In the order of the patches of the piece.

  /// The fronts of replaced pieces that are adjacent to other pieces, by the former and the latter.
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> front_at_piece_;

  Refined_quotient result_;
};

/// Part 3b: returns a quotient with fronts for the pieces that handles lead through. O(n log n), and
/// O(m log m) for each way through a piece of m patches.
/// \param separators the first vertices of the quotient
/// \param pairs adjacent patches, `Ball_overlaps::pairs()`
inline Surface_quotient with_handle_fronts(Surface_quotient quotient,
                                           const std::vector<Local_separator>& separators,
                                           const Patches& patches, const Samples& samples,
                                           const std::vector<Patch_pair>& pairs)
{
  const Ways_through_pieces ways = ways_through_pieces(quotient, separators);
  if(ways.empty())
    return quotient;
  return Handle_fronts(quotient, separators, patches, pairs).with_fronts(ways, samples);
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_HANDLE_FRONTS_H
