// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_UNION_FIND_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_UNION_FIND_H

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Disjoint sets of the numbers below `size` (union-find with path halving, O(log n) amortised per
/// call). The root of a set is its smallest number: it does not depend on the order of the calls.
class Union_find
{
public:
  explicit Union_find(std::size_t size) : parent_(size)
  {
    std::iota(parent_.begin(), parent_.end(), std::size_t(0));
  }

  /// Returns the smallest number of the set of `v`.
  std::size_t find(std::size_t v)
  {
    while(parent_[v] != v)
      v = parent_[v] = parent_[parent_[v]];
    return v;
  }

  /// Joins the sets of `a` and `b`. Returns whether they were different.
  bool join(std::size_t a, std::size_t b)
  {
    if(parent_[a] == parent_[b]) // common case
      return false;
    a = find(a);
    b = find(b);
    parent_[(std::max)(a, b)] = (std::min)(a, b);
    return a != b;
  }

private:
  std::vector<std::size_t> parent_;
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_UNION_FIND_H
