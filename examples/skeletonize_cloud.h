// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_EXAMPLES_SKELETONIZE_CLOUD_H
#define POINT_SET_SKELETONIZATION_3_EXAMPLES_SKELETONIZE_CLOUD_H

// What the programs do with a cloud once it is read: compute the skeleton, write it, report.

#include "Options.h"
#include "Progress_bar.h"
#include "Skeletonized_cloud.h"
#include "graph_counts.h"
#include "read_file.h"

#include <CGAL/Curve_skeleton_3.h>
#include <CGAL/Point_assignment_3.h>
#include <CGAL/Simple_cartesian.h>

#include <cstddef>
#include <optional>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Skeleton = CGAL::Curve_skeleton_3<Kernel>;

/// What was read.
struct Reading
{
  std::size_t points = 0;
  std::optional<std::size_t> skipped; // rows, if that was asked for
  std::optional<double> seconds;      // of a stream: with the moments, which are not kept apart
  std::optional<std::size_t> part;    // its number from 1, if that was asked for
};

/// What --stats prints, and the skeleton.
struct Result
{
  Skeleton skeleton;
  std::size_t mixture = 0;
  std::size_t samples = 0;
  std::optional<std::size_t> iterations; // of the published method
  std::size_t outliers = 0;              // points that are in no vertex
  CGAL::Point_assignment_3<Kernel> assignment; // of points that were streamed
  double mixture_seconds = 0;
  double projection_seconds = 0;
  double linking_seconds = 0;
};

/// A skeleton that is to be reported.
struct Reported
{
  Reading reading;
  Result result;
  Graph_counts counts;
};

point_files::Reading_options reading_options(const Options& options, Progress_bar& bar);

/// Computes the skeleton of points.
Result skeletonize(const std::vector<Point>& points, const Options& options);

/// The skeleton with all that pages, pictures and tables show of it: `size` points were read, `points`
/// are those that were kept.
Skeletonized_cloud with_branches(const Skeleton& skeleton, const std::vector<Point>& points,
                                 std::size_t size, const Options& options);

/// Writes all that was asked for.
void write_outputs(const Skeletonized_cloud& cloud, const Options& options);

/// Computes and writes the skeleton of streamed points, or those of their parts.
std::vector<Reported> skeletonize_streamed(Builder builder, const Reading& reading,
                                           const Options& options);

/// Prints what was asked for.
void report(const Reported& r, const Options& options, const std::vector<double>& memory = {});

#endif // POINT_SET_SKELETONIZATION_3_EXAMPLES_SKELETONIZE_CLOUD_H
