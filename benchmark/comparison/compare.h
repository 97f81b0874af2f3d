// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_COMPARISON_COMPARE_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_COMPARISON_COMPARE_H

#include "../methods/Compared.h"
#include "../methods/registry.h"
#include "Comparison_options.h"

#include <functional>
#include <string>
#include <vector>

/// Runs the methods on a file or a generated shape with all seeds and levels of noise, and hands
/// over the rows as they come: one at least for every method, seed and level, whatever happens.
void compare(const std::string& input, const std::vector<Registered_method>& methods,
             const Comparison_options& options, const std::function<void(const Compared&)>& use);

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_COMPARISON_COMPARE_H
