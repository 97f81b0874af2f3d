// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Reads a point cloud, writes its curve skeleton. `skeletonize_point_set --help` tells the options.

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

#include <csignal>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
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

// What --stats prints, and the skeleton.
struct Result
{
  Skeleton skeleton;
  std::size_t mixture = 0;
  std::size_t samples = 0;
  std::optional<std::size_t> iterations; // of the published method
  std::optional<double> reading_seconds; // of a stream: with the moments, which are not kept apart
  double mixture_seconds = 0;
  double projection_seconds = 0;
  double linking_seconds = 0;
};

// Set by Ctrl-C, which cancels at the next report of progress.
volatile std::sig_atomic_t interrupted = 0;

extern "C" void on_interrupt(int)
{
  interrupted = 1;
}

// Runs one stage and returns its seconds.
template <typename Stage>
double seconds_of(const Stage& stage)
{
  CGAL::Real_timer timer;
  timer.start();
  if(!stage())
    throw std::runtime_error("interrupted");
  return timer.time();
}

// The progress bar as a callback, which Ctrl-C makes cancel.
auto callback_of(Progress_bar& bar)
{
  return CGAL::parameters::callback([&bar](double fraction) {
    bar.show(fraction);
    return interrupted == 0;
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
      CGAL::parameters::single_component(options.single_component, callback_of(bar)));
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

std::vector<Point> load(const Options& options)
{
  Points_and_faces<Point> input = read_points_and_faces<Point>(options.input);
  if(options.sample == 0)
    return std::move(input.points);
  std::vector<Point> points = sample_surface(input, options.sample, options.seed);
  if(points.empty())
    throw std::runtime_error("cannot sample '" + options.input + "': it has no faces");
  return points;
}

Builder stream(const Options& options)
{
  const std::vector<double>& b = options.box;
  Builder builder(b.empty() ? box_of_file<Point>(options.input)
                            : CGAL::Bbox_3(b[0], b[1], b[2], b[3], b[4], b[5]));
  for_each_point<Point>(options.input, [&builder](const Point& p) { builder.insert(p); });
  return builder;
}

// The skeleton with all that pages, pictures and tables show of it.
Skeletonized_cloud with_branches(const Skeleton& skeleton, const std::vector<Point>& points,
                                 std::size_t size, const Options& options)
{
  const std::size_t up = std::string("xyz").find(options.up);
  Skeletonized_cloud cloud{std::filesystem::path(options.input).filename().string(), points, size,
                           up, {}, {}, {}, {}, {}};
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

void print_stats(std::size_t points, const Result& result, const Graph_counts& counts)
{
  nlohmann::ordered_json seconds;
  if(result.reading_seconds)
    seconds["reading"] = *result.reading_seconds;
  seconds["mixture"] = result.mixture_seconds;
  seconds["projection"] = result.projection_seconds;
  seconds["linking"] = result.linking_seconds;
  seconds["total"] = result.reading_seconds.value_or(0) + result.mixture_seconds +
                     result.projection_seconds + result.linking_seconds;
  nlohmann::ordered_json stats;
  stats["points"] = points;
  stats["mixture"] = result.mixture;
  stats["samples"] = result.samples;
  if(result.iterations)
    stats["iterations"] = *result.iterations;
  stats["components"] = counts.components;
  stats["cycles"] = counts.cycles;
  stats["ends"] = counts.ends;
  stats["junctions"] = counts.junctions;
  stats["length"] = counts.length;
  stats["seconds"] = seconds;
  std::cout << stats.dump() << std::endl;
}

void print_summary(std::size_t points, const Graph_counts& counts)
{
  std::cout << "points " << points << ", components " << counts.components << ", cycles "
            << counts.cycles << ", ends " << counts.ends << ", junctions " << counts.junctions
            << ", length " << counts.length << std::endl;
}

template <typename Points>
void run(const Points& points, std::size_t size, const Options& options,
         std::optional<double> reading_seconds = std::nullopt)
{
  std::signal(SIGINT, on_interrupt);
  Result result;
  {
    Progress_bar bar(!options.quiet);
    result = skeletonize_with_threads(points, options, bar);
  }
  result.reading_seconds = reading_seconds;
  static const std::vector<Point> streamed;
  if constexpr(std::is_same<Points, std::vector<Point>>::value)
    write_outputs(with_branches(result.skeleton, points, size, options), options);
  else
    write_outputs(with_branches(result.skeleton, streamed, size, options), options);
  const Graph_counts counts = count_graph(result.skeleton);
  if(options.stats)
    print_stats(size, result, counts);
  else if(!options.quiet)
    print_summary(size, counts);
}

void run(const Options& options)
{
  if(options.stream) {
    CGAL::Real_timer timer;
    timer.start();
    const Builder points = stream(options);
    run(points, points.number_of_points(), options, timer.time());
    return;
  }
  const std::vector<Point> points = load(options);
  run(points, points.size(), options);
}

int main(int argc, char** argv)
{
  try {
    const Parsed parsed = parse_options(argc, argv);
    if(parsed.run)
      run(parsed.options);
    return EXIT_SUCCESS;
  } catch(const std::exception& error) {
    std::cerr << "skeletonize_point_set: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }
}
