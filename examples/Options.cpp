// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Options.h"

#include "Format.h"
#include "outputs.h"

#include <CGAL/Point_set_skeletonization_3/internal/io/Output_file.h>

#include <CLI/CLI.hpp>

#include <cmath>
#include <filesystem>
#include <iostream>
#include <limits>
#include <set>
#include <stdexcept>
#include <system_error>

namespace {

/// Finds out before the work, not after it, that a file cannot be written where it is wanted.
/// \throw std::runtime_error
void check_output(const std::string& filename, const std::string& input)
{
  using CGAL::Point_set_skeletonization_3::internal::target_of_output;
  const auto fail = [&filename](const std::string& why) {
    throw std::runtime_error("cannot write '" + filename + "': " + why);
  };
  const std::filesystem::path path = target_of_output(filename);
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  std::error_code ignored;
  if(!std::filesystem::is_directory(folder, ignored))
    fail("there is no folder '" + folder.string() + "'");
  if(std::filesystem::is_directory(path, ignored))
    fail("it is a folder");
  if(std::filesystem::exists(path, ignored) && !std::filesystem::is_regular_file(path, ignored))
    fail("it is no ordinary file");
  if(std::filesystem::equivalent(path, input, ignored))
    fail("it is the input");
}

/// The number of letters of the ending of a name, with its dots.
std::size_t size_of_ending(const std::string& filename)
{
  for(const std::string two_dots : {".polylines.txt", ".tubes.ply"})
    if(CGAL::Point_set_skeletonization_3::internal::ends_with(filename, two_dots))
      return two_dots.size();
  return std::filesystem::path(filename).extension().string().size();
}

/// The name of an output with the number of a part, padded with zeros: `plot.ply`, `plot_007.ply`.
std::string name_of_part(const std::string& filename, std::size_t part, std::size_t parts)
{
  if(filename.empty())
    return filename;
  const std::size_t ending = filename.size() - size_of_ending(filename);
  const std::string number = std::to_string(part), last = std::to_string(parts);
  return filename.substr(0, ending) + '_' + std::string(last.size() - number.size(), '0') + number +
         filename.substr(ending);
}

void check_outputs(const Options& options)
{
  using CGAL::Point_set_skeletonization_3::internal::target_of_output;
  const auto canonical = [](const std::string& filename) {
    return std::filesystem::weakly_canonical(std::filesystem::absolute(target_of_output(filename)));
  };
  std::set<std::filesystem::path> files;
  const auto check = [&](const std::string& filename) {
    check_output(filename, options.input);
    if(!files.insert(canonical(filename)).second)
      throw std::runtime_error("cannot write '" + filename + "': this output is given twice");
  };
  for(const std::string& output : options.outputs) {
    check_output_format(output);
    check(output);
  }
  const auto check_other = [&](const std::string& filename, const std::string& ending) {
    if(filename.empty())
      return;
    if(point_files::extension_of(filename) != ending)
      throw std::runtime_error("cannot write '" + filename + "': name it ." + ending);
    check(filename);
  };
  check_other(options.points, "xyz");
  check_other(options.branches, "csv");
  check_other(options.segment, "ply");
}

/// \throw std::runtime_error
void check_box(const std::string& option, const std::vector<double>& box)
{
  for(std::size_t k = 0; k < box.size() / 2; ++k)
    if(!std::isfinite(box[k]) || !std::isfinite(box[k + 3]) || box[k] > box[k + 3])
      throw std::runtime_error(option + ": give the smallest x, y and z, then the largest");
}

/// \throw std::runtime_error
void check_moments_output(const std::string& filename,
                                 const std::vector<std::string>& inputs)
{
  if(!is_moments_file(filename))
    throw std::runtime_error("cannot write '" + filename + "': name it .moments");
  for(const std::string& input : inputs)
    check_output(filename, input);
}

/// Of a cloud of which only moments are known.
/// \throw std::runtime_error
void check_moments_input(const Options& options)
{
  const auto refuse = [&options](bool is_given, const std::string& option) {
    if(is_given)
      throw std::runtime_error("'" + options.input + "' has moments, no points: do without " +
                               option);
  };
  refuse(options.as_published, "--as-published");
  refuse(options.sample != 0, "--sample");
  refuse(!options.points.empty(), "--points");
  refuse(!options.segment.empty(), "--segment");
  refuse(!options.box.empty(), "--box");
  refuse(options.cells != Builder::default_maximum_cells, "--cells"); // which `accumulate` takes
}

/// All parameters of the published method. The ranges are those of the named parameters.
void add_published_options(CLI::App& app, Published_symbols& symbols)
{
  CLI::Option* published = app.get_option("--as-published");
  const auto add_flag = [&](const std::string& name, bool& value, const std::string& text) {
    app.add_flag(name, value, text)->needs(published)->group("With --as-published");
  };
  const auto add = [&](const std::string& name, auto& value, auto least, auto greatest,
                       const std::string& text) {
    app.add_option(name, value, text)
        ->type_name("X")
        ->check(CLI::Range(least, greatest))
        ->needs(published)
        ->group("With --as-published");
  };
  constexpr double any = 1e6, tiny = 1e-6;
  constexpr std::size_t many = 1000000;
  const auto none = std::size_t(0), one = std::size_t(1);
  add_flag("--tuned", symbols.tuned, "other defaults than the paper's, given second here");
  add("--h0", symbols.h_0, 1e-4, 1e4, "first kernel radius, in diagonals [2 / cbrt(points)]");
  add("--delta-h", symbols.delta_h, 0.0, any, "growth per iteration, in h0 [1/2, 1/3]");
  add("--iterations", symbols.iterations, none, many, "of the projection [30, 60]");
  add_flag("--halt", symbols.halt, "halt when most samples lie on curves; iterations are a bound [60, 120]");
  add("--mu", symbols.mu, 0.0, 0.4999, "weight of the repulsion [0.2]");
  add("--samples", symbols.samples, one, many * 1000, "samples to project [points / 20, >= 500]");
  add("--alpha", symbols.alpha, tiny, any, "reach of a parent of the EM, in deviations [2.2]");
  add("--levels", symbols.levels, none, std::size_t(100), "levels of the EM [3]");
  add("--flatness", symbols.flatness, tiny, any, "regularisation of points' Gaussians [0.3]");
  add("--sample-flatness", symbols.sample_flatness, tiny, any, "of samples' [0.3, 0.05]");
  add("--alpha-min", symbols.alpha_min, 0.0, 179.99, "least angle of a branch, degrees [90, 120]");
  add("--b-min", symbols.b_min, std::size_t(2), many, "least components of a branch [5]");
  add("--d-max", symbols.d_max, tiny, any, "longest edge of a branch, in diagonals [0.15]");
}

void add_output_option(CLI::App& app, Options& options)
{
  app.add_option("-o,--output", options.outputs,
                 "page, picture or skeleton to write, may be repeated: " + output_endings())
      ->type_name("FILE")
      ->allow_extra_args(false);
}

/// What is known of the shape.
void add_topology_options(CLI::App& app, Options& options)
{
  app.add_flag("--single-component", options.single_component,
               "join all parts, for a shape known to be in one piece");
  app.add_flag("--tree", options.is_tree, "open every cycle, for a shape known to have none");
  app.add_flag("--split", options.split,
               "a skeleton for each part that touches no other, as trees: FILE_1, FILE_2, ...");
}

/// How the program runs and what it reports.
void add_running_options(CLI::App& app, Options& options)
{
  app.add_option("--threads", options.threads, "number of threads [all cores]")
      ->type_name("N")
      ->check(CLI::Range(1, 1024));
  app.add_flag("--stats", options.stats, "print one line of JSON on standard output");
  app.add_flag("--quiet", options.quiet, "no progress bar and no summary");
}

/// What is made from branches, and where they start.
void add_branch_options(CLI::App& app, Options& options)
{
  app.add_option("--branches", options.branches,
                 "write a table of the branches, .csv: parent, order, length, radius, volume, angle")
      ->type_name("FILE");
  app.add_option("--root", options.root, "orders count from here: lowest or thickest end [lowest]")
      ->type_name("END")
      ->check(CLI::IsMember({"lowest", "thickest"}));
  app.add_option("--up", options.up, "the vertical axis [z]")
      ->type_name("AXIS")
      ->check(CLI::IsMember({"x", "y", "z"}));
}

/// For clouds larger than memory: what needs all points at a time is out of question.
void add_stream_options(CLI::App& app, Options& options)
{
  CLI::Option* stream =
      app.add_flag("--stream", options.stream,
                   "read point after point, in little memory for a file of any size");
  for(const char* other : {"--as-published", "--sample", "--points", "--segment"}) {
    stream->excludes(app.get_option(other));
    app.get_option("--split")->excludes(app.get_option(other));
  }
  app.add_option("--box", options.box,
                 "XMIN YMIN ZMIN XMAX YMAX ZMAX that contain all points; else read twice")
      ->type_name("X")
      ->expected(6)
      ->needs(stream);
}

/// What bounds the resolution.
void add_cells_option(CLI::App& app, std::size_t& cells)
{
  app.add_option("--cells", cells,
                 "resolution: at most so many cells, of about 1 kB of memory each [131072]")
      ->type_name("N")
      ->check(CLI::Range(std::size_t(1000), std::size_t(1) << 26));
}

/// What saves time where there are more points than the shape takes.
void add_feature_option(CLI::App& app, std::optional<double>& smallest_feature)
{
  app.add_option("--smallest-feature", smallest_feature,
                 "thickness of the thinnest limb that must be found, in the unit of the points: "
                 "saves time if there are many [as thin as the points allow]")
      ->type_name("LENGTH");
}

/// \throw std::runtime_error
void check_feature(const Options& options)
{
  const double thickness = options.smallest_feature.value_or(1);
  if(!(thickness > 0) || !std::isfinite(thickness))
    throw std::runtime_error("--smallest-feature: give a length that is more than 0, and finite");
}

/// How files are read.
void add_reading_options(CLI::App& app, std::string& format, bool& skip_invalid)
{
  app.add_option("--format", format, "of the input, by its extension [as it is called]")
      ->type_name("EXTENSION");
  app.add_flag("--skip-invalid", skip_invalid,
               "leave out and count rows of the input that are no finite point");
}

void add_tile_list_option(CLI::App& app, std::string& list)
{
  app.add_option("--tiles", list, "a list of more tiles: a line for each, FILE [TILE_BOX]")
      ->type_name("FILE");
}

/// Of a cloud in tiles.
void add_box_option(CLI::App& app, std::vector<double>& box)
{
  app.add_option("--box", box,
                 "XMIN YMIN ZMIN XMAX YMAX ZMAX that contain all points of all tiles, the same for "
                 "files to be merged; else the tiles are read twice")
      ->type_name("X")
      ->expected(6);
}

CLI::App& add_accumulate_command(CLI::App& app, Accumulation& job)
{
  CLI::App& command = *app.add_subcommand(
      "accumulate", "reads the tiles of a large cloud into a file of moments, a kind of INPUT");
  CLI::Option* files = command.add_option("TILE", job.files, "a file with a part of the cloud");
  add_tile_list_option(command, job.list);
  command.add_option("-o,--output", job.output, "file to write, .moments")
      ->type_name("FILE")
      ->required();
  add_box_option(command, job.box);
  command
      .add_option("--tile-box", job.tile_box,
                  "what counts of a TILE, if tiles overlap; points on its upper sides do not")
      ->type_name("X")
      ->expected(6)
      ->needs(files);
  command.add_flag("--append", job.append,
                   "go on with the file if it is there, and save it after each tile");
  add_cells_option(command, job.cells);
  add_reading_options(command, job.format, job.skip_invalid);
  command.add_flag("--quiet", job.quiet, "no progress bar and no summary");
  return command;
}

CLI::App& add_merge_command(CLI::App& app, Merging& job)
{
  CLI::App& command = *app.add_subcommand("merge", "adds up files of moments with the same box");
  command.add_option("FILE", job.files, "files of moments")->required();
  command.add_option("-o,--output", job.output, "file to write, .moments")
      ->type_name("FILE")
      ->required();
  command.add_flag("--quiet", job.quiet, "no summary");
  return command;
}

/// What is to be done with several inputs.
struct Batch
{
  std::vector<std::string> inputs;
  std::string directory;
  std::vector<std::string> formats; ///< endings without their dot
};

void add_batch_options(CLI::App& app, Batch& batch)
{
  CLI::Option* directory =
      app.add_option("--output-directory", batch.directory,
                     "folder for the outputs of any number of INPUTs, called as they are; see -f")
          ->type_name("DIR");
  CLI::Option* format =
      app.add_option("-f,--output-format", batch.formats,
                     "ending of what to write into --output-directory; may be repeated")
          ->type_name("ENDING")
          ->allow_extra_args(false);
  format->needs(directory);
  directory->needs(format);
  for(const char* other : {"--output", "--points", "--branches", "--segment"})
    directory->excludes(app.get_option(other));
}

/// \throw std::runtime_error
void create_folder(const std::string& name)
{
  std::error_code error;
  if(!name.empty())
    std::filesystem::create_directories(name, error);
  if(error)
    throw std::runtime_error("cannot create the folder '" + name + "': " + error.message());
}

/// Returns the options for each input. \throw std::runtime_error
std::vector<Options> jobs_of(const Batch& batch, Options options)
{
  if(batch.directory.empty() && batch.inputs.size() > 1)
    throw std::runtime_error("cannot take '" + batch.inputs[1] + "' as a second input: give " +
                             "--output-directory and -f, or -o before each output");
  std::vector<Options> jobs;
  std::set<std::string> names;
  for(const std::string& input : batch.inputs) {
    options.input = input;
    options.outputs = batch.directory.empty() ? options.outputs : std::vector<std::string>();
    options.is_one_of_many = !batch.directory.empty();
    const std::string name = std::filesystem::path(input).stem().string();
    if(!names.insert(name).second)
      throw std::runtime_error("cannot write the outputs of '" + input +
                               "': another input has the same name");
    for(const std::string& format : batch.formats) {
      options.outputs.push_back(
          (std::filesystem::path(batch.directory) / (name + '.' + format)).string());
      check_output_format(options.outputs.back());
    }
    jobs.push_back(options);
  }
  create_folder(batch.directory);
  for(const Options& job : jobs) {
    check_outputs(job);
    if(is_moments_file(job.input))
      check_moments_input(job);
  }
  return jobs;
}

/// Parses the command line; returns false if it was only to show help or the version.
/// \throw std::runtime_error with a message of one line
bool is_parsed(CLI::App& app, int argc, char** argv)
{
  try {
    app.parse(argc, argv);
  } catch(const CLI::CallForHelp&) {
    std::cout << app.help();
    return false;
  } catch(const CLI::CallForVersion&) {
    std::cout << app.version() << '\n';
    return false;
  } catch(const CLI::ParseError& error) {
    throw std::runtime_error(std::string(error.what()) + " (try --help)");
  }
  return true;
}

} // namespace

bool is_moments_file(const std::string& filename)
{
  return point_files::extension_of(filename) == "moments";
}

Options options_of_part(Options options, std::size_t part, std::size_t parts)
{
  for(std::string& output : options.outputs)
    output = name_of_part(output, part, parts);
  options.branches = name_of_part(options.branches, part, parts);
  return options;
}

Command_line parse_options(int argc, char** argv)
{
  Options options;
  Batch batch;
  Accumulation accumulation;
  Merging merging;
  CLI::App app("Curve skeleton of a raw point cloud: no normals, no mesh needed.",
               "skeletonize_point_set");
  app.footer("Examples:\n"
             "  skeletonize_point_set scan.ply -o skeleton.html -o skeleton.vtp\n"
             "  skeletonize_point_set tree.las -o cylinders.csv --branches branches.csv\n"
             "  skeletonize_point_set *.ply --output-directory skeletons -f swc -f png\n"
             "  skeletonize_point_set accumulate plot/*.las -o plot.moments\n"
             "An output is complete or not there. The exit code is 0, or 1 if anything failed.");
  app.set_version_flag("--version", std::string("skeletonize_point_set ") + VERSION);
  const CLI::App& accumulate = add_accumulate_command(app, accumulation);
  const CLI::App& merge = add_merge_command(app, merging);
  app.add_option("INPUT", batch.inputs,
                 point_files::names_of_formats() +
                     " or - for standard input; of a mesh, its vertices; or .moments");
  add_reading_options(app, options.format, options.skip_invalid);
  add_output_option(app, options);
  add_branch_options(app, options);
  app.add_option("--segment", options.segment,
                 "write the cloud, .ply: branch, order and distance to the skeleton of each point")
      ->type_name("FILE");
  app.add_option("--points", options.points,
                 "also write the points it was computed from, .xyz; for --sample")
      ->type_name("FILE");
  add_topology_options(app, options);
  app.add_flag("--as-published", options.as_published, "the published method, for comparison");
  add_published_options(app, options.published);
  app.add_option("--sample", options.sample, "draw N points from the surface of a mesh instead")
      ->type_name("N")
      ->check(CLI::Range(1, std::numeric_limits<int>::max()));
  add_cells_option(app, options.cells);
  add_feature_option(app, options.smallest_feature);
  for(const char* other : {"--cells", "--smallest-feature"})
    app.get_option("--as-published")->excludes(app.get_option(other));
  add_stream_options(app, options);
  add_batch_options(app, batch);
  app.add_option("--seed", options.seed, "seed of everything random [0]")->type_name("N");
  add_running_options(app, options);
  if(!is_parsed(app, argc, argv))
    return {};
  for(const auto* box : {&options.box, &accumulation.box})
    check_box("--box", *box);
  check_box("--tile-box", accumulation.tile_box);
  check_feature(options);
  if(accumulate) {
    if(accumulation.files.empty() && accumulation.list.empty())
      throw std::runtime_error("accumulate: give a TILE or a list of --tiles (try --help)");
    check_moments_output(accumulation.output, accumulation.files);
    return {{}, accumulation, {}};
  }
  if(merge) {
    check_moments_output(merging.output, merging.files);
    return {{}, {}, merging};
  }
  if(batch.inputs.empty())
    throw std::runtime_error("INPUT is required (try --help)");
  return {jobs_of(batch, options), {}, {}};
}

std::optional<Mpi_options> parse_mpi_options(int argc, char** argv)
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
  if(!is_parsed(app, argc, argv))
    return {};
  if(options.tiles.empty() && options.list.empty())
    throw std::runtime_error("give a TILE or a list of --tiles (try --help)");
  check_box("--box", options.box);
  check_feature(options);
  options.input = options.tiles.empty() ? options.list : options.tiles.front(); // names the pages
  check_outputs(options);
  create_folder(options.segment_directory);
  return options;
}
