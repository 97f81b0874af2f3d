// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_MEASURE_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_MEASURE_H

#include "Quality_options.h"
#include "Row.h"
#include "Outcome.h"
#include "skeleton_distance.h"
#include "spurs.h"
#include "unexplained_points.h"

#include <CGAL/IO/Curve_skeleton_3.h>
#include <CGAL/bounding_box.h>

#include <cmath>
#include <exception>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

inline double diagonal(const std::vector<Point>& points)
{
  const auto box = CGAL::bounding_box(points.begin(), points.end());
  return std::sqrt(CGAL::squared_distance(box.min(), box.max()));
}

/// Without folder and extension.
inline std::string name_of(const std::string& file)
{
  return std::filesystem::path(file).stem().string();
}

/// For a file that could not be read.
inline Row failed_row(const std::string& file, const std::exception& error)
{
  Row row;
  row.shape = name_of(file);
  row.status = error.what();
  return row;
}

/// Fills in what can be measured with nothing but the cloud.
inline void measure(Row& row, const Outcome& outcome, const std::vector<Point>& points)
{
  row.method = outcome.method;
  row.points = points.size();
  row.got = count_graph(outcome.skeleton);
  row.spurs = metrics::count_spurs(outcome.skeleton);
  row.unexplained = metrics::unexplained_points(points, outcome.skeleton);
  row.seconds = outcome.seconds;
  row.status = outcome.status;
}

/// Fills in how far the skeleton is from that of the clean cloud.
inline void measure_stability(Row& row, const Skeleton& skeleton, const Skeleton& clean,
                              double diagonal)
{
  constexpr double step = 0.002; // diagonals; a fraction of any limb's radius
  if(num_vertices(skeleton) == 0 || num_vertices(clean) == 0)
    return;
  const auto distance = metrics::two_way_distance(skeleton, clean, step * diagonal);
  row.moved_mean = distance.mean / diagonal;
  row.moved_maximum = distance.maximum / diagonal;
}

/// Writes the cloud and the skeleton of a row that is not exact, to be looked at.
inline void write_miss(const std::string& folder, const Row& row, const Skeleton& skeleton,
                       const std::vector<Point>& points)
{
  if(folder.empty() || row.exact().value_or(true))
    return;
  std::filesystem::create_directories(folder);
  std::string name = folder + '/' + row.shape;
  for(const std::string& part : {row.seed, row.variant})
    name += part.empty() ? "" : '_' + part;
  std::ofstream cloud(name + ".xyz");
  cloud.precision(9);
  for(const Point& p : points)
    cloud << p << '\n';
  CGAL::IO::write_curve_skeleton(name + '_' + row.method + ".ply", skeleton);
}

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_MEASURE_H
