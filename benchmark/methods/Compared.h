// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_COMPARED_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_COMPARED_H

#include "../Measurements.h"
#include "Method.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

/// One method on one input: a row of the comparison. If the status is not `ok`, there is no
/// skeleton and nothing is measured but the time and the memory.
struct Compared
{
  std::string input;      ///< name of the file, without folder and extension
  double noise = 0;       ///< standard deviation, in diagonals of the bounding box
  unsigned int seed = 0;  ///< of the points and the noise
  std::string method;     ///< as in the registry
  std::string input_kind; ///< points, points+normals, mesh, wrapped mesh or decimated mesh
  std::string status;     ///< ok, failed, time_limit, invalid or unreadable
  std::string message;    ///< why not ok, one line; empty if ok
  std::vector<std::pair<std::string, double>> stages; ///< name and wall-clock seconds, in order
  double seconds = not_measured;                      ///< wall-clock, all stages
  double peak_memory = not_measured;                  ///< MiB, of the process that ran the method
  Measurements measured;
  Skeleton skeleton; ///< with radii: where the method knows none, to the nearest clean point
  std::shared_ptr<const std::vector<Point>> cloud; ///< the noisy points; null if unreadable
};

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_COMPARED_H
