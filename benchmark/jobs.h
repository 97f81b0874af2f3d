// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_JOBS_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_JOBS_H

#include <cstddef>
#include <utility>
#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/parallel_pipeline.h>
#endif

/// Calls `use(work(i))` for i = 0, 1, ..., `size` - 1: `use` in this order and one at a time,
/// `work` on `threads` threads if there is TBB.
template <typename Work, typename Use>
void run_jobs(std::size_t size, std::size_t threads, const Work& work, const Use& use)
{
#ifdef CGAL_LINKED_WITH_TBB
  if(threads > 1) {
    using Result = decltype(work(size));
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    std::size_t next = 0;
    const auto number = [&next, size](tbb::flow_control& flow) {
      if(next == size)
        flow.stop();
      return next++;
    };
    tbb::parallel_pipeline(
        threads, tbb::make_filter<void, std::size_t>(tbb::filter_mode::serial_in_order, number) &
                     tbb::make_filter<std::size_t, Result>(tbb::filter_mode::parallel, work) &
                     tbb::make_filter<Result, void>(tbb::filter_mode::serial_in_order, use));
    return;
  }
#else
  (void)threads;
#endif
  for(std::size_t i = 0; i < size; ++i)
    use(work(i));
}

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_JOBS_H
