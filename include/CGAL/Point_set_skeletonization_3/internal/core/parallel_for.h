// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_PARALLEL_FOR_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_PARALLEL_FOR_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Per_thread.h>

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#endif

#include <cstddef>
#include <type_traits>
#include <utility>

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

/// Calls `first()` and `second()`, possibly concurrently under `Parallel_tag`.
template <typename ConcurrencyTag, typename First, typename Second>
void parallel_invoke(const First& first, const Second& second)
{
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr(std::is_convertible<ConcurrencyTag, Parallel_tag>::value) {
    tbb::parallel_invoke(first, second);
    return;
  }
#endif
  first();
  second();
}

/// Calls `body(i, value)` for `0 <= i < size`, where `value` is a copy of `none`; under `Parallel_tag`
/// one of every thread, and `value.add(other)` puts them together. Which thread called what, and in
/// which order they are put together, must not matter to the result.
template <typename ConcurrencyTag, typename Value, typename Body>
Value parallel_sum(std::size_t size, const Value& none, const Body& body)
{
  Per_thread<ConcurrencyTag, Value> values([&] { return none; });
  parallel_for<ConcurrencyTag>(size, [&](std::size_t i) { body(i, values.local()); });
  Value* sum = nullptr;
  values.for_each([&](Value& value) {
    if(sum)
      sum->add(std::move(value));
    else
      sum = &value;
  });
  if(!sum)
    return none;
  return std::move(*sum);
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_PARALLEL_FOR_H
