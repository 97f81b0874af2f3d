// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_LOCAL_SEPARATORS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_LOCAL_SEPARATORS_H

#include <CGAL/Point_set_skeletonization_3/internal/Neighbor_search.h>
#include <CGAL/Point_set_skeletonization_3/internal/patch_adjacency.h>
#include <CGAL/Point_set_skeletonization_3/internal/samples.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Patches that cut the surface around them in two: a ring around a limb, whatever the shape of its
/// cross-section. (Baerentzen & Rotenberg 2021 call it a local separator and find it by growing a
/// region from a point of the surface; we grow it from the centre of the shape, and so closer to a
/// cross-section.)
struct Local_separator
{
  std::vector<std::size_t> patches;               ///< Ascending.
  std::array<std::vector<std::size_t>, 2> sides;  ///< Patches next to it on either side, ascending.
  double length = 0;                              ///< Sum of the spacings of its patches.
};

/// Patches that a ball around a medial sample holds, as far as they hang together, and their front:
/// the patches next to them. The ball grows until the front falls apart.
class Growing_region
{
public:
  Growing_region(std::size_t seed, const std::vector<Patch>& patches,
                 const std::vector<Sample>& samples)
    : patches_(patches), center_(samples[seed].position),
      radius_(std::max(samples[seed].radius, patches[seed].spacing / 2)),
      state_(patches.size(), State::outside)
  {
    enqueue(seed);
  }

  /// Grows the region until a separator runs through it. False if the ball became larger than
  /// anything that a limb at this place can be, or holds half of the shape: there is no limb here.
  bool find(Local_separator& separator)
  {
    // The ball of a round limb touches it all around; a tenth more holds its ring of patches.
    constexpr double growth = 1.1;
    // The flattest limbs that are seen: their width over their thickness.
    constexpr double flattest = 6;

    for(reach_ = growth * radius_; reach_ < flattest * radius_; reach_ *= growth) {
      grow();
      if(queue_.empty() || region_.size() > patches_.size() / 2)
        return false;
      std::vector<Front> fronts = connected_fronts();
      if(splits(fronts)) {
        separator = cut(fronts);
        return true;
      }
    }
    return false;
  }

private:
  enum class State : char { outside, front, region };
  using Front = std::vector<std::size_t>;
  using Distant = std::pair<double, std::size_t>;

  void enqueue(std::size_t i)
  {
    state_[i] = State::front;
    queue_.emplace((patches_[i].mean - center_).norm(), i);
  }

  void grow()
  {
    while(!queue_.empty() && (queue_.top().first <= reach_ || region_.empty())) {
      const std::size_t i = queue_.top().second;
      queue_.pop();
      state_[i] = State::region;
      region_.push_back(i);
      for(std::size_t j : patches_[i].neighbors)
        if(state_[j] == State::outside)
          enqueue(j);
    }
  }

  /// The front in parts that do not hang together, the largest first. Parts that the patches beyond
  /// connect, within not much more than the ball, are one: the region went around a hole of the data.
  std::vector<Front> connected_fronts() const
  {
    // The way around a hole of the data as wide as the limb is in a ball of 1.4 times its radius, the
    // way around a hole of the shape is not.
    constexpr double detour = 1.5;
    constexpr double few_patches = 4;
    const double shell =
      std::max(detour * reach_, reach_ + few_patches * patches_[region_.front()].spacing);

    std::vector<Front> fronts;
    std::vector<bool> seen(patches_.size(), false);
    std::vector<std::size_t> stack;
    for(std::size_t start : front()) {
      if(seen[start])
        continue;
      fronts.emplace_back();
      seen[start] = true;
      stack.push_back(start);
      while(!stack.empty()) {
        const std::size_t i = stack.back();
        stack.pop_back();
        if(state_[i] == State::front)
          fronts.back().push_back(i);
        for(std::size_t j : patches_[i].neighbors) {
          if(seen[j] || state_[j] == State::region ||
             (state_[j] == State::outside && (patches_[j].mean - center_).norm() > shell))
            continue;
          seen[j] = true;
          stack.push_back(j);
        }
      }
    }
    std::sort(fronts.begin(), fronts.end(), [](const Front& a, const Front& b) {
      return a.size() != b.size() ? a.size() > b.size() : a < b;
    });
    return fronts;
  }

  /// The patches next to the region, ascending.
  Front front() const
  {
    Front result;
    for(std::size_t i : region_)
      for(std::size_t j : patches_[i].neighbors)
        if(state_[j] == State::front)
          result.push_back(j);
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  /// Whether a limb goes on from the region in two directions. More than two make a junction, which
  /// is what the separators around it leave over; a small part of the front is a dent or a bump.
  static bool splits(const std::vector<Front>& fronts)
  {
    constexpr double least_share = 0.2; // of the larger: limbs do not taper faster in one ball
    constexpr double junction_share = 0.3;
    const auto share = [&](std::size_t a, std::size_t b) {
      return static_cast<double>(fronts[a].size()) / static_cast<double>(fronts[b].size());
    };
    return fronts.size() >= 2 && share(1, 0) >= least_share &&
           (fronts.size() == 2 || share(2, 1) <= junction_share);
  }

  /// The patches halfway between the first two fronts: those of the one half next to the other.
  Local_separator cut(const std::vector<Front>& fronts) const
  {
    const std::vector<int> half = nearest_front(fronts);
    std::vector<bool> beyond(patches_.size(), false);
    for(std::size_t k = 0; k < 2; ++k)
      for(std::size_t i : fronts[k])
        beyond[i] = true;
    // Of the first half what touches the second; of the second what touches the first front.
    const auto separates = [&](std::size_t i, std::size_t j) {
      return !beyond[i] && ((half[i] == 1 && half[j] == 2) ||
                            (half[i] == 2 && half[j] == 1 && beyond[j]));
    };
    Local_separator result;
    for(std::size_t i = 0; i < patches_.size(); ++i)
      if(half[i] != 0 && std::any_of(patches_[i].neighbors.begin(), patches_[i].neighbors.end(),
                                     [&](std::size_t j) { return separates(i, j); })) {
        result.patches.push_back(i);
        result.length += patches_[i].spacing;
      }
    for(std::size_t i : result.patches)
      for(std::size_t j : patches_[i].neighbors)
        if(half[j] != 0 && !std::binary_search(result.patches.begin(), result.patches.end(), j))
          result.sides[static_cast<std::size_t>(half[j] - 1)].push_back(j);
    for(std::vector<std::size_t>& side : result.sides) {
      std::sort(side.begin(), side.end());
      side.erase(std::unique(side.begin(), side.end()), side.end());
    }
    return result;
  }

  /// For every patch of the region and its front which of the first two fronts is nearer along the
  /// surface, 1 or 2; 0 for others.
  std::vector<int> nearest_front(const std::vector<Front>& fronts) const
  {
    using Step = std::tuple<double, std::size_t, int>;
    std::vector<int> half(patches_.size(), 0);
    std::priority_queue<Step, std::vector<Step>, std::greater<Step>> queue;
    for(int k = 0; k < 2; ++k)
      for(std::size_t i : fronts[static_cast<std::size_t>(k)])
        queue.emplace(0, i, k + 1);
    while(!queue.empty()) {
      const Step step = queue.top();
      queue.pop();
      const std::size_t i = std::get<1>(step);
      if(half[i] != 0)
        continue;
      half[i] = std::get<2>(step);
      for(std::size_t j : patches_[i].neighbors)
        if(state_[j] != State::outside && half[j] == 0)
          queue.emplace(std::get<0>(step) + (patches_[i].mean - patches_[j].mean).norm(), j, half[i]);
    }
    return half;
  }

  const std::vector<Patch>& patches_;
  Vector3 center_;
  double radius_;
  double reach_ = 0;
  std::vector<State> state_;
  std::vector<std::size_t> region_;
  std::priority_queue<Distant, std::vector<Distant>, std::greater<Distant>> queue_;
};

/// Separators all over the shape, the shortest first and none touching a patch of another: of all
/// that cross one place the tightest is the cross-section.
inline std::vector<Local_separator> disjoint_separators(const std::vector<Patch>& patches,
                                                        const std::vector<Sample>& samples)
{
  // Regions grown from places closer than this share of their radius would be the same.
  constexpr double same_place = 0.15;
  const Neighbor_search places(samples.size(), [&](std::size_t i) { return samples[i].position; });
  std::vector<bool> tried(patches.size(), false);
  std::vector<Local_separator> found;
  std::vector<std::size_t> near;
  for(std::size_t seed = 0; seed < patches.size(); ++seed) {
    if(tried[seed])
      continue;
    places.within(samples[seed].position, same_place * samples[seed].radius, near);
    for(std::size_t i : near)
      tried[i] = true;
    Local_separator separator;
    if(Growing_region(seed, patches, samples).find(separator))
      found.push_back(std::move(separator));
  }
  std::sort(found.begin(), found.end(), [](const Local_separator& a, const Local_separator& b) {
    return a.length != b.length ? a.length < b.length : a.patches < b.patches;
  });

  std::vector<bool> taken(patches.size(), false);
  std::vector<Local_separator> result;
  for(Local_separator& separator : found) {
    if(std::any_of(separator.patches.begin(), separator.patches.end(),
                   [&](std::size_t i) { return taken[i]; }))
      continue;
    for(std::size_t i : separator.patches)
      taken[i] = true;
    result.push_back(std::move(separator));
  }
  return result;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_LOCAL_SEPARATORS_H
