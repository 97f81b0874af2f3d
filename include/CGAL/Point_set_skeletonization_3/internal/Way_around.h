// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_WAY_AROUND_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_WAY_AROUND_H

#include <CGAL/Point_set_skeletonization_3/internal/Growing_region.h>
#include <CGAL/Point_set_skeletonization_3/internal/Rubber_band.h>
#include <CGAL/Point_set_skeletonization_3/internal/limb_joints.h>
#include <CGAL/Point_set_skeletonization_3/internal/patch_adjacency.h>
#include <CGAL/Point_set_skeletonization_3/internal/samples.h>
#include <CGAL/Point_set_skeletonization_3/internal/winding_number.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Tells separators that cut a limb from those that cut nothing: from the one side to the other
/// there is no way on the surface, or only one around a hole of the shape. An arc that ends in holes
/// of the data, or a ring around a dent, has a way around through the solid.
class Way_around
{
public:
  Way_around(const std::vector<Patch>& patches, const std::vector<Sample>& samples,
             const Limb_joints& joints, const Winding_number& winding_number)
      : patches_(patches)
      , samples_(samples)
      , winding_number_(winding_number)
      , edges_(patches, [&](std::size_t i, std::size_t j) { return joints.are_joined(i, j); })
      , place_(patches.size(), elsewhere)
      , reached_from_(patches.size(), elsewhere)
      , visits_(patches.size())
  {}

  /// Whether the separator cuts a limb.
  bool cuts(const Local_separator& separator)
  {
    mark(separator);
    // A loop that shrinks to a point inside the shape crosses no cross-section once.
    const bool result = std::none_of(shrinking_.begin(), shrinking_.end(),
                                     [&](const Loop& loop) { return crossings(loop) != 0; }) &&
                        !has_way_around(separator);
    unmark(separator);
    return result;
  }

private:
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  enum Place : char { elsewhere, on_separator, on_first_side, on_second_side };
  using Loop = std::vector<std::size_t>; // neighbouring patches, the last next to the first

  bool has_way_around(const Local_separator& separator)
  {
    // What the points show as a hole is surrounded by more patches than that.
    constexpr std::size_t around_an_end = 4;
    if(!are_connected(separator))
      return false;
    const std::vector<std::size_t> way = shortest(separator);
    if(way.size() <= around_an_end)
      return !way.empty();
    const double resolution = patches_[separator.patches.front()].spacing;
    const Rubber_band band(positions(way), resolution, winding_number_);
    if(std::any_of(held_.begin(), held_.end(),
                   [&](const Rubber_band& held) { return band.can_become(held); }))
      return false;
    if(!Rubber_band(band).shrinks()) {
      held_.push_back(band);
      return false;
    }
    shrinking_.push_back(closed(way));
    return true;
  }

  /// How often a loop crosses the separator from the first side to the second, less how often it
  /// comes back; 0 if that is not known.
  int crossings(const Loop& loop) const
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

  /// A way from one side to the other, closed across the separator; none if that is in pieces.
  Loop closed(Loop way) const
  {
    std::map<std::size_t, std::size_t> before;
    std::queue<std::size_t> queue({way.front()});
    for(; !queue.empty(); queue.pop()) {
      std::size_t i = queue.front();
      for(std::size_t j : patches_[i].neighbors)
        if(j == way.back()) {
          for(; i != way.front(); i = before[i])
            way.push_back(i);
          return way;
        } else if(place_[j] == on_separator && before.emplace(j, i).second)
          queue.push(j);
    }
    return {};
  }

  /// The shortest way to a patch that is known so far.
  struct Visit
  {
    double way = infinity;
    std::size_t before = none; ///< The patch before.
    bool done = false;         ///< There is no shorter one.
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

  /// Whether there is any way from one side to the other. It is looked for from both in turn: where
  /// a limb is cut off, only the smaller part of the shape is visited, twice.
  bool are_connected(const Local_separator& separator)
  {
    constexpr std::array<Place, 2> side = {on_first_side, on_second_side};
    std::array<std::vector<std::size_t>, 2> reached;
    bool result = false;
    const auto reach = [&](std::size_t i, std::size_t k) {
      if(reached_from_[i] == elsewhere) {
        reached_from_[i] = side[k];
        reached[k].push_back(i);
      } else if(reached_from_[i] != side[k])
        result = true;
    };
    for(std::size_t k : {0, 1})
      for(std::size_t i : separator.sides[k])
        reach(i, k);
    for(std::size_t next = 0;
        !result && next < std::min(reached[0].size(), reached[1].size()); ++next)
      for(std::size_t k : {0, 1})
        for(const auto& edge : edges_[reached[k][next]])
          if(place_[edge.patch] != on_separator)
            reach(edge.patch, k);
    for(const std::vector<std::size_t>& visited : reached)
      for(std::size_t i : visited)
        reached_from_[i] = elsewhere;
    return result;
  }

  /// The patches along the shortest way from the second side to the first; none if there is no way.
  std::vector<std::size_t> shortest(const Local_separator& separator)
  {
    using Step = std::pair<double, std::size_t>; // way, patch
    std::priority_queue<Step, std::vector<Step>, std::greater<Step>> queue;
    std::vector<std::size_t> visited;
    const auto visit = [&](std::size_t i, double way, std::size_t before) {
      Visit& known = visits_[i];
      if(known.done || std::tie(way, before) >= std::tie(known.way, known.before))
        return;
      if(known.way == infinity)
        visited.push_back(i);
      known.way = way;
      known.before = before;
      queue.emplace(way, i);
    };
    for(std::size_t i : separator.sides[0])
      visit(i, 0, none);
    std::size_t last = none;
    while(!queue.empty() && last == none) {
      const Step step = queue.top();
      const std::size_t i = step.second;
      queue.pop();
      if(visits_[i].done)
        continue;
      visits_[i].done = true;
      if(place_[i] == on_second_side)
        last = i;
      for(const auto& edge : edges_[i])
        if(place_[edge.patch] != on_separator)
          visit(edge.patch, step.first + static_cast<double>(edge.length), i);
    }
    std::vector<std::size_t> way;
    for(; last != none; last = visits_[last].before)
      way.push_back(last);
    for(std::size_t i : visited)
      visits_[i] = Visit();
    return way;
  }

  /// The samples of patches.
  std::vector<Vector3> positions(const std::vector<std::size_t>& patches) const
  {
    std::vector<Vector3> result;
    for(std::size_t i : patches)
      result.push_back(samples_[i].position);
    return result;
  }

  const std::vector<Patch>& patches_;
  const std::vector<Sample>& samples_;
  const Winding_number& winding_number_;
  const Patch_edges edges_;     ///< Along limbs.

  // Found so far.
  std::vector<Loop> shrinking_;
  std::vector<Rubber_band> held_; ///< By holes of the shape.

  // Of every patch; as at the beginning between calls.
  std::vector<Place> place_;
  std::vector<Place> reached_from_; ///< A side.
  std::vector<Visit> visits_;
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_WAY_AROUND_H
