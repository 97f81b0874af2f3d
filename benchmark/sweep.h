// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_SWEEP_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_SWEEP_H

#include "Quality_options.h"

#include <string>
#include <vector>

/// Moves every option of the default method by a share of its value, to either side, and prints how
/// many skeletons of generated shapes and simulated scans are exact then, and how many changed
/// their counts.
namespace sweep {

/// The names of the options, in their order.
std::vector<std::string> option_names();

/// Moves `options.constants` only, or all if there are none.
void run(const Quality_options& options);

} // namespace sweep

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_SWEEP_H
