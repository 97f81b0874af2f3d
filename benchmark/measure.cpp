// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "measure.h"

#include <CGAL/IO/Curve_skeleton_3.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

Row failed_row(const std::string& file, const std::exception& error)
{
  Row row;
  row.shape = name_of(file);
  row.status = error.what();
  return row;
}

void measure(Row& row, const Outcome& outcome, const std::vector<Point>& points)
{
  row.method = outcome.method;
  row.points = points.size();
  measure_skeleton(row, outcome.skeleton, points);
  row.seconds = outcome.seconds;
  row.status = outcome.status;
}

void write_miss(const std::string& folder, const Row& row, const Skeleton& skeleton,
                const std::vector<Point>& points)
{
  if(folder.empty() || row.exact().value_or(true))
    return;
  std::filesystem::create_directories(folder);
  std::string name = row.shape;
  for(const std::string& part : {row.seed, row.size, row.places, row.variant})
    name += part.empty() ? "" : '_' + part;
  std::replace(name.begin(), name.end(), ' ', '_'); // "noise 0.010 turn 1"
  name = folder + '/' + name;
  std::ofstream cloud(name + ".xyz");
  cloud.precision(9);
  for(const Point& p : points)
    cloud << p << '\n';
  CGAL::IO::write_curve_skeleton(name + '_' + row.method + ".ply", skeleton);
}
