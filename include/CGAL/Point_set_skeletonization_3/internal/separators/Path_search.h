// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SEPARATORS_PATH_SEARCH_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SEPARATORS_PATH_SEARCH_H

#include <CGAL/Point_set_skeletonization_3/internal/separators/Local_separator.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch_graph.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <queue>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Finds paths on the surface from one side of a separator to the other. Scratch memory is reset
/// after each call, so that one object can serve many separators.
class Path_search
{
public:
  /// Adjacent patches in order. In a closed path the last is adjacent to the first.
  using Path = std::vector<std::size_t>;

  /// Refers to both arguments. O(n).
  Path_search(const Patches& patches, const Patch_graph& graph)
      : patches_(patches)
      , graph_(graph)
      , place_(patches.size(), elsewhere)
      , visits_(patches.size())
  {}

  /// Returns a path from the second side to the first, off the separator; empty if there is none.
  /// Bidirectional breadth-first search: close to a shortest path.
  Path around(const Local_separator& separator)
  {
    mark(separator);
    const Path result = between_sides(separator);
    unmark(separator);
    return result;
  }

  /// Whether a path leads from one side to the other across the separator.
  bool is_crossed(const Local_separator& separator)
  {
    mark(separator);
    const bool result = crosses(separator);
    unmark(separator);
    return result;
  }

  /// Returns the algebraic intersection number of a closed path and a separator: its crossings from
  /// the first side to the second minus those back; 0 if unknown. O(sizes of both).
  int algebraic_intersection_number(const Path& loop, const Local_separator& separator)
  {
    mark(separator);
    const int result = algebraic_intersection_number(loop);
    unmark(separator);
    return result;
  }

  /// Closes a path between the sides of a separator across it, by breadth-first search on the
  /// separator. Empty if the separator is not connected.
  Path closed(Path path, const Local_separator& separator)
  {
    mark(separator);
    const bool closes = close(path);
    unmark(separator);
    return closes ? path : Path();
  }

private:
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();
  enum Place : char { elsewhere, on_separator, on_first_side, on_second_side };

  /// How a patch was reached first.
  struct Visit
  {
    Place from = elsewhere;    ///< Side where the search started.
    std::size_t before = none; ///< Previous patch.
  };

  void mark(const Local_separator& separator)
  {
    place(separator.patches, on_separator);
    place(separator.sides[0], on_first_side);
    place(separator.sides[1], on_second_side);
  }

  void unmark(const Local_separator& separator)
  {
    place(separator.patches, elsewhere);
    for(const std::vector<std::size_t>& side : separator.sides)
      place(side, elsewhere);
  }

  void place(const std::vector<std::size_t>& patches, Place where)
  {
    for(std::size_t i : patches)
      place_[i] = where;
  }

  int algebraic_intersection_number(const Path& loop) const
  {
    const auto last = std::find_if(loop.rbegin(), loop.rend(),
                                   [&](std::size_t i) { return place_[i] != on_separator; });
    if(last == loop.rend())
      return 0;
    Place before = place_[*last];
    bool crossing = last != loop.rbegin();
    int result = 0;
    for(std::size_t i : loop) {
      const Place place = place_[i];
      if(place == on_separator) {
        crossing = true;
        continue;
      }
      if(before != elsewhere && place != elsewhere)
        result += place - before;
      else if(crossing)
        return 0;
      before = place;
      crossing = false;
    }
    return result;
  }

  /// Closes a path across the separator; `false` if that is not connected.
  bool close(Path& path) const
  {
    std::map<std::size_t, std::size_t> before;
    std::queue<std::size_t> queue({path.front()});
    for(; !queue.empty(); queue.pop()) {
      std::size_t i = queue.front();
      for(std::size_t j : patches_[i].neighbors)
        if(j == path.back()) {
          for(; i != path.front(); i = before[i])
            path.push_back(i);
          return true;
        } else if(place_[j] == on_separator && before.emplace(j, i).second)
          queue.push(j);
    }
    return false;
  }

  /// Breadth-first search from the first side on the separator.
  bool crosses(const Local_separator& separator)
  {
    std::vector<std::size_t> reached = separator.sides[0];
    bool result = false;
    for(std::size_t next = 0; next < reached.size() && !result; ++next) {
      const bool is_beside = place_[reached[next]] == on_first_side;
      for(const auto& edge : graph_[reached[next]])
        if(place_[edge.patch] == on_separator) {
          place_[edge.patch] = elsewhere; // reached
          reached.push_back(edge.patch);
        } else if(place_[edge.patch] == on_second_side && !is_beside)
          result = true;
    }
    return result;
  }

  /// Searches from both sides alternately: if there is no path, the search visits about twice the
  /// smaller part of the shape. Where the two meet, the path is shortest up to a few patches.
  Path between_sides(const Local_separator& separator)
  {
    constexpr std::array<Place, 2> side = {on_first_side, on_second_side};
    std::array<std::vector<std::size_t>, 2> reached;
    std::array<std::size_t, 2> meeting = {none, none}; // adjacent, from each side
    const auto reach = [&](std::size_t i, std::size_t before, std::size_t k) {
      Visit& visit = visits_[i];
      if(visit.from == elsewhere) {
        visit = {side[k], before};
        reached[k].push_back(i);
      } else if(visit.from != side[k]) {
        meeting[k] = before;
        meeting[1 - k] = i;
      }
    };
    for(std::size_t k = 0; k < 2; ++k)
      for(std::size_t i : separator.sides[k])
        reach(i, none, k);
    for(std::size_t next = 0;
        meeting[0] == none && next < (std::min)(reached[0].size(), reached[1].size()); ++next)
      for(std::size_t k = 0; k < 2; ++k)
        for(const auto& edge : graph_[reached[k][next]])
          if(place_[edge.patch] != on_separator)
            reach(edge.patch, reached[k][next], k);
    Path path;
    for(std::size_t i = meeting[1]; i != none; i = visits_[i].before)
      path.push_back(i);
    std::reverse(path.begin(), path.end());
    for(std::size_t i = meeting[0]; i != none; i = visits_[i].before)
      path.push_back(i);
    for(const std::vector<std::size_t>& visited : reached)
      for(std::size_t i : visited)
        visits_[i] = Visit();
    return path;
  }

  const Patches& patches_;
  const Patch_graph& graph_;

  // For each patch; default between calls.
  std::vector<Place> place_;
  std::vector<Visit> visits_;
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SEPARATORS_PATH_SEARCH_H
