// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_MEASUREMENTS_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_MEASUREMENTS_H

#include "graph_counts.h"
#include "statistics.h"

#include <cstddef>
#include <optional>

/// What is known about a shape's skeleton.
struct Truth
{
  std::optional<std::size_t> components, cycles, ends;
  std::optional<std::size_t> junctions =
      std::nullopt; ///< where no two of them are one to a skeleton
};

/// How good a skeleton is. What cannot be known of it is not measured.
struct Measurements
{
  Truth truth;
  Graph_counts got;
  double inside = not_measured;     ///< share of the length
  double off_centre = not_measured; ///< median
  std::size_t spurs = 0;
  double unexplained = not_measured;                              ///< share of the points
  double moved_mean = not_measured, moved_maximum = not_measured; ///< from the clean cloud's
                                                                  ///< skeleton, diagonals
};

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_MEASUREMENTS_H
