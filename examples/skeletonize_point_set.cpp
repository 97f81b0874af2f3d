// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Reads a point cloud, writes its curve skeleton. `skeletonize_point_set --help` tells the options.

#include "End_on_signals.h"
#include "Options.h"
#include "Progress_bar.h"
#include "for_each_point.h"
#include "graph_counts.h"
#include "read_points.h"
#include "outputs.h"
#include "sample_surface.h"
#include "write_segmented_cloud.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/Gaussian_mixture_builder_3.h>
#include <CGAL/L1_medial_skeletonization_3.h>
#include <CGAL/Point_set_skeletonization_3/internal/io/write_branches.h>
#include <CGAL/Point_set_skeletonization_3/parameters.h>
#include <CGAL/Point_set_skeletonization_3/published_parameters.h>
#include <CGAL/Published_l1_medial_skeletonization_3.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/skeleton_branches.h>

#include <nlohmann/json.hpp>
#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/info.h>
#endif

#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Builder = CGAL::Gaussian_mixture_builder_3<Kernel>;
using Skeleton = CGAL::Curve_skeleton_3<Kernel>;

// What was read.
struct Reading
{
  std::size_t points = 0;
  std::optional<std::size_t> skipped; // rows, if that was asked for
  std::optional<double> seconds;      // of a stream: with the moments, which are not kept apart
};

// What --stats prints, and the skeleton.
struct Result
{
  Skeleton skeleton;
  std::size_t mixture = 0;
  std::size_t samples = 0;
  std::optional<std::size_t> iterations; // of the published method
  std::size_t outliers = 0;              // points that are in no vertex
  double mixture_seconds = 0;
  double projection_seconds = 0;
  double linking_seconds = 0;
};

// Runs one stage and returns its seconds.
template <typename Stage>
double seconds_of(const Stage& stage)
{
  CGAL::Real_timer timer;
  timer.start();
  stage();
  return timer.time();
}

auto callback_of(Progress_bar& bar)
{
  return CGAL::parameters::callback([&bar](double fraction) {
    bar.show(fraction);
    return true;
  });
}

// Runs the steps of either method.
template <typename Skeletonization>
Result run_steps(Skeletonization& steps)
{
  Result result;
  result.mixture_seconds = seconds_of([&] { return steps.fit_mixture(); });
  result.projection_seconds = seconds_of([&] { return steps.project(); });
  result.linking_seconds = seconds_of([&] { return steps.link(); });
  result.mixture = steps.number_of_components();
  result.samples = steps.number_of_samples();
  result.outliers = steps.number_of_outliers();
  std::move(steps).extract_skeleton(result.skeleton);
  return result;
}

// The named parameters of the published method.
auto published_parameters(const Options& options, Progress_bar& bar)
{
  using namespace CGAL::parameters::published;
  const Published_symbols& s = options.published;
  const auto common =
      callback_of(bar).random_seed(options.seed).number_of_iterations(s.iterations);
  const auto mixtures =
      alpha(s.alpha, levels(s.levels, flatness(s.flatness, sample_flatness(s.sample_flatness,
                                                                           common))));
  const auto projection =
      h_0(s.h_0, delta_h(s.delta_h, mu(s.mu, halt(s.halt, samples(s.samples, mixtures)))));
  return tuned(s.tuned, alpha_min(s.alpha_min, b_min(s.b_min, d_max(s.d_max, projection))));
}

template <typename ConcurrencyTag>
Result skeletonize_as_published(const std::vector<Point>& points, const Options& options,
                                Progress_bar& bar)
{
  CGAL::Published_l1_medial_skeletonization_3<Kernel, ConcurrencyTag> steps(
      points, published_parameters(options, bar));
  Result result = run_steps(steps);
  result.iterations = steps.number_of_iterations();
  return result;
}

// Of points, or of what was streamed.
template <typename ConcurrencyTag, typename Points>
Result skeletonize(const Points& points, const Options& options, Progress_bar& bar)
{
  if constexpr(std::is_same<Points, std::vector<Point>>::value)
    if(options.as_published)
      return skeletonize_as_published<ConcurrencyTag>(points, options, bar);
  CGAL::L1_medial_skeletonization_3<Kernel, ConcurrencyTag> steps(
      points,
      CGAL::parameters::single_component(
          options.single_component, CGAL::parameters::is_tree(options.is_tree, callback_of(bar))));
  return run_steps(steps);
}

#ifdef CGAL_LINKED_WITH_TBB
template <typename Points>
Result skeletonize_with_threads(const Points& points, const Options& options, Progress_bar& bar)
{
  const int threads = options.threads > 0 ? options.threads : tbb::info::default_concurrency();
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(threads));
  return threads == 1 ? skeletonize<CGAL::Sequential_tag>(points, options, bar)
                      : skeletonize<CGAL::Parallel_tag>(points, options, bar);
}
#else
template <typename Points>
Result skeletonize_with_threads(const Points& points, const Options& options, Progress_bar& bar)
{
  return skeletonize<CGAL::Sequential_tag>(points, options, bar);
}
#endif

point_files::Reading_options reading_options(const Options& options, Progress_bar& bar)
{
  point_files::Reading_options reading;
  reading.format = options.format;
  reading.skip_invalid = options.skip_invalid;
  reading.progress = [&bar](double fraction) { bar.show(fraction); };
  return reading;
}

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
  if(options.box.empty() && !point_files::can_be_read_twice(options.input))
    throw std::runtime_error("'" + options.input +
                             "' cannot be read twice: give --box, or do without --stream");
  Progress_bar bar(!options.quiet);
  const point_files::Reading_options reading = reading_options(options, bar);
  const std::vector<double>& b = options.box;
  Builder builder = b.empty() ? Builder(bulk_of_files<Point>({options.input}, reading))
                              : Builder(CGAL::Bbox_3(b[0], b[1], b[2], b[3], b[4], b[5]));
  const std::size_t skipped = for_each_point<Point>(
      options.input, [&builder](const Point& p) { builder.insert(p); }, reading);
  return {std::move(builder), skipped};
}

// The skeleton with all that pages, pictures and tables show of it.
Skeletonized_cloud with_branches(const Skeleton& skeleton, const std::vector<Point>& points,
                                 std::size_t size, const Options& options)
{
  Skeletonized_cloud cloud(points);
  const std::size_t up = std::string("xyz").find(options.up);
  cloud.name = std::filesystem::path(options.input).filename().string();
  cloud.number_of_points = size;
  cloud.up = up;
  cloud.skeleton = CGAL::Point_set_skeletonization_3::internal::written_skeleton(
      skeleton, options.root == "lowest" ? CGAL::lowest_vertices(skeleton, up)
                                         : CGAL::thickest_vertices(skeleton));
  assign_branches(skeleton, cloud);
  return cloud;
}

void write_outputs(const Skeletonized_cloud& cloud, const Options& options)
{
  for(const std::string& output : options.outputs)
    write_output(output, cloud);
  if(!options.branches.empty())
    write_file(options.branches, [&cloud](std::ostream& os) {
      CGAL::Point_set_skeletonization_3::internal::write_branches(os, cloud.skeleton,
                                                                  cloud.points_of_branch);
    });
  if(!options.segment.empty())
    write_file(options.segment, [&cloud](std::ostream& os) { write_segmented_cloud(os, cloud); });
  if(!options.points.empty())
    write_file(options.points, [&cloud](std::ostream& os) {
      for(const Point& p : cloud.points)
        os << p << '\n';
    });
}

void print_stats(const Reading& reading, const Result& result, const Graph_counts& counts,
                 const Options& options)
{
  nlohmann::ordered_json seconds;
  if(reading.seconds)
    seconds["reading"] = *reading.seconds;
  seconds["mixture"] = result.mixture_seconds;
  seconds["projection"] = result.projection_seconds;
  seconds["linking"] = result.linking_seconds;
  seconds["total"] = reading.seconds.value_or(0) + result.mixture_seconds +
                     result.projection_seconds + result.linking_seconds;
  nlohmann::ordered_json stats;
  if(options.is_one_of_many)
    stats["input"] = options.input;
  stats["points"] = reading.points;
  if(reading.skipped)
    stats["skipped"] = *reading.skipped;
  stats["mixture"] = result.mixture;
  stats["samples"] = result.samples;
  if(result.iterations)
    stats["iterations"] = *result.iterations;
  stats["components"] = counts.components;
  stats["cycles"] = counts.cycles;
  stats["ends"] = counts.ends;
  stats["junctions"] = counts.junctions;
  stats["length"] = counts.length;
  stats["outliers"] = result.outliers;
  stats["seconds"] = seconds;
  const bool ascii = true; // a file's name may be in any encoding
  std::cout << stats.dump(-1, ' ', ascii, nlohmann::json::error_handler_t::replace) << std::endl;
}

void print_summary(const Reading& reading, const Result& result, const Graph_counts& counts,
                   const Options& options)
{
  if(options.is_one_of_many)
    std::cout << options.input << ": ";
  std::cout << "points " << reading.points;
  if(reading.skipped)
    std::cout << ", skipped " << *reading.skipped;
  if(result.outliers > 0)
    std::cout << ", outliers " << result.outliers;
  std::cout << ", components " << counts.components << ", cycles " << counts.cycles << ", ends "
            << counts.ends << ", junctions " << counts.junctions << ", length " << counts.length;
  if(options.outputs.empty() && options.branches.empty() && options.segment.empty())
    std::cout << " (no skeleton was written: -o FILE writes " << output_endings() << ')';
  std::cout << std::endl;
}

template <typename Points>
Result run(const Points& points, const Options& options)
{
  Progress_bar bar(!options.quiet);
  return skeletonize_with_threads(points, options, bar);
}

void run(const Options& options)
{
  CGAL::Point_set_skeletonization_3::internal::Output_transaction outputs;
  Reading reading;
  Result result;
  std::size_t skipped = 0;
  if(options.stream) {
    const std::vector<Point> streamed; // are not kept
    CGAL::Real_timer timer;
    timer.start();
    const auto [builder, rows] = stream(options);
    reading.seconds = timer.time();
    reading.points = builder.number_of_points();
    skipped = rows;
    result = run(builder, options);
    write_outputs(with_branches(result.skeleton, streamed, reading.points, options), options);
  } else {
    const Points_and_faces<Point> input = load(options);
    reading.points = input.points.size();
    skipped = input.number_of_skipped;
    result = run(input.points, options);
    write_outputs(with_branches(result.skeleton, input.points, reading.points, options), options);
  }
  outputs.commit();

  if(options.skip_invalid)
    reading.skipped = skipped;
  const Graph_counts counts = count_graph(result.skeleton);
  if(options.stats)
    print_stats(reading, result, counts, options);
  else if(!options.quiet)
    print_summary(reading, result, counts, options);
  if(!std::cout)
    throw std::runtime_error("cannot write to standard output");
}

// Returns whether it succeeded; otherwise one line on standard error says why.
template <typename Action>
bool succeeds(const Action& action, const std::string& of = "")
{
  const auto fail = [](const std::string& why) {
    std::cerr << "skeletonize_point_set: " << why << std::endl;
    return false;
  };
  try {
    action();
    return true;
  } catch(const std::bad_alloc&) {
    return fail("not enough memory" + of + "; try --stream");
  } catch(const std::exception& error) {
    return fail(error.what());
  }
}

int main(int argc, char** argv)
{
  end_on_signals(
      [] { CGAL::Point_set_skeletonization_3::internal::unfinished_files().abandon(); });
  std::vector<Options> jobs;
  bool success = succeeds([&] { jobs = parse_options(argc, argv); });
  for(const Options& options : jobs)
    success = succeeds([&] { run(options); }, " for '" + options.input + "'") && success;
  return success ? EXIT_SUCCESS : EXIT_FAILURE;
}
