// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The regression command: how good the skeletons are, in one table. `quality --help` tells the
// options.

#include "Quality_options.h"
#include "clouds.h"
#include "detail.h"
#include "generated.h"
#include "meshes.h"
#include "read_points.h"
#include "scans.h"
#include "sweep.h"

#include <CLI/CLI.hpp>

#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>

namespace {

void add_common_options(CLI::App& command, Quality_options& options)
{
  command.add_flag("--as-published", options.as_published,
                   "also rows of the published method, for comparison");
  command.add_option("--csv", options.csv, "also write the table as CSV")->type_name("FILE");
  command
      .add_option("--misses", options.misses, "write cloud and skeleton where the counts are wrong")
      ->type_name("FOLDER");
  command.add_option("--threads", options.threads, "clouds at a time [1]")
      ->type_name("N")
      ->check(CLI::Range(1, 1024));
}

void add_points_option(CLI::App& command, Quality_options& options)
{
  command.add_option("--points", options.points, "points of a cloud [20000]")
      ->type_name("N")
      ->check(CLI::Range(1, 100000000));
}

void add_beside_option(CLI::App& command, Quality_options& options)
{
  command
      .add_option("--beside", options.beside,
                  "what stands beside every cloud, and must not change its skeleton [nothing]")
      ->type_name("FILE");
}

void add_turns_option(CLI::App& command, Quality_options& options)
{
  command.add_option("--turns", options.turns, "also every input in N random orientations [0]")
      ->type_name("N")
      ->check(CLI::Range(0, 1000));
}

void add_seed_options(CLI::App& command, Quality_options& options, unsigned int seeds = 5)
{
  command.preparse_callback([&options, seeds](std::size_t) { options.seeds = seeds; });
  command
      .add_option("--seeds", options.seeds, "shapes of a family [" + std::to_string(seeds) + "]")
      ->type_name("N")
      ->check(CLI::Range(1, 1000000));
  command.add_option("--first-seed", options.first_seed, "seed of the first shape [1]")
      ->type_name("N")
      ->check(CLI::Range(1, 1000000));
}

CLI::App* add_generated(CLI::App& app, Quality_options& options)
{
  CLI::App* command = app.add_subcommand("generated", "shapes whose skeleton is known");
  command->add_option("--families", options.families, "some only, a,b")->delimiter(',');
  command->add_option("--variants", options.variants, "some only, a,b")->delimiter(',');
  add_seed_options(*command, options);
  add_points_option(*command, options);
  add_beside_option(*command, options);
  add_common_options(*command, options);
  return command;
}

CLI::App* add_detail(CLI::App& app, Quality_options& options)
{
  constexpr int most_levels = 16; // 65536 ends
  CLI::App* command = app.add_subcommand("detail", "trees with ever finer limbs");
  add_points_option(*command, options);
  command->add_option("--levels", options.levels, "one tree with 2^N ends [four trees]")
      ->type_name("N")
      ->check(CLI::Range(1, most_levels))
      ->needs("--points");
  command->get_option("--points")->needs("--levels");
  add_seed_options(*command, options, 1);
  add_common_options(*command, options);
  return command;
}

CLI::App* add_meshes(CLI::App& app, Quality_options& options)
{
  CLI::App* command = app.add_subcommand("meshes", "points sampled on closed meshes");
  command->add_option("FILES", options.files, "meshes; of a folder, CGAL's sample models")
      ->required();
  command->add_option("--noise", options.noise, "standard deviations, in diagonals [0,0.005,0.01]")
      ->delimiter(',');
  add_turns_option(*command, options);
  command->add_flag("--mcf", options.mean_curvature_flow,
                    "also rows of CGAL's mean curvature flow on the mesh");
  add_points_option(*command, options);
  add_beside_option(*command, options);
  add_common_options(*command, options);
  return command;
}

CLI::App* add_clouds(CLI::App& app, Quality_options& options)
{
  CLI::App* command = app.add_subcommand("clouds", "raw clouds");
  command->add_option("FILES", options.files, "FILE, or FILE:COMPONENTS:CYCLES if they are known")
      ->required();
  command->add_flag("--trees", options.are_trees,
                    "they are trees that grow along z: also count the curves in their trunks");
  add_turns_option(*command, options);
  add_beside_option(*command, options);
  add_common_options(*command, options);
  return command;
}

CLI::App* add_scans(CLI::App& app, Quality_options& options)
{
  CLI::App* command = app.add_subcommand("scans", "scans whose skeleton is known");
  CLI::Option* const files = command->add_option(
      "FILES", options.files, "CLOUD:REFERENCE.obj, instead of simulated scans");
  CLI::Option* const families =
      command->add_option("--families", options.families, "some only, a,b")->delimiter(',');
  command
      ->add_option("--meshes", options.meshes,
                   "closed meshes instead; of a folder, CGAL's sample models")
      ->type_name("FILE")
      ->excludes(files)
      ->excludes(families);
  command->add_option("--variants", options.variants, "some only, a,b")->delimiter(',');
  command->add_option("--points", options.sizes, "about, of a cloud [5000,20000,80000]")
      ->delimiter(',')
      ->check(CLI::Range(100, 100000000));
  command->add_option("--places", options.places, "of the scanner [1,3,6]")
      ->delimiter(',')
      ->check(CLI::Range(1, 6));
  add_seed_options(*command, options, 1);
  add_beside_option(*command, options);
  add_common_options(*command, options);
  return command;
}

CLI::App* add_sweep(CLI::App& app, Quality_options& options)
{
  CLI::App* command =
      app.add_subcommand("sweep", "every option moved by 20 %, on generated shapes");
  add_seed_options(*command, options);
  add_points_option(*command, options);
  command->add_option("--options", options.constants, "some only, a,b")
      ->delimiter(',')
      ->check(CLI::IsMember(sweep::option_names()));
  command->add_option("--threads", options.threads, "clouds at a time [1]")
      ->type_name("N")
      ->check(CLI::Range(1, 1024));
  return command;
}

/// \return the exit code \throw std::runtime_error with a message of one line
int run(int argc, char** argv)
{
  Quality_options options;
  CLI::App app("How good skeletons are, in one table.", "quality");
  app.require_subcommand(1);
  const CLI::App* generated = add_generated(app, options);
  const CLI::App* detail = add_detail(app, options);
  const CLI::App* meshes = add_meshes(app, options);
  const CLI::App* clouds = add_clouds(app, options);
  const CLI::App* scans = add_scans(app, options);
  const CLI::App* sweep = add_sweep(app, options);
  try {
    app.parse(argc, argv);
  } catch(const CLI::CallForHelp& help) {
    return app.exit(help);
  } catch(const CLI::ParseError& error) {
    throw std::runtime_error(std::string(error.what()) + " (try --help)");
  }
  if(!options.beside.empty())
    options.neighbor = read_points<Point>(options.beside);
  if(generated->parsed())
    generated::run(options);
  if(detail->parsed())
    detail::run(options);
  if(meshes->parsed())
    meshes::run(options);
  if(clouds->parsed())
    clouds::run(options);
  if(scans->parsed())
    scans::run(options);
  if(sweep->parsed())
    sweep::run(options);
  return EXIT_SUCCESS;
}

} // namespace

int main(int argc, char** argv)
{
  try {
    return run(argc, argv);
  } catch(const std::exception& error) {
    std::cerr << "quality: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }
}
