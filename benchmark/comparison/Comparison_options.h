// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_COMPARISON_COMPARISON_OPTIONS_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_COMPARISON_COMPARISON_OPTIONS_H

#include <cstddef>
#include <string>
#include <vector>

/// The command line of `compare_skeletons`.
struct Comparison_options
{
  std::vector<std::string> inputs;  ///< files or generated shapes
  std::vector<std::string> methods; ///< all if empty
  std::vector<double> noise = {0};  ///< standard deviations, in diagonals, ascending
  std::size_t points = 20000;       ///< drawn from a mesh
  double time_limit = 600;          ///< seconds, for a method on an input
  unsigned int seed = 0;            ///< of the points and the noise, the first one
  unsigned int seeds = 1;           ///< number of clouds of an input, each with its seed
  bool decimate = false;            ///< methods on meshes also on decimated ones
  std::string output;               ///< folder
};

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_COMPARISON_COMPARISON_OPTIONS_H
