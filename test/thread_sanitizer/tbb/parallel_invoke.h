// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Stands in for the header of TBB in the preset `threads`, see parallel_for.h.

#ifndef POINT_SET_SKELETONIZATION_3_TEST_THREAD_SANITIZER_PARALLEL_INVOKE_H
#define POINT_SET_SKELETONIZATION_3_TEST_THREAD_SANITIZER_PARALLEL_INVOKE_H

#include <atomic>
#include <exception>
#include <thread>

namespace tbb {

/// The second function on a thread of its own, unless there are many.
template <typename First, typename Second>
void parallel_invoke(const First& first, const Second& second)
{
  constexpr int many = 16;
  static std::atomic<int> running(0);
  if(running.fetch_add(1, std::memory_order_relaxed) >= many) {
    running.fetch_sub(1, std::memory_order_relaxed);
    first();
    second();
    return;
  }
  std::exception_ptr error, other_error;
  std::thread other([&] {
    try {
      second();
    } catch(...) {
      other_error = std::current_exception();
    }
  });
  try {
    first();
  } catch(...) {
    error = std::current_exception();
  }
  other.join();
  running.fetch_sub(1, std::memory_order_relaxed);
  if(error || other_error)
    std::rethrow_exception(error ? error : other_error);
}

} // namespace tbb

#endif // POINT_SET_SKELETONIZATION_3_TEST_THREAD_SANITIZER_PARALLEL_INVOKE_H
