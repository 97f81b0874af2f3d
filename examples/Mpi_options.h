// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_EXAMPLES_MPI_OPTIONS_H
#define POINT_SET_SKELETONIZATION_3_EXAMPLES_MPI_OPTIONS_H

#include "Options.h"

#include <CLI/CLI.hpp>

#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

/// The command line of `skeletonize_point_set_mpi`.
struct Mpi_options : Options
{
  std::vector<std::string> tiles;
  std::string list;              ///< of more tiles
  std::string segment_directory; ///< for the points of each tile with their branch; empty: none
};

/// Returns nothing if it was only to show help.
/// \throw std::runtime_error with a message of one line
inline std::optional<Mpi_options> parse_mpi_options(int argc, char** argv)
{
  Mpi_options options;
  CLI::App app("Curve skeleton of a raw point cloud in tiles, which many processes read.",
               "skeletonize_point_set_mpi");
  app.footer("Example:\n"
             "  mpirun -n 4 skeletonize_point_set_mpi plot/*.las -o plot.ply\n"
             "The skeleton is the same for any number of processes and any order of the tiles.");
  app.set_version_flag("--version", std::string("skeletonize_point_set_mpi ") + VERSION);
  app.add_option("TILE", options.tiles, "a file with a part of the cloud: " +
                                            point_files::names_of_formats());
  add_tile_list_option(app, options.list);
  add_box_option(app, options.box);
  add_reading_options(app, options.format, options.skip_invalid);
  add_cells_option(app, options.cells);
  add_feature_option(app, options.smallest_feature);
  add_output_option(app, options);
  add_branch_options(app, options);
  app.add_option("--segment-directory", options.segment_directory,
                 "read the tiles again, and write the points of each with their branch, NAME.ply")
      ->type_name("DIR");
  add_topology_options(app, options);
  app.get_option("--split")->excludes(app.get_option("--segment-directory"));
  add_running_options(app, options);
  try {
    app.parse(argc, argv);
  } catch(const CLI::CallForHelp&) {
    std::cout << app.help();
    return {};
  } catch(const CLI::CallForVersion&) {
    std::cout << app.version() << '\n';
    return {};
  } catch(const CLI::ParseError& error) {
    throw std::runtime_error(std::string(error.what()) + " (try --help)");
  }
  if(options.tiles.empty() && options.list.empty())
    throw std::runtime_error("give a TILE or a list of --tiles (try --help)");
  check_box("--box", options.box);
  check_feature(options);
  options.input = options.tiles.empty() ? options.list : options.tiles.front(); // names the pages
  check_outputs(options);
  create_folder(options.segment_directory);
  return options;
}

#endif // POINT_SET_SKELETONIZATION_3_EXAMPLES_MPI_OPTIONS_H
