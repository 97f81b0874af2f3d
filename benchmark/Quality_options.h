// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_QUALITY_OPTIONS_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_QUALITY_OPTIONS_H

#include "methods/Method.h"

#include <cstddef>
#include <string>
#include <vector>

/// The command line of `quality`. What a command does not use keeps its default.
struct Quality_options
{
  std::vector<std::string> families; ///< all if empty
  std::vector<std::string> constants; ///< names of options of the method; all if empty
  std::vector<std::string> variants; ///< all if empty
  unsigned int seeds = 1;            ///< shapes of every family
  unsigned int first_seed = 1;       ///< of the first of them

  std::vector<std::string> files;
  std::vector<std::string> meshes; ///< to be scanned
  std::vector<double> noise = {0, 0.005, 0.01}; ///< standard deviations, in diagonals
  unsigned int turns = 0;                       ///< orientations of every input beside its own
  bool mean_curvature_flow = false;
  bool are_trees = false; ///< whether all clouds are trees that grow along z

  int levels = 0; ///< of a tree; 0: the trees of the table

  std::vector<std::size_t> sizes = {5000, 20000, 80000}; ///< points of the scans
  std::vector<int> places = {1, 3, 6};                   ///< of the scanner

  std::size_t points = 20000;
  std::string beside;          ///< what stands beside every cloud; nothing if empty
  std::vector<Point> neighbor; ///< the points of that
  bool as_published = false;
  std::size_t threads = 1; ///< clouds at a time
  std::string csv;         ///< none if empty
  std::string misses;      ///< folder for clouds whose skeleton is not exact; none if empty
};

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_QUALITY_OPTIONS_H
