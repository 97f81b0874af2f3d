// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_PERFORMANCE_RATIOS_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_PERFORMANCE_RATIOS_H

#include "Performance_row.h"

#include <ostream>
#include <vector>

/// Prints what the rows say in proportion, beside what is asked for. Times of one thread are CPU
/// seconds, which a busy machine stretches less; those of two against one are wall-clock seconds.
void print_ratios(std::ostream& out, const std::vector<Performance_row>& rows);

/// Prints the shares of the stages of this package with one thread.
void print_shares(std::ostream& out, const std::vector<Performance_row>& rows);

/// Prints how much of a core the runs of one thread had: less than all if the machine was busy.
void print_quietness(std::ostream& out, const std::vector<Performance_row>& rows);

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_PERFORMANCE_RATIOS_H
