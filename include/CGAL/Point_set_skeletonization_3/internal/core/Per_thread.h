// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_PER_THREAD_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_PER_THREAD_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Progress.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/combinable.h>
#endif

#include <algorithm>
#include <cstddef>
#include <functional>
#include <optional>
#include <utility>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// One object per thread, as scratch memory for the body of a `parallel_for()`. Results must not
/// depend on which of them is used.
template <typename Object>
class Per_thread
{
public:
  /// `make()` creates an object.
  Per_thread(Concurrency concurrency, const std::function<Object()>& make)
#ifdef CGAL_LINKED_WITH_TBB
    : of_threads_(make)
#endif
  {
#ifdef CGAL_LINKED_WITH_TBB
    if(concurrency == Concurrency::parallel)
      return;
#endif
    static_cast<void>(concurrency);
    only_.emplace(make());
  }

  /// The object of the calling thread.
  Object& local()
  {
#ifdef CGAL_LINKED_WITH_TBB
    if(!only_)
      return of_threads_.local();
#endif
    return *only_;
  }

  /// Calls `visit(object)` for each object created so far.
  template <typename Visit>
  void for_each(const Visit& visit)
  {
#ifdef CGAL_LINKED_WITH_TBB
    if(!only_)
      return of_threads_.combine_each(visit);
#endif
    visit(*only_);
  }

private:
  std::optional<Object> only_;
#ifdef CGAL_LINKED_WITH_TBB
  tbb::combinable<Object> of_threads_;
#endif
};

/// Calls `body(i, value)` for 0 <= i < `size`, where `value` is a copy of `zero`, one per thread.
/// Returns their sum by `value.add(other)`. It must not depend on the assignment to threads or the
/// order of the sum. Reports the progress after every `slice` calls.
template <typename Value, typename Body>
Value parallel_sum(Concurrency concurrency, std::size_t size, const Value& zero, const Body& body,
                   const Progress& progress = Progress(), std::size_t slice = std::size_t(1) << 10)
{
  Per_thread<Value> values(concurrency, [&] { return zero; });
  for(std::size_t first = 0; first < size; first += slice) {
    const std::size_t end = (std::min)(size, first + slice);
    parallel_for(concurrency, end - first,
                 [&](std::size_t i) { body(first + i, values.local()); });
    progress(static_cast<double>(end) / static_cast<double>(size));
  }
  Value* sum = nullptr;
  values.for_each([&](Value& value) {
    if(sum)
      sum->add(std::move(value));
    else
      sum = &value;
  });
  if(!sum)
    return zero;
  return std::move(*sum);
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_PER_THREAD_H
