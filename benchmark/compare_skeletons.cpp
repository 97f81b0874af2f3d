// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The comparison: every method on every input. `compare_skeletons --help` tells the options.

#include "comparison/compare.h"
#include "comparison/compared_columns.h"
#include "comparison/generated_model.h"
#include "comparison/lost_figures.h"
#include "report/html_report.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

std::string list_of_names()
{
  std::string list = "Families:";
  for(const std::string& family : generated_names())
    list += ' ' + family;
  list += "\nMethods:";
  for(const Registered_method& method : registered_methods())
    list += "\n  " + method.name + ": " + method.source;
  return list;
}

void add_options(CLI::App& app, Comparison_options& options)
{
  app.add_option("INPUT", options.inputs,
                 "meshes, to draw points from, clouds, or FAMILY:SEED, generated")
      ->required();
  app.add_option("--methods", options.methods, "some only, a,b")->delimiter(',');
  app.add_option("--noise", options.noise, "standard deviations, in diagonals [0]")
      ->delimiter(',')
      ->check(CLI::Range(0., 1.));
  app.add_option("--points", options.points, "points drawn from a mesh [20000]")
      ->type_name("N")
      ->check(CLI::Range(1, 100000000));
  app.add_option("--time-limit", options.time_limit, "for a method on an input [600]")
      ->type_name("SECONDS")
      ->check(CLI::PositiveNumber);
  app.add_option("--seed", options.seed, "of the points and the noise [0]")->type_name("N");
  app.add_option("--seeds", options.seeds, "clouds of every input, with this and the next seeds [1]")
      ->type_name("N")
      ->check(CLI::Range(1, 1000));
  app.add_flag("--decimate", options.decimate, "methods on meshes also on decimated ones");
  app.add_option("--output", options.output, "for results.csv and report.html")
      ->type_name("FOLDER")
      ->required();
  app.footer(list_of_names());
}

std::vector<Registered_method> chosen_methods(const Comparison_options& options)
{
  return options.methods.empty() ? registered_methods() : methods_named(options.methods);
}

/// Prints the rows as they come, and keeps them in a file that is renamed when it is complete.
std::vector<Compared> run(const Comparison_options& options)
{
  const std::vector<Registered_method> methods = chosen_methods(options);
  std::filesystem::create_directories(options.output);
  const std::string csv = options.output + "/results.csv";
  std::ofstream nowhere;
  Table<Compared> screen(std::cout, screen_columns());
  Table<Compared> file(nowhere, file_columns(options), csv + ".part");
  std::vector<Compared> rows;
  for(const std::string& input : options.inputs)
    compare(input, methods, options, [&](const Compared& row) {
      screen.add(row);
      file.add(row);
      rows.push_back(row);
    });
  std::filesystem::rename(csv + ".part", csv);
  return rows;
}

/// \return the exit code \throw std::exception with a message of one line
int run(int argc, char** argv)
{
  Comparison_options options;
  CLI::App app("Curve skeletons by every method, side by side.", "compare_skeletons");
  add_options(app, options);
  try {
    app.parse(argc, argv);
  } catch(const CLI::CallForHelp& help) {
    return app.exit(help);
  } catch(const CLI::ParseError& error) {
    throw std::runtime_error(std::string(error.what()) + " (try --help)");
  }
  std::sort(options.noise.begin(), options.noise.end()); // the clean ones first
  const std::vector<Compared> rows = run(options);
  write_html_report(options.output + "/report.html", rows);
  print_standing(std::cout, standing_of(rows));
  return EXIT_SUCCESS;
}

} // namespace

int main(int argc, char** argv)
{
  try {
    return run(argc, argv);
  } catch(const std::exception& error) {
    std::cerr << "compare_skeletons: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }
}
