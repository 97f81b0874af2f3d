// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Reads a point cloud, writes its curve skeleton. `skeletonize_point_set --help` tells the options.

#include "End_on_signals.h"
#include "Options.h"
#include "Progress_bar.h"
#include "accumulate.h"
#include "for_each_point.h"
#include "read_points.h"
#include "sample_surface.h"
#include "skeletonize_cloud.h"
#include "succeeds.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/IO/Gaussian_mixture_builder_3.h>
#include <CGAL/Point_set_skeletonization_3/internal/io/Output_file.h>
#include <CGAL/Real_timer.h>

#include <cstddef>
#include <cstdlib>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

std::vector<Point> sampled(const Points_and_faces<Point>& mesh, const Options& options)
{
  try {
    std::vector<Point> points = sample_surface(mesh, options.sample, options.seed);
    if(points.empty())
      throw std::runtime_error("cannot sample '" + options.input + "': it has no faces");
    return points;
  } catch(const std::bad_alloc&) {
    throw std::runtime_error("not enough memory for " + std::to_string(options.sample) +
                             " points; draw fewer by --sample");
  }
}

Points_and_faces<Point> load(const Options& options)
{
  Progress_bar bar(!options.quiet);
  Points_and_faces<Point> input =
      read_points_and_faces<Point>(options.input, reading_options(options, bar));
  if(options.sample != 0)
    input.points = sampled(input, options);
  input.faces.clear();
  return input;
}

// The builder, and the number of rows that were skipped.
std::pair<Builder, std::size_t> stream(const Options& options)
{
  if(is_moments_file(options.input)) {
    Builder builder;
    CGAL::IO::read_moments(options.input, builder);
    return {std::move(builder), 0};
  }
  if(options.box.empty() && !point_files::can_be_read_twice(options.input))
    throw std::runtime_error("'" + options.input +
                             "' cannot be read twice: give --box, or do without --stream");
  Progress_bar bar(!options.quiet);
  const point_files::Reading_options reading = reading_options(options, bar);
  const std::vector<double>& b = options.box;
  Builder builder =
      b.empty() ? Builder(bulk_of_files<Point>({options.input}, reading), options.cells)
                : Builder(CGAL::Bbox_3(b[0], b[1], b[2], b[3], b[4], b[5]), options.cells);
  const std::size_t skipped = for_each_point<Point>(
      options.input, [&builder](const Point& p) { builder.insert(p); }, reading);
  return {std::move(builder), skipped};
}

void run(const Options& options)
{
  std::vector<Reported> reported;
  Reading reading;
  if(options.stream || options.split || is_moments_file(options.input)) {
    CGAL::Real_timer timer;
    timer.start();
    auto [builder, skipped] = stream(options);
    reading.seconds = timer.time();
    reading.points = builder.number_of_points();
    if(options.skip_invalid)
      reading.skipped = skipped;
    reported = skeletonize_streamed(std::move(builder), reading, options);
  } else {
    CGAL::Point_set_skeletonization_3::internal::Output_transaction outputs;
    const Points_and_faces<Point> input = load(options);
    reading.points = input.points.size();
    if(options.skip_invalid)
      reading.skipped = input.number_of_skipped;
    Result result = skeletonize(input.points, options);
    write_outputs(with_branches(result.skeleton, input.points, reading.points, options), options);
    outputs.commit();
    const Graph_counts counts = count_graph(result.skeleton);
    reported.push_back({reading, std::move(result), counts});
  }
  for(const Reported& r : reported)
    report(r, options);
}

int main(int argc, char** argv)
{
  end_on_signals(
      [] { CGAL::Point_set_skeletonization_3::internal::unfinished_files().abandon(); });
  const std::string program = "skeletonize_point_set", no_memory = "not enough memory";
  Command_line line;
  bool success = succeeds(
      program, [&] { line = parse_options(argc, argv); }, no_memory);
  if(line.accumulation)
    success = succeeds(
        program, [&] { accumulate(*line.accumulation); }, no_memory + "; try fewer --cells");
  if(line.merging)
    success = succeeds(
        program, [&] { merge(*line.merging); }, no_memory);
  for(const Options& options : line.jobs)
    success = succeeds(
                  program, [&] { run(options); },
                  no_memory + " for '" + options.input + "'; try --stream") &&
              success;
  return success ? EXIT_SUCCESS : EXIT_FAILURE;
}
