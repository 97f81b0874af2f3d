// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "skeletonize_cloud.h"

#include "outputs.h"
#include "write_segmented_cloud.h"

#include <CGAL/L1_medial_skeletonization_3.h>
#include <CGAL/Point_set_skeletonization_3/internal/io/write_branches.h>
#include <CGAL/Point_set_skeletonization_3/parameters.h>
#include <CGAL/Point_set_skeletonization_3/published_parameters.h>
#include <CGAL/Published_l1_medial_skeletonization_3.h>
#include <CGAL/Real_timer.h>
#include <CGAL/skeleton_branches.h>

#include <nlohmann/json.hpp>
#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#endif

#include <atomic>
#include <filesystem>
#include <iostream>
#include <mutex>
#include <ostream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

namespace {

/// Runs one stage and returns its seconds.
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

template <typename ConcurrencyTag>
CGAL::Point_assignment_3<Kernel>
assignment_of(const CGAL::L1_medial_skeletonization_3<Kernel, ConcurrencyTag>& steps)
{
  return steps.point_assignment();
}

/// It has no streamed points.
template <typename ConcurrencyTag>
CGAL::Point_assignment_3<Kernel>
assignment_of(const CGAL::Published_l1_medial_skeletonization_3<Kernel, ConcurrencyTag>&)
{
  return {};
}

/// Points stay; what was streamed is of no use after the first step, and takes as much memory as
/// the others.
void forget(const std::vector<Point>&) {}
void forget(Builder& builder) { builder = Builder(); }

/// Runs the steps of either method on its points.
template <typename Skeletonization, typename Points>
Result run_steps(Skeletonization& steps, Points& points)
{
  Result result;
  result.mixture_seconds = seconds_of([&] { return steps.fit_mixture(); });
  forget(points);
  result.projection_seconds = seconds_of([&] { return steps.project(); });
  result.linking_seconds = seconds_of([&] { return steps.link(); });
  result.mixture = steps.number_of_components();
  result.samples = steps.number_of_samples();
  result.outliers = steps.number_of_outliers();
  result.assignment = assignment_of(steps);
  std::move(steps).extract_skeleton(result.skeleton);
  return result;
}

/// The named parameters of the published method.
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
  Result result = run_steps(steps, points);
  result.iterations = steps.number_of_iterations();
  return result;
}

/// Of points, or of what was streamed, which is empty afterwards.
template <typename ConcurrencyTag, typename Points>
Result skeletonize(Points& points, const Options& options, Progress_bar& bar)
{
  if constexpr(!std::is_same<Points, Builder>::value)
    if(options.as_published)
      return skeletonize_as_published<ConcurrencyTag>(points, options, bar);
  using namespace CGAL::parameters;
  const auto topology =
      single_component(options.single_component, is_tree(options.is_tree, callback_of(bar)));
  CGAL::L1_medial_skeletonization_3<Kernel, ConcurrencyTag> steps(
      points,
      maximum_cells(options.cells, smallest_feature(options.smallest_feature, topology)));
  return run_steps(steps, points);
}

#ifdef CGAL_LINKED_WITH_TBB
int number_of_threads(const Options& options)
{
  return options.threads > 0 ? options.threads : tbb::info::default_concurrency();
}

template <typename Points>
Result skeletonize_with_threads(Points& points, const Options& options, Progress_bar& bar)
{
  const int threads = number_of_threads(options);
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(threads));
  return threads == 1 ? skeletonize<CGAL::Sequential_tag>(points, options, bar)
                      : skeletonize<CGAL::Parallel_tag>(points, options, bar);
}
#else
template <typename Points>
Result skeletonize_with_threads(Points& points, const Options& options, Progress_bar& bar)
{
  return skeletonize<CGAL::Sequential_tag>(points, options, bar);
}
#endif

void print_stats(const Reading& reading, const Result& result, const Graph_counts& counts,
                        const Options& options, const std::vector<double>& memory = {})
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
  if(reading.part)
    stats["part"] = *reading.part;
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
  if(!memory.empty())
    stats["megabytes"] = memory; // of each process
  const bool ascii = true; // a file's name may be in any encoding
  std::cout << stats.dump(-1, ' ', ascii, nlohmann::json::error_handler_t::replace) << std::endl;
}

void print_summary(const Reading& reading, const Result& result, const Graph_counts& counts,
                   const Options& options)
{
  if(options.is_one_of_many)
    std::cout << options.input << ": ";
  if(reading.part)
    std::cout << "part " << *reading.part << ": ";
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
Result run(Points& points, const Options& options)
{
  Progress_bar bar(!options.quiet);
  return skeletonize_with_threads(points, options, bar);
}

/// Computes the skeleton of each part, the largest first, each on one thread. The parts are empty
/// afterwards.
std::vector<Result> run_parts(std::vector<Builder>& parts, const Options& options)
{
  std::vector<Result> results(parts.size());
  Progress_bar bar(!options.quiet), none(false);
  std::mutex mutex;
  std::atomic<std::size_t> next(0);
  std::size_t done = 0;
  const auto run_some = [&](int) {
    for(std::size_t i = next++; i < parts.size(); i = next++) {
      results[i] = skeletonize<CGAL::Sequential_tag>(parts[i], options, none);
      const std::lock_guard<std::mutex> lock(mutex);
      bar.show(static_cast<double>(++done) / static_cast<double>(parts.size()));
    }
  };
#ifdef CGAL_LINKED_WITH_TBB
  const int threads = number_of_threads(options);
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(threads));
  tbb::parallel_for(0, threads, run_some);
#else
  run_some(0);
#endif
  return results;
}

} // namespace

point_files::Reading_options reading_options(const Options& options, Progress_bar& bar)
{
  point_files::Reading_options reading;
  reading.format = options.format;
  reading.skip_invalid = options.skip_invalid;
  reading.progress = [&bar](double fraction) { bar.show(fraction); };
  return reading;
}


Result skeletonize(const std::vector<Point>& points, const Options& options)
{
  return run(points, options);
}

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

std::vector<Reported> skeletonize_streamed(Builder builder, const Reading& reading,
                                                  const Options& options)
{
  CGAL::Point_set_skeletonization_3::internal::Output_transaction outputs;
  const std::vector<Point> none; // is kept
  std::vector<Reported> reported;
  const auto write = [&](const Reading& of_skeleton, Result result, const Options& names) {
    write_outputs(with_branches(result.skeleton, none, of_skeleton.points, names), names);
    reported.push_back({of_skeleton, std::move(result), {}});
    reported.back().counts = count_graph(reported.back().result.skeleton);
  };
  if(!options.split)
    write(reading, run(builder, options), options);
  else {
    std::vector<Builder> parts = builder.split();
    forget(builder);
    std::vector<std::size_t> sizes;
    for(const Builder& part : parts)
      sizes.push_back(part.number_of_points());
    std::vector<Result> results = run_parts(parts, options);
    for(std::size_t i = 0; i < parts.size(); ++i) {
      Reading of_part = reading;
      of_part.points = sizes[i];
      of_part.part = i + 1;
      write(of_part, std::move(results[i]), options_of_part(options, i + 1, parts.size()));
    }
  }
  outputs.commit();
  return reported;
}

void report(const Reported& r, const Options& options, const std::vector<double>& memory)
{
  if(options.stats)
    print_stats(r.reading, r.result, r.counts, options, memory);
  else if(!options.quiet)
    print_summary(r.reading, r.result, r.counts, options);
  if(!std::cout)
    throw std::runtime_error("cannot write to standard output");
}
