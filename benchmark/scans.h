// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_SCANS_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_SCANS_H

#include "Quality_options.h"
#include "scanned_mesh.h"

#include "generator/Known_shape.h"

#include <cstddef>
#include <string>
#include <vector>

/// `quality scans`: clouds as scanners make them, with the skeleton that is to be found.
namespace scans {

/// Prints the table and its summary. \throw std::runtime_error
void run(const Quality_options& options);

/// How a shape is scanned, or sampled at random from all sides. The noise is that of a cheap
/// scanner, 2 mm on a plant of 2 m; nearly a third of the pulses is lost on dark or wet surfaces;
/// rows of pulses of a scanner with few beams are several times as far apart as the pulses of a
/// row.
struct Variant
{
  std::string name;
  double range_noise, mixed, lost;
  int beams; ///< distance of rows, in pulses
  bool is_sampled = false;
};

/// A cloud to come.
struct Job
{
  std::string shape; ///< a family, or the file of a mesh
  bool is_mesh;
  unsigned int seed;
  std::size_t size;
  int places; ///< of the scanner
  Variant variant;
};

/// All that are to be scanned.
std::vector<Job> chosen_jobs(const Quality_options& options);

/// What is scanned for a job. \throw std::runtime_error
Scene scene_of(const Job& job);

/// The cloud of a job.
std::vector<shapes::Vector> points_of(const Job& job, const shapes::Known_shape& shape);

} // namespace scans

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_SCANS_H
