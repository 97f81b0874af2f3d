// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PARALLEL_FOR_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PARALLEL_FOR_H

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#endif

#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Calls `body(i)` for `0 <= i < size`, in any order and possibly concurrently under `Parallel_tag`.
/// A body must write to places of its own only; then the result has the same bits for any number
/// of threads.
template <typename ConcurrencyTag, typename Body>
void parallel_for(std::size_t size, const Body& body)
{
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr(std::is_convertible<ConcurrencyTag, Parallel_tag>::value) {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, size), [&](const auto& range) {
      for(std::size_t i = range.begin(); i != range.end(); ++i)
        body(i);
    });
    return;
  }
#else
  static_assert(!std::is_convertible<ConcurrencyTag, Parallel_tag>::value,
                "Parallel_tag is enabled but TBB is unavailable.");
#endif
  for(std::size_t i = 0; i < size; ++i)
    body(i);
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PARALLEL_FOR_H
