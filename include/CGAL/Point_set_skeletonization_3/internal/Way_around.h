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

#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <tuple>
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
      , joints_(joints)
      , winding_number_(winding_number)
      , state_(patches.size(), unseen)
      , before_(patches.size())
  {}

  /// Whether the separator cuts a limb.
  bool cuts(const Local_separator& separator)
  {
    // What the points show as a hole is surrounded by more patches than that.
    constexpr std::size_t around_an_end = 4;
    const std::vector<Vector3> loop = shortest(separator);
    if(loop.empty())
      return true;
    return loop.size() > around_an_end &&
           !Rubber_band(loop, patches_[separator.patches.front()].spacing, winding_number_).shrinks();
  }

private:
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  enum State : char { unseen, seen, on_separator, on_far_side };

  void mark(std::size_t i, State state)
  {
    state_[i] = state;
    marked_.push_back(i);
  }

  /// The samples along the shortest way from one side to the other; none if there is no way.
  std::vector<Vector3> shortest(const Local_separator& separator)
  {
    using Step = std::tuple<double, std::size_t, std::size_t>; // way, patch, the one before
    std::priority_queue<Step, std::vector<Step>, std::greater<Step>> queue;
    for(std::size_t i : separator.patches)
      mark(i, on_separator);
    for(std::size_t i : separator.sides[1])
      mark(i, on_far_side);
    for(std::size_t i : separator.sides[0])
      queue.emplace(0, i, none);
    std::size_t last = none;
    while(!queue.empty() && last == none) {
      const Step step = queue.top();
      queue.pop();
      const std::size_t i = std::get<1>(step);
      if(state_[i] == seen || state_[i] == on_separator)
        continue;
      before_[i] = std::get<2>(step);
      if(state_[i] == on_far_side)
        last = i;
      mark(i, seen);
      for(std::size_t j : patches_[i].neighbors)
        if(state_[j] != seen && joints_.are_joined(i, j))
          queue.emplace(std::get<0>(step) + (patches_[i].mean - patches_[j].mean).norm(), j, i);
    }
    for(std::size_t i : marked_)
      state_[i] = unseen;
    marked_.clear();
    std::vector<Vector3> way;
    for(; last != none; last = before_[last])
      way.push_back(samples_[last].position);
    return way;
  }

  const std::vector<Patch>& patches_;
  const std::vector<Sample>& samples_;
  const Limb_joints& joints_;
  const Winding_number& winding_number_;
  std::vector<State> state_; ///< `unseen` between calls.
  std::vector<std::size_t> marked_;
  std::vector<std::size_t> before_;
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_WAY_AROUND_H
