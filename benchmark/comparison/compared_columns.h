// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_COMPARISON_COMPARED_COLUMNS_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_COMPARISON_COMPARED_COLUMNS_H

#include "../Table.h"
#include "../methods/Compared.h"
#include "Comparison_options.h"

#include <vector>

/// The columns of the comparison that fit on a screen.
std::vector<Table<Compared>::Column> screen_columns();

/// All of them, for the CSV file.
std::vector<Table<Compared>::Column> file_columns(const Comparison_options& options);

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_COMPARISON_COMPARED_COLUMNS_H
