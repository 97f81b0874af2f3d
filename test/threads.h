// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_TEST_THREADS_H
#define POINT_SET_SKELETONIZATION_3_TEST_THREADS_H

#include "catch2.h"

#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <cstddef>

/// Calls `check(concurrency)` sequentially, and with 1, 2, 3 and 8 threads if there is TBB.
template <typename Check>
void for_threads(const Check& check)
{
  using CGAL::Point_set_skeletonization_3::internal::Concurrency;
  check(Concurrency::sequential);
#ifdef CGAL_LINKED_WITH_TBB
  for(const std::size_t threads : {1u, 2u, 3u, 8u}) {
    CAPTURE(threads);
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    check(Concurrency::parallel);
  }
#endif
}

#endif // POINT_SET_SKELETONIZATION_3_TEST_THREADS_H
