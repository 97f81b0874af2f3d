// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_CLOUDS_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_CLOUDS_H

#include "Quality_options.h"

/// `quality clouds`: raw clouds, of which something may be known.
namespace clouds {

/// Prints the table and its summary. \throw std::runtime_error
void run(const Quality_options& options);

} // namespace clouds

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_CLOUDS_H
