// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_COMPARISON_LOST_FIGURES_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_COMPARISON_LOST_FIGURES_H

#include "../methods/Compared.h"

#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

/// A figure of an input with noise in which a method is first, of those that take raw points, and
/// this package is not within 5 % of it.
struct Lost_figure
{
  std::string input;
  double noise;
  unsigned int seed;
  std::string figure; ///< cycles, ends, off_centre, explained or moved
  double ours;        ///< not a number if there is no skeleton, or it cannot be measured
  double best;
  std::string best_method;
};

/// This package among the methods that take raw points.
struct Standing
{
  std::size_t compared = 0;      ///< figures that at least one method has, on all inputs
  std::vector<Lost_figure> lost; ///< those of them in which this package is behind
};

/// Cycles and ends count as they differ from the truth, and where that is known.
Standing standing_of(const std::vector<Compared>& rows);

/// The lost figures as a table, and how many they are; nothing if there is nothing to compare.
void print_standing(std::ostream& out, const Standing& standing);

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_COMPARISON_LOST_FIGURES_H
