// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SEPARATORS_KNOWN_CUTS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SEPARATORS_KNOWN_CUTS_H

#include <CGAL/Point_set_skeletonization_3/internal/separators/Local_separator.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch_graph.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Separators that cut the surface in two, and the regions between them.
///
/// A search for a way around another separator need not go beyond a cut: whatever is there, it
/// comes back through the same cut, if at all. So each region is searched on its own, and where it
/// is cut the smaller part is visited: O(n log n) for all separators of a tree together, where each
/// would take a search of half of the tree.
class Known_cuts
{
public:
  /// Refers to the graph. O(n).
  Known_cuts(const Patch_graph& graph, std::size_t patches)
    : graph_(graph), region_(patches, 0), cut_(patches, none), mark_(patches, unseen)
  {}

  /// Whether a separator is known to cut: no way leads from one of its sides to the other. If so,
  /// it is kept as a cut. Otherwise there may be a way, or not, if cuts that are not connected are
  /// beside it, or if it is across limbs that touch.
  bool add_if_cuts(const Local_separator& separator)
  {
    if(separator.patches.empty() || !is_in_one_region(separator))
      return false;
    for(std::size_t i : separator.patches)
      mark_[i] = wall;
    for(std::size_t k = 0; k < 2; ++k)
      for(std::size_t i : separator.sides[k])
        reach(i, k);
    std::size_t next = 0;
    while(!meets_ && next < reached_[0].size() && next < reached_[1].size()) {
      for(std::size_t k = 0; k < 2; ++k)
        expand(reached_[k][next], k);
      ++next;
    }
    const bool cuts = !meets_;
    if(cuts)
      split(separator, reached_[next < reached_[0].size() ? 1 : 0]);
    clear(separator);
    return cuts;
  }

private:
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();
  enum Mark : char { seen_from_first, seen_from_second, unseen, wall };

  /// Whether the patches of a separator are in one region, which is the current one then, and its
  /// sides in it or on its cuts. (Patches beside a separator may be in another limb that touches.)
  bool is_in_one_region(const Local_separator& separator)
  {
    current_ = region_[separator.patches.front()];
    const auto is_inside = [&](std::size_t i) { return is_in_current(i); };
    const auto is_beside = [&](std::size_t i) { return is_in_current(i) || bounds_current(i); };
    return std::all_of(separator.patches.begin(), separator.patches.end(), is_inside) &&
           std::all_of(separator.sides[0].begin(), separator.sides[0].end(), is_beside) &&
           std::all_of(separator.sides[1].begin(), separator.sides[1].end(), is_beside);
  }

  bool is_in_current(std::size_t i) const { return cut_[i] == none && region_[i] == current_; }

  /// Whether a patch is on a cut that the current region ends at.
  bool bounds_current(std::size_t i) const
  {
    if(cut_[i] == none)
      return false;
    const std::vector<std::size_t>& cut = cuts_[cut_[i]];
    return std::any_of(cut.begin(), cut.end(), [&](std::size_t j) {
      return std::any_of(graph_[j].begin(), graph_[j].end(),
                         [&](const auto& edge) { return is_in_current(edge.patch); });
    });
  }

  /// Reaches a patch of the current region from a side; all patches of a cut at once.
  void reach(std::size_t i, std::size_t side)
  {
    if(cut_[i] == none) {
      reach_one(i, side);
      return;
    }
    if(mark_[i] == static_cast<Mark>(side))
      return;
    for(std::size_t j : cuts_[cut_[i]])
      reach_one(j, side);
  }

  void reach_one(std::size_t i, std::size_t side)
  {
    if(mark_[i] == unseen) {
      mark_[i] = static_cast<Mark>(side);
      reached_[side].push_back(i);
    } else if(mark_[i] != static_cast<Mark>(side))
      meets_ = true;
  }

  void expand(std::size_t i, std::size_t side)
  {
    for(const auto& edge : graph_[i])
      if(mark_[edge.patch] != wall && (cut_[edge.patch] != none || is_in_current(edge.patch)))
        reach(edge.patch, side);
  }

  /// Makes a part of the current region, beyond a separator, one of its own.
  void split(const Local_separator& separator, const std::vector<std::size_t>& part)
  {
    ++regions_;
    for(std::size_t i : part)
      if(cut_[i] == none)
        region_[i] = regions_;
    for(std::size_t i : separator.patches)
      cut_[i] = cuts_.size();
    cuts_.push_back(separator.patches);
  }

  void clear(const Local_separator& separator)
  {
    for(std::size_t i : separator.patches)
      mark_[i] = unseen;
    for(std::vector<std::size_t>& reached : reached_) {
      for(std::size_t i : reached)
        mark_[i] = unseen;
      reached.clear();
    }
    meets_ = false;
  }

  const Patch_graph& graph_;

  // For each patch.
  std::vector<std::size_t> region_; ///< Only of patches on no cut.
  std::vector<std::size_t> cut_;    ///< `none` if it is on no cut.

  std::vector<std::vector<std::size_t>> cuts_; ///< Their patches.
  std::size_t regions_ = 0;                    ///< Number of regions, less one.

  // Of the current search.
  std::vector<Mark> mark_;
  std::array<std::vector<std::size_t>, 2> reached_;
  std::size_t current_ = 0;
  bool meets_ = false;
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SEPARATORS_KNOWN_CUTS_H
