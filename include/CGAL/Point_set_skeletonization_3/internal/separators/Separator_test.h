// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SEPARATORS_SEPARATOR_TEST_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SEPARATORS_SEPARATOR_TEST_H

#include <CGAL/Point_set_skeletonization_3/internal/separators/Growing_region.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Per_thread.h>
#include <CGAL/Point_set_skeletonization_3/internal/separators/Closed_curve.h>
#include <CGAL/Point_set_skeletonization_3/internal/separators/Ball_overlaps.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel_for.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/patches.h>
#include <CGAL/Point_set_skeletonization_3/internal/medial/Sample.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Winding_number.h>

#include <CGAL/tags.h>

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

/// Looks for ways on the surface from one side of a separator to the other. One object visits one
/// separator after the other.
class Path_search
{
public:
  /// Neighbouring patches; as a loop, the last next to the first.
  using Way = std::vector<std::size_t>;

  Path_search(const std::vector<Patch>& patches, const Patch_graph& edges)
      : patches_(patches)
      , edges_(edges)
      , place_(patches.size(), elsewhere)
      , visits_(patches.size())
  {}

  /// A short way from the second side to the first; none if there is no way.
  Way around(const Local_separator& separator)
  {
    mark(separator);
    const Way result = between_sides(separator);
    unmark(separator);
    return result;
  }

  /// How often a loop crosses the separator from the first side to the second, less how often it
  /// comes back; 0 if that is not known.
  int algebraic_intersection_number(const Way& loop, const Local_separator& separator)
  {
    mark(separator);
    const int result = algebraic_intersection_number(loop);
    unmark(separator);
    return result;
  }

  /// A way from one side to the other, closed across the separator; none if that is in pieces.
  Way closed(Way way, const Local_separator& separator)
  {
    mark(separator);
    const bool closes = close(way);
    unmark(separator);
    return closes ? way : Way();
  }

private:
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  enum Place : char { elsewhere, on_separator, on_first_side, on_second_side };

  /// How a patch was reached first.
  struct Visit
  {
    Place from = elsewhere;    ///< The side.
    std::size_t before = none; ///< The patch before.
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

  int algebraic_intersection_number(const Way& loop) const
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

  /// Closes a way across the separator; false if that is in pieces.
  bool close(Way& way) const
  {
    std::map<std::size_t, std::size_t> before;
    std::queue<std::size_t> queue({way.front()});
    for(; !queue.empty(); queue.pop()) {
      std::size_t i = queue.front();
      for(std::size_t j : patches_[i].neighbors)
        if(j == way.back()) {
          for(; i != way.front(); i = before[i])
            way.push_back(i);
          return true;
        } else if(place_[j] == on_separator && before.emplace(j, i).second)
          queue.push(j);
    }
    return false;
  }

  /// Looks from both sides in turn: where a limb is cut off, only the smaller part of the shape is
  /// visited, twice. Where the two meet the way is as short as may be, but for a few patches.
  Way between_sides(const Local_separator& separator)
  {
    constexpr std::array<Place, 2> side = {on_first_side, on_second_side};
    std::array<std::vector<std::size_t>, 2> reached;
    std::array<std::size_t, 2> meeting = {none, none}; // a patch reached from either side
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
        meeting[0] == none && next < std::min(reached[0].size(), reached[1].size()); ++next)
      for(std::size_t k = 0; k < 2; ++k)
        for(const auto& edge : edges_[reached[k][next]])
          if(place_[edge.patch] != on_separator)
            reach(edge.patch, reached[k][next], k);
    Way way;
    for(std::size_t i = meeting[1]; i != none; i = visits_[i].before)
      way.push_back(i);
    std::reverse(way.begin(), way.end());
    for(std::size_t i = meeting[0]; i != none; i = visits_[i].before)
      way.push_back(i);
    for(const std::vector<std::size_t>& visited : reached)
      for(std::size_t i : visited)
        visits_[i] = Visit();
    return way;
  }

  const std::vector<Patch>& patches_;
  const Patch_graph& edges_;

  // Of every patch; as at the beginning between calls.
  std::vector<Place> place_;
  std::vector<Visit> visits_;
};

/// Tells separators that cut a limb from those that cut nothing: from the one side to the other
/// there is no way on the surface, or only one around a hole of the shape. An arc that ends in holes
/// of the data, or a ring around a dent, has a way around through the solid.
template <typename ConcurrencyTag = Sequential_tag>
class Separator_test
{
public:
  Separator_test(const std::vector<Patch>& patches, const std::vector<Sample>& samples,
             const Ball_overlaps& joints, const Winding_number& winding_number)
      : patches_(patches)
      , samples_(samples)
      , winding_number_(winding_number)
      , edges_(patches, joints.pairs(), [&](std::size_t k) { return joints.overlap(k); })
      , search_([&] { return Path_search(patches_, edges_); })
  {}

  /// What is to be known of a separator.
  struct Evidence
  {
    Path_search::Way way;                     ///< From one side to the other.
    std::size_t band = Separator_test::unknown; ///< Like that way, if it is long.
  };

  /// Of many separators at once, on all threads.
  std::vector<Evidence> evidence(const std::vector<const Local_separator*>& separators)
  {
    std::vector<Evidence> result(separators.size());
    parallel_for<ConcurrencyTag>(result.size(), [&](std::size_t k) {
      result[k].way = search_.local().around(*separators[k]);
    });
    const std::size_t known = bands_.size();
    for(std::size_t k = 0; k < result.size(); ++k)
      if(result[k].way.size() > around_an_end)
        result[k].band = band_like(Closed_curve(positions(result[k].way), resolution(*separators[k]),
                                               winding_number_));
    parallel_for<ConcurrencyTag>(bands_.size() - known, [&](std::size_t k) {
      Band& band = bands_[known + k];
      band.shrinks = Closed_curve(band.start).shrinks();
    });
    return result;
  }

  /// Whether the separator cuts a limb.
  bool cuts(const Local_separator& separator, const Evidence& evidence)
  {
    // A loop that shrinks to a point inside the shape crosses no cross-section once.
    if(std::any_of(shrinking_.begin(), shrinking_.end(), [&](const Path_search::Way& loop) {
         return search_.local().algebraic_intersection_number(loop, separator) != 0;
       }))
      return false;
    if(evidence.band == unknown)
      return evidence.way.empty();
    const bool shrinks = bands_[evidence.band].shrinks;
    if(shrinks)
      shrinking_.push_back(search_.local().closed(evidence.way, separator));
    return !shrinks;
  }

private:
  static constexpr std::size_t unknown = std::numeric_limits<std::size_t>::max();
  /// What the points show as a hole is surrounded by more patches than that.
  static constexpr std::size_t around_an_end = 4;

  /// A closed way that is in the solid.
  struct Band
  {
    Closed_curve start;
    bool is_solid; ///< Else another one cannot become this one.
    bool shrinks;  ///< To a point.
  };

  /// The index of a band that shrinks if this one does: a known one, or a new one.
  std::size_t band_like(const Closed_curve& start)
  {
    const auto found = std::find_if(bands_.begin(), bands_.end(), [&](const Band& band) {
      return band.is_solid && start.can_become(band.start);
    });
    const auto result = static_cast<std::size_t>(found - bands_.begin());
    if(found == bands_.end())
      bands_.push_back({start, start.is_solid(), false});
    return result;
  }

  double resolution(const Local_separator& separator) const
  {
    return patches_[separator.patches.front()].spacing;
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
  const Patch_graph edges_; ///< Along limbs.
  Per_thread<ConcurrencyTag, Path_search> search_;

  // Found so far.
  std::vector<Band> bands_;
  std::vector<Path_search::Way> shrinking_; ///< Closed.
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SEPARATORS_SEPARATOR_TEST_H
