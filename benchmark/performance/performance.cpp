// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// How fast the skeletons are, and in how much memory, beside what else CGAL does with the same
// points. `performance --help` tells the options.

#include "Csv.h"
#include "Table.h"
#include "contestants.h"
#include "measure_runs.h"
#include "ratios.h"

#include "Model.h"
#include "forked.h"
#include "sample_surface.h"

#include <CLI/CLI.hpp>
#include <CGAL/IO/write_ply_points.h>

#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

namespace {

struct Options
{
  std::vector<std::string> files;
  std::size_t points = 20000;
  std::vector<std::size_t> large = {1000000, 10000000};
  std::size_t runs = 3;
  double time_limit = 600; ///< seconds
  std::string csv;         ///< standard output if empty
};

/// CGAL's sample models with limbs and loops.
const std::vector<std::string> sample_models = {"dino",  "elephant", "armadillo",
                                                "camel", "man",      "knot2"};

std::vector<std::string> chosen_files(const std::vector<std::string>& arguments)
{
  std::vector<std::string> files;
  for(const std::string& argument : arguments)
    if(std::filesystem::is_directory(argument))
      for(const std::string& model : sample_models)
        files.push_back((std::filesystem::path(argument) / (model + ".off")).string());
    else
      files.push_back(argument);
  return files;
}

struct Contestant
{
  std::string method;
  std::size_t threads;
  std::function<void(Stopwatch&)> run;
};

/// Runs methods and writes their rows as soon as those of an input are there.
class Contest
{
public:
  /// \throw std::runtime_error
  explicit Contest(const Options& options)
      : options_(options)
      , csv_(options.csv.empty() ? Csv(std::cout) : Csv(options.csv))
  {
    csv_.write({"input", "points", "method", "threads", "stage", "runs", "cpu_seconds",
                "wall_seconds", "peak_rss_mib", "rss_beyond_input_mib", "status"});
  }

  void run(const std::string& input, std::size_t points,
           const std::vector<Contestant>& contestants)
  {
    std::vector<Work> works;
    for(const Contestant& contestant : contestants)
      works.push_back({contestant.run, contestant.threads});
    const auto measured = measure_runs(works, options_.runs, options_.time_limit);
    for(std::size_t c = 0; c < contestants.size(); ++c) {
      rows_.push_back(
        {input, points, contestants[c].method, contestants[c].threads, measured[c]});
      write(rows_.back());
    }
  }

  const std::vector<Performance_row>& rows() const { return rows_; }

private:
  /// A line per stage; memory is known of all of them together only.
  void write(const Performance_row& row)
  {
    const Measured_runs& m = row.measured;
    std::vector<Stage_seconds> stages = m.stages;
    if(stages.empty())
      stages.push_back({"total", not_measured, not_measured});
    for(const Stage_seconds& stage : stages) {
      const bool all = stage.name == "total";
      csv_.write({row.input, std::to_string(row.points), row.method, std::to_string(row.threads),
                  stage.name, std::to_string(m.runs), fixed(stage.cpu, 4), fixed(stage.wall, 4),
                  fixed(all ? m.peak_memory : not_measured, 1),
                  fixed(all ? m.extra_memory : not_measured, 1), m.status});
    }
  }

  Options options_;
  Csv csv_;
  std::vector<Performance_row> rows_;
};

/// Those that work on the points, which they refer to: this package with one and two threads, and
/// rivals.
std::vector<Contestant> on_points(const std::vector<Point>& points)
{
  std::vector<Contestant> result;
  for(const std::size_t threads : {1u, 2u})
    result.push_back({method_names::ours, threads, [&points, threads](Stopwatch& stopwatch) {
                        skeletonize_points(points, threads, stopwatch);
                      }});
  result.push_back(
    {method_names::wlop, 1, [&](Stopwatch& stopwatch) { wlop(points, stopwatch); }});
  result.push_back({method_names::neighbors, 1,
                    [&](Stopwatch& stopwatch) { neighbor_queries(points, stopwatch); }});
  return result;
}

void run_model(Contest& contest, const std::string& file, std::size_t size)
{
  const Model model = read_model(file, size, 0);
  std::vector<Contestant> contestants = on_points(model.points);
  contestants.push_back({method_names::flow, 1, [&](Stopwatch& stopwatch) {
                           flow_mesh(model.components, stopwatch);
                         }});
  contestants.push_back({method_names::wrap_and_flow, 1, [&](Stopwatch& stopwatch) {
                           wrap_and_flow(model.points, stopwatch);
                         }});
  contest.run(model.name, model.points.size(), contestants);
}

std::vector<Point> sampled(const std::string& file, std::size_t size)
{
  std::vector<Point> points = sample_surface(read_points_and_faces<Point>(file), size, 0);
  if(points.empty())
    throw std::runtime_error("cannot sample '" + file + "': it has no faces");
  return points;
}

/// A binary .ply file of sampled points that is there as long as this object.
class Sampled_file
{
public:
  /// Written by another process, so that this one does not become large.
  Sampled_file(const std::string& file, std::size_t size)
      : name_((std::filesystem::temp_directory_path() /
               ("performance_" + std::to_string(getpid()) + ".ply"))
                  .string())
  {
    const Forked writer = run_forked([&] { return write(file, size); },
                                     std::numeric_limits<double>::infinity());
    const std::string error(writer.answer.begin(), writer.answer.end());
    if(!writer.death.empty() || !error.empty())
      throw std::runtime_error(error.empty() ? writer.death : error);
  }
  Sampled_file(const Sampled_file&) = delete;
  Sampled_file& operator=(const Sampled_file&) = delete;
  ~Sampled_file()
  {
    std::error_code ignored;
    std::filesystem::remove(name_, ignored);
  }

  const std::string& name() const { return name_; }

private:
  /// \return what went wrong; nothing if it went well
  std::vector<std::uint8_t> write(const std::string& file, std::size_t size) const
  {
    std::string error;
    try {
      std::ofstream out(name_, std::ios::binary);
      CGAL::IO::set_binary_mode(out);
      CGAL::IO::write_PLY(out, sampled(file, size));
      if(!out.flush())
        error = "cannot write '" + name_ + "'";
    } catch(const std::exception& exception) {
      error = exception.what();
    }
    return {error.begin(), error.end()};
  }

  std::string name_;
};

/// The stream first: the process must not hold the points then.
void run_large(Contest& contest, const std::string& file, std::size_t size)
{
  {
    const Sampled_file stream(file, size);
    contest.run(name_of(file), size,
                {{method_names::streamed, 1, [&](Stopwatch& stopwatch) {
                    skeletonize_stream(stream.name(), stopwatch);
                  }}});
  }
  const std::vector<Point> points = sampled(file, size);
  std::vector<Contestant> contestants = on_points(points);
  contestants.push_back({method_names::bare, 1, [&](Stopwatch& stopwatch) {
                           skeletonize_bare(points, stopwatch);
                         }});
  contest.run(name_of(file), size, contestants);
}

void run(const Options& options)
{
  const std::vector<std::string> files = chosen_files(options.files);
  Contest contest(options);
  if(options.points > 0)
    for(const std::string& file : files)
      run_model(contest, file, options.points);
  for(const std::size_t size : options.large)
    if(size > 0)
      run_large(contest, files.front(), size);
  std::cout << '\n';
  print_ratios(std::cout, contest.rows());
  std::cout << '\n';
  print_shares(std::cout, contest.rows());
  std::cout << '\n';
  print_quietness(std::cout, contest.rows());
}

/// \return whether to go on \throw std::runtime_error with a message of one line
bool parse(int argc, char** argv, Options& options)
{
  CLI::App app("How fast skeletons are, and in how much memory.", "performance");
  app.add_option("FILES", options.files, "meshes; of a folder, six of CGAL's sample models")
      ->required();
  app.add_option("--points", options.points, "points drawn from every mesh [20000]; 0: none")
      ->type_name("N");
  app.add_option("--large", options.large,
                 "points drawn from the first mesh [1000000,10000000]; 0: none")
      ->type_name("N")
      ->delimiter(',');
  app.add_option("--runs", options.runs, "the medians of so many are taken, every method in turn [3]")
      ->type_name("N")
      ->check(CLI::Range(1, 1000));
  app.add_option("--time-limit", options.time_limit, "seconds that a run may take [600]")
      ->type_name("SECONDS")
      ->check(CLI::PositiveNumber);
  app.add_option("--csv", options.csv, "where to write the table [standard output]")
      ->type_name("FILE");
  try {
    app.parse(argc, argv);
  } catch(const CLI::CallForHelp&) {
    std::cout << app.help();
    return false;
  } catch(const CLI::ParseError& error) {
    throw std::runtime_error(std::string(error.what()) + " (try --help)");
  }
  return true;
}

} // namespace

int main(int argc, char** argv)
{
  try {
    Options options;
    if(parse(argc, argv, options))
      run(options);
    return EXIT_SUCCESS;
  } catch(const std::exception& error) {
    std::cerr << "performance: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }
}
