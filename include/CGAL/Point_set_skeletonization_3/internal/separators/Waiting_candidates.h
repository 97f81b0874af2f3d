// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SEPARATORS_WAITING_CANDIDATES_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SEPARATORS_WAITING_CANDIDATES_H

#include <CGAL/Point_set_skeletonization_3/internal/separators/Local_separator.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Candidates for separators that wait to be tested, in their order. Knows which come first on all
/// of their patches: these do not depend on each other. Each patch keeps its candidates in order,
/// so all calls together are O(n) for n patches of candidates, but for sorting.
class Waiting_candidates
{
public:
  /// All wait. O(n). \pre each has a patch, and `patches` is larger than their numbers
  Waiting_candidates(const std::vector<Local_separator>& candidates, std::size_t patches)
    : front_(patches + 1, 0), waits_(candidates.size(), true), behind_(candidates.size(), 0)
  {
    for(const Local_separator& candidate : candidates)
      for(std::size_t i : candidate.patches)
        ++front_[i + 1];
    std::partial_sum(front_.begin(), front_.end(), front_.begin());
    end_.assign(front_.begin(), front_.end() - 1);
    on_patch_.resize(front_.back());
    for(std::size_t s = 0; s < candidates.size(); ++s) {
      for(std::size_t i : candidates[s].patches) {
        behind_[s] += end_[i] != front_[i] ? 1 : 0;
        on_patch_[end_[i]++] = s;
      }
      if(behind_[s] == 0)
        first_.push_back(s);
    }
  }

  /// Whether the `s`-th candidate waits.
  bool waits(std::size_t s) const { return waits_[s]; }

  /// The `s`-th candidate, `candidate`, waits no more.
  void remove(std::size_t s, const Local_separator& candidate)
  {
    waits_[s] = false;
    for(std::size_t i : candidate.patches)
      advance(i);
  }

  /// Returns those that wait on a patch, in order.
  std::vector<std::size_t> on_patch(std::size_t i) const
  {
    std::vector<std::size_t> result;
    std::copy_if(on_patch_.begin() + static_cast<std::ptrdiff_t>(front_[i]),
                 on_patch_.begin() + static_cast<std::ptrdiff_t>(end_[i]),
                 std::back_inserter(result), [&](std::size_t s) { return waits_[s]; });
    return result;
  }

  /// Returns those that wait, share no patch with an earlier one that waits, and were not returned
  /// before; in order.
  std::vector<std::size_t> take_first()
  {
    std::vector<std::size_t> result;
    for(std::size_t s : std::exchange(first_, {}))
      if(waits_[s])
        result.push_back(s);
    std::sort(result.begin(), result.end());
    return result;
  }

private:
  /// Finds the first one that waits on a patch.
  void advance(std::size_t i)
  {
    const std::size_t before = front_[i];
    while(front_[i] < end_[i] && !waits_[on_patch_[front_[i]]])
      ++front_[i];
    if(front_[i] != before && front_[i] < end_[i] && --behind_[on_patch_[front_[i]]] == 0)
      first_.push_back(on_patch_[front_[i]]);
  }

  std::vector<std::size_t> on_patch_; ///< Candidates on each patch, one patch after another.
  std::vector<std::size_t> front_, end_; ///< Of the rest of each patch.
  std::vector<bool> waits_;
  std::vector<std::size_t> behind_; ///< Number of patches where an earlier one waits.
  std::vector<std::size_t> first_;  ///< Those that come first, since `take_first()`.
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SEPARATORS_WAITING_CANDIDATES_H
