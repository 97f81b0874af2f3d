// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_GENERATED_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_GENERATED_H

#include "Quality_options.h"

/// `quality generated`: shapes whose skeleton is known.
namespace generated {

/// Prints the table and its summary. \throw std::runtime_error
void run(const Quality_options& options);

} // namespace generated

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_GENERATED_H
