// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scans.h"

#include "Report.h"
#include "chosen.h"
#include "measure.h"
#include "measure_scan.h"
#include "meshes.h"
#include "read_points.h"
#include "reference.h"
#include "to_points.h"

#include "generator/clouds.h"
#include "generator/families.h"
#include "generator/scanned_families.h"
#include "generator/scanner.h"

#include <cstddef>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

namespace scans {

namespace {

const std::vector<Variant> all_variants = {
    {"clean", 0, 0, 0, 1},
    {"range_noise", 0.001, 0.5, 0, 1},
    {"drop_outs", 0, 0, 0.3, 1},
    {"few_beams", 0, 0, 0, 5},
    {"sampled", 0, 0, 0, 1, true}};

/// Rows of a cloud, by every method. \param row what is known about the cloud, and the truth
std::vector<Row> rows_of(Row row, const Skeleton& reference,
                         const shapes::Known_shape& shape, const std::vector<Point>& points,
                         const Quality_options& options)
{
  std::vector<Outcome> outcomes = skeletonize(points, options);
  outcomes.push_back(baseline(points));
  std::vector<Row> rows;
  for(const Outcome& outcome : outcomes) {
    measure(row, outcome, points);
    measure_scan(row, outcome.skeleton, reference, shape, points);
    write_miss(options.misses, row, outcome.skeleton, points);
    rows.push_back(row);
  }
  return rows;
}

std::vector<Row> rows_of(const Job& job, const Quality_options& options)
{
  try {
    const Scene scene = scene_of(job);
    Row row;
    row.shape = scene.shape.family;
    row.seed = std::to_string(job.seed);
    row.variant = job.variant.name;
    row.size = std::to_string(job.size);
    row.places = std::to_string(job.places);
    row.truth.components = scene.shape.components;
    row.truth.cycles = scene.shape.cycles;
    return rows_of(row, scene.reference, scene.shape, to_points(points_of(job, scene.shape)),
                   options);
  } catch(const std::exception& error) {
    return {failed_row(job.shape, error)};
  }
}

/// \param argument `CLOUD:REFERENCE.obj`
std::vector<Row> rows_of(const std::string& argument, const Quality_options& options)
{
  const std::size_t colon = argument.rfind(':');
  const std::string cloud = argument.substr(0, colon);
  try {
    if(colon == std::string::npos)
      throw std::runtime_error("there is no reference behind a colon");
    Row row;
    row.shape = name_of(cloud);
    const Skeleton reference = read_reference(argument.substr(colon + 1));
    const Graph_counts truth = count_graph(reference);
    row.truth.components = truth.components;
    row.truth.cycles = truth.cycles;
    const shapes::Known_shape unknown;
    return rows_of(row, reference, unknown, read_points<Point>(cloud), options);
  } catch(const std::exception& error) {
    return {failed_row(cloud, error)};
  }
}

Layout layout()
{
  using namespace columns;
  return {{text("cloud", 20, &Row::shape),
           text("seed", 4, &Row::seed),
           text("places", 6, &Row::places),
           text("variant", 11, &Row::variant),
           points(),
           text("method", 9, &Row::method),
           exact(),
           count("comp", &Graph_counts::components),
           count("cycles", &Graph_counts::cycles),
           truth("cycles_true", &Truth::cycles),
           number("found", &Row::found, 3),
           number("true", &Row::true_share, 3),
           number("centred", &Row::centred, 3),
           count("ends", &Graph_counts::ends),
           known("ends_true", &Row::seen_ends),
           number("unsupported", &Row::unsupported, 3),
           number("radius", &Row::radius, 2),
           number("seconds", &Row::seconds, 2),
           text("status", 2, &Row::status)},
          {group_name(), group_method(), group_size(), share("exact%", &Row::exact),
           share("comp%", &Row::components_exact), share("cycles%", &Row::cycles_exact),
           mean("found", &Row::found, 3), mean("true", &Row::true_share, 3),
           mean("centred", &Row::centred, 3), share("ends15%", &Row::ends_close),
           mean("unsupported", &Row::unsupported, 3), mean("radius", &Row::radius, 2),
           mean("seconds", &Row::seconds, 2)},
          {[](const Row& row) { return row.shape; }, [](const Row& row) { return row.size; },
           [](const Row& row) { return row.places; }, [](const Row& row) { return row.variant; }}};
}

/// The families named; if none is, those that only a scan can show.
std::vector<std::string> chosen_families(const std::vector<std::string>& names)
{
  std::vector<std::string> all = shapes::scanned_family_names();
  if(names.empty())
    return all;
  all.insert(all.end(), shapes::family_names().begin(), shapes::family_names().end());
  return chosen(names, all, "family");
}

} // namespace

std::vector<Job> chosen_jobs(const Quality_options& options)
{
  const auto name_of = [](const Variant& variant) { return variant.name; };
  const bool are_meshes = !options.meshes.empty();
  const std::vector<std::string> shapes = are_meshes
                                            ? meshes::chosen_files(options.meshes)
                                            : chosen_families(options.families);
  std::vector<Job> jobs;
  for(const std::string& shape : shapes)
    for(unsigned int i = 0; i < options.seeds; ++i)
      for(const std::size_t size : options.sizes)
        for(const int places : options.places)
          for(const Variant& variant : chosen(options.variants, all_variants, name_of, "variant"))
            jobs.push_back({shape, are_meshes, options.first_seed + i, size, places, variant});
  return jobs;
}

Scene scene_of(const Job& job)
{
  if(job.is_mesh)
    return scanned_mesh(job.shape, job.seed);
  const shapes::Known_shape shape = shapes::scanned_shape(job.shape, job.seed);
  return {shape, reference_of(shape)};
}

std::vector<shapes::Vector> points_of(const Job& job, const shapes::Known_shape& shape)
{
  if(job.variant.is_sampled) // where others are seen from other places, draws other points
    return shapes::sample_all(shape, job.size, 10 * job.seed + static_cast<unsigned>(job.places));
  const shapes::Scan_options how = {job.size, job.places, job.variant.range_noise,
                                    job.variant.mixed, job.variant.lost, job.variant.beams};
  return shapes::scan(shape, how, job.seed).points;
}

void run(const Quality_options& options)
{
  if(!options.files.empty()) {
    const auto work = [&](std::size_t job) { return rows_of(options.files[job], options); };
    Layout of_files = layout();
    of_files.keys.clear(); // they are about simulated scans
    report(options, options.files.size(), work, of_files);
    return;
  }
  const std::vector<Job> jobs = chosen_jobs(options);
  const auto work = [&](std::size_t job) { return rows_of(jobs[job], options); };
  report(options, jobs.size(), work, layout());
}

} // namespace scans
