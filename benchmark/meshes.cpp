// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"

#include "Report.h"
#include "measure.h"
#include "methods/mcf.h"
#include "methods/remesh.h"
#include "nearest_point_radii.h"

#include <cstddef>
#include <exception>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace meshes {

namespace {

/// Closed models among CGAL's sample data, with limbs, loops, or both.
const std::vector<std::string>& sample_models()
{
  static const std::vector<std::string> models = {
      "anchor",     "armadillo", "bear",     "bull", "cactus",  "camel", "cow",         "dino",
      "diplodocus", "eight",     "elephant", "elk",  "hand",    "homer", "joint",       "knot",
      "knot1",      "knot2",     "man",      "pipe", "retinal", "rotor", "triceratops", "tripod"};
  return models;
}

/// \throw std::runtime_error
Model read_mesh(const std::string& file, std::size_t number_of_points)
{
  Model model = read_model(file, number_of_points, 0);
  if(model.components.empty())
    throw std::runtime_error("it has no faces");
  return model;
}

Row row_of(const Model& model, const std::string& variant, const Outcome& outcome,
           const std::vector<Point>& points, const Quality_options& options)
{
  Row row;
  row.shape = model.name;
  row.variant = variant;
  measure(row, outcome, points);
  measure_in_model(row, outcome.skeleton, model);
  if(!model.is_closed && row.status == "ok")
    row.status = "mesh is open";
  write_miss(options.misses, row, outcome.skeleton, points);
  return row;
}

/// Between the noise and the number of the turn.
const std::string turn_mark = " turn ";

/// The rows of the clouds of a model. \param turn how it was turned, for the names of the variants
void add_cloud_rows(const Model& model, const std::string& turn, const Quality_options& options,
                    std::vector<Row>& rows)
{
  std::map<std::string, Skeleton> clean; // by method
  for(const double noise : options.noise) {
    const std::vector<Point> points = with_noise(model.points, noise * model.diagonal, 1);
    for(const Outcome& outcome : skeletonize(points, options)) {
      Row row = row_of(model, "noise " + fixed(noise, 3) + turn, outcome, points, options);
      if(noise > 0)
        measure_stability(row, outcome.skeleton, clean[outcome.method], model.diagonal);
      else
        clean[outcome.method] = outcome.skeleton;
      rows.push_back(row);
    }
  }
}

/// The rows of a model's mesh: as it is, and remeshed, as the coarse ones need it.
void add_mesh_rows(const Model& model, const Quality_options& options, std::vector<Row>& rows)
{
  constexpr double edge_length = 0.01; // diagonals; some 20 000 vertices
  const auto add = [&](const std::string& variant, const std::vector<Mesh>& components) {
    Method_input input;
    input.components = components;
    Outcome outcome = run_method("MCF", mcf, input);
    metrics::set_nearest_point_radii(outcome.skeleton, model.points);
    rows.push_back(row_of(model, variant, outcome, model.points, options));
  };
  add("mesh", model.components);
  add("fine mesh", remesh(model.components, edge_length * model.diagonal));
}

std::vector<Row> rows_of(const std::string& file, const Quality_options& options)
{
  try {
    const Model model = read_mesh(file, options.points);
    std::vector<Row> rows;
    add_cloud_rows(model, "", options, rows);
    for(unsigned int turn = 1; turn <= options.turns; ++turn)
      add_cloud_rows(turned(model, turn), turn_mark + std::to_string(turn), options, rows);
    if(options.mean_curvature_flow)
      add_mesh_rows(model, options, rows);
    return rows;
  } catch(const std::exception& error) {
    return {failed_row(file, error)};
  }
}

Layout layout()
{
  using namespace columns;
  return {{text("model", 16, &Row::shape), text("variant", 18, &Row::variant),
           text("method", 9, &Row::method), exact(), count("comp", &Graph_counts::components),
           truth("comp_true", &Truth::components), count("cycles", &Graph_counts::cycles),
           truth("cycles_true", &Truth::cycles), count("ends", &Graph_counts::ends),
           count("junctions", &Graph_counts::junctions), number("off_centre", &Row::off_centre, 3),
           number("inside", &Row::inside, 4), spurs(), number("unexplained", &Row::unexplained, 4),
           number("moved", &Row::moved_mean, 4), number("moved_max", &Row::moved_maximum, 4),
           number("seconds", &Row::seconds, 2), text("status", 2, &Row::status)},
          {group_name(), group_method(), group_size(), share("exact%", &Row::exact),
           share("comp%", &Row::components_exact), share("cycles%", &Row::cycles_exact),
           median("off_centre", &Row::off_centre, 3), mean("inside", &Row::inside, 4), outside(),
           total_spurs(), mean("unexplained", &Row::unexplained, 4),
           mean("moved", &Row::moved_mean, 4), mean("moved_max", &Row::moved_maximum, 4),
           mean("seconds", &Row::seconds, 2)},
          // Turned or not.
          {[](const Row& row) { return row.variant.substr(0, row.variant.find(turn_mark)); }}};
}

} // namespace

std::vector<std::string> chosen_files(const std::vector<std::string>& files)
{
  std::vector<std::string> result;
  for(const std::string& file : files)
    if(std::filesystem::is_directory(file))
      for(const std::string& model : sample_models())
        result.push_back((std::filesystem::path(file) / (model + ".off")).string());
    else
      result.push_back(file);
  return result;
}

void run(const Quality_options& options)
{
  const std::vector<std::string> files = chosen_files(options.files);
  const auto work = [&](std::size_t job) { return rows_of(files[job], options); };
  report(options, files.size(), work, layout());
}

} // namespace meshes
