// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "clouds.h"

#include "Model.h"
#include "Report.h"
#include "measure.h"
#include "read_points.h"
#include "trunk_curves.h"

#include <cstddef>
#include <exception>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace clouds {

namespace {

struct Cloud
{
  std::string file;
  Truth truth;
};

/// From `FILE`, `FILE:COMPONENTS` or `FILE:COMPONENTS:CYCLES`. \throw std::runtime_error
Cloud parse(const std::string& argument)
{
  Cloud cloud;
  std::istringstream in(argument);
  std::getline(in, cloud.file, ':');
  char colon;
  std::size_t components, cycles;
  if(in >> components)
    cloud.truth.components = components;
  if(in >> colon >> cycles)
    cloud.truth.cycles = cycles;
  if(!in.eof())
    throw std::runtime_error("'" + argument + "' is not FILE:COMPONENTS:CYCLES");
  return cloud;
}

/// Where z of a file is up, in one of its orientations.
metrics::Vector turned_up(unsigned int turn)
{
  const std::vector<Point> z = turned({Point(0, 0, 0), Point(0, 0, 1)}, turn);
  return metrics::to_point(z[1]) - metrics::to_point(z[0]);
}

/// \param variant how the cloud was turned; empty if it was not
/// \param up where z is then
void add_rows(const Cloud& cloud, const std::string& variant, const std::vector<Point>& points,
              const metrics::Vector& up, const Quality_options& options, std::vector<Row>& rows)
{
  for(const Outcome& outcome : skeletonize(points, options)) {
    Row row;
    row.shape = name_of(cloud.file);
    row.variant = variant;
    row.truth = cloud.truth;
    measure(row, outcome, points);
    if(options.are_trees) {
      const metrics::Trunk_curves trunk = metrics::trunk_curves(outcome.skeleton, points, up);
      row.trunk = trunk.single;
      row.trunk_off = trunk.off;
    }
    write_miss(options.misses, row, outcome.skeleton, points);
    rows.push_back(row);
  }
}

std::vector<Row> rows_of(const Cloud& cloud, const Quality_options& options)
{
  try {
    const std::vector<Point> points = read_points<Point>(cloud.file);
    std::vector<Row> rows;
    add_rows(cloud, "", points, {0, 0, 1}, options, rows);
    for(unsigned int turn = 1; turn <= options.turns; ++turn)
      add_rows(cloud, "turn " + std::to_string(turn), turned(points, turn), turned_up(turn),
               options, rows);
    return rows;
  } catch(const std::exception& error) {
    return {failed_row(cloud.file, error)};
  }
}

Layout layout()
{
  using namespace columns;
  return {{text("cloud", 20, &Row::shape), text("variant", 8, &Row::variant), points(),
           text("method", 9, &Row::method), exact(), count("comp", &Graph_counts::components),
           truth("comp_true", &Truth::components), count("cycles", &Graph_counts::cycles),
           truth("cycles_true", &Truth::cycles), count("ends", &Graph_counts::ends),
           count("junctions", &Graph_counts::junctions), known("trunk", &Row::trunk),
           number("trunk_off", &Row::trunk_off, 2), spurs(),
           number("unexplained", &Row::unexplained, 4),
           number("seconds", &Row::seconds, 2), text("status", 2, &Row::status)},
          {group_name(), group_method(), group_size(), share("exact%", &Row::exact),
           share("comp%", &Row::components_exact), share("cycles%", &Row::cycles_exact),
           share("trunk%", &Row::trunk_exact), mean("trunk_off", &Row::trunk_off, 3), total_spurs(),
           mean("unexplained", &Row::unexplained, 4), mean("seconds", &Row::seconds, 2)},
          {}};
}

} // namespace

void run(const Quality_options& options)
{
  std::vector<Cloud> clouds;
  for(const std::string& argument : options.files)
    clouds.push_back(parse(argument));
  const auto work = [&](std::size_t job) { return rows_of(clouds[job], options); };
  report(options, clouds.size(), work, layout());
}

} // namespace clouds
