// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_PARALLEL_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_PARALLEL_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Progress.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#endif

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Whether loops run on the calling thread only or on all threads of TBB; without TBB always
/// sequential. The results are the same, bit for bit.
enum class Concurrency { sequential, parallel };

/// A reference to what can be called with the ends of a range. Unlike `std::function` it neither
/// copies nor owns: there are a hundred loops, and each would make a compiler instantiate that.
class Range_function
{
public:
  template <typename Body>
  Range_function(const Body& body)
    : body_(&body), call_([](const void* b, std::size_t begin, std::size_t end) {
        (*static_cast<const Body*>(b))(begin, end);
      })
  {}

  void operator()(std::size_t begin, std::size_t end) const { call_(body_, begin, end); }

private:
  const void* body_;
  void (*call_)(const void*, std::size_t, std::size_t);
};

/// Calls `body(begin, end)` for disjoint ranges that cover [0, `size`), in any order, perhaps
/// concurrently. Two calls must not write to the same memory. Every loop can be cancelled between
/// the ranges, by `Progress::poll()`.
inline void parallel_for_ranges(Concurrency concurrency, std::size_t size,
                                Range_function body)
{
#ifdef CGAL_LINKED_WITH_TBB
  if(concurrency == Concurrency::parallel) {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, size),
                      [&](const auto& range) {
                        Progress::poll();
                        body(range.begin(), range.end());
                      });
    return;
  }
#endif
  static_cast<void>(concurrency);
  constexpr std::size_t ranges = 256, least = 64; // short enough, and hardly slower than one
  const std::size_t step = (std::max)(least, size / ranges);
  for(std::size_t begin = 0; begin < size; begin += step) {
    Progress::poll();
    body(begin, (std::min)(begin + step, size));
  }
}

/// Calls `body(i)` for 0 <= i < `size`; otherwise as `parallel_for_ranges()`.
template <typename Body>
void parallel_for(Concurrency concurrency, std::size_t size, const Body& body)
{
  parallel_for_ranges(concurrency, size, [&body](std::size_t begin, std::size_t end) {
    for(std::size_t i = begin; i < end; ++i)
      body(i);
  });
}

/// Calls `first()` and `second()`, perhaps concurrently.
inline void parallel_invoke(Concurrency concurrency, const std::function<void()>& first,
                            const std::function<void()>& second)
{
#ifdef CGAL_LINKED_WITH_TBB
  if(concurrency == Concurrency::parallel) {
    tbb::parallel_invoke(first, second);
    return;
  }
#endif
  static_cast<void>(concurrency);
  first();
  second();
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_PARALLEL_H
