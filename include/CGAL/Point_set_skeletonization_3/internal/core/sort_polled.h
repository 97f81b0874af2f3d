// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_SORT_POLLED_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_SORT_POLLED_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Progress.h>

#include <algorithm>
#include <functional>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Sorts as `std::sort()` does, in pieces between which it can be cancelled: millions of elements
/// take longer than a user waits. O(n log n).
template <typename Iterator, typename Less = std::less<>>
void sort_polled(Iterator begin, Iterator end, const Less& less = Less())
{
  constexpr auto piece = 1 << 15;
  Progress::poll();
  if(end - begin <= piece)
    return std::sort(begin, end, less);
  const Iterator middle = begin + (end - begin) / 2;
  sort_polled(begin, middle, less);
  sort_polled(middle, end, less);
  Progress::poll();
  std::inplace_merge(begin, middle, end, less);
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_SORT_POLLED_H
