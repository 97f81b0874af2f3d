// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_DETAIL_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_DETAIL_H

#include "Quality_options.h"

/// `quality detail`: how fine the details are that a skeleton still has.
namespace detail {

/// Prints the table and its summary. \throw std::runtime_error
void run(const Quality_options& options);

} // namespace detail

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_DETAIL_H
