// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_MEASURE_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_MEASURE_H

#include "Model.h"
#include "Outcome.h"
#include "Row.h"
#include "measure_skeleton.h"

#include <exception>
#include <string>
#include <vector>

/// For a file that could not be read.
Row failed_row(const std::string& file, const std::exception& error);

/// Fills in what can be measured with nothing but the cloud.
void measure(Row& row, const Outcome& outcome, const std::vector<Point>& points);

/// Writes the cloud and the skeleton of a row that is not exact, to be looked at.
void write_miss(const std::string& folder, const Row& row, const Skeleton& skeleton,
                const std::vector<Point>& points);

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_MEASURE_H
