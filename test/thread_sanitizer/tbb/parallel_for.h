// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Stands in for the header of TBB in the preset `threads`. TBB is not instrumented, so that the
// thread sanitizer would neither see which threads wait for which, nor who runs what.

#ifndef POINT_SET_SKELETONIZATION_3_TEST_THREAD_SANITIZER_PARALLEL_FOR_H
#define POINT_SET_SKELETONIZATION_3_TEST_THREAD_SANITIZER_PARALLEL_FOR_H

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace tbb {

/// Threads of its own for every loop, which take pieces of the range in turn.
template <typename Value, typename Body>
void parallel_for(const blocked_range<Value>& range, const Body& body)
{
  const std::size_t threads = global_control::active_value(global_control::max_allowed_parallelism);
  const Value piece = std::max<Value>(1, range.size() / (4 * threads));
  std::atomic<Value> next(range.begin());
  std::exception_ptr error;
  std::mutex error_is_set;
  const auto work = [&] {
    try {
      // Relaxed: the order of the pieces must not hide a missing order of what they do.
      for(Value begin; (begin = next.fetch_add(piece, std::memory_order_relaxed)) < range.end();)
        body(blocked_range<Value>(begin, std::min<Value>(begin + piece, range.end())));
    } catch(...) {
      const std::lock_guard<std::mutex> lock(error_is_set);
      error = std::current_exception();
      next = range.end();
    }
  };
  std::vector<std::thread> others;
  for(std::size_t i = 1; i < threads; ++i)
    others.emplace_back(work);
  work();
  for(std::thread& other : others)
    other.join();
  if(error)
    std::rethrow_exception(error);
}

} // namespace tbb

#endif // POINT_SET_SKELETONIZATION_3_TEST_THREAD_SANITIZER_PARALLEL_FOR_H
