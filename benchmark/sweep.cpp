// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sweep.h"

#include "graph_counts.h"
#include "jobs.h"
#include "methods/Method.h"

#include "generator/clouds.h"
#include "generator/families.h"

#include <CGAL/Point_set_skeletonization_3/internal/interface/Skeletonizer.h>
#include <CGAL/Point_set_skeletonization_3/internal/interface/public_data.h>
#include <CGAL/Point_set_skeletonization_3/internal/pipeline/Options.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace sweep {

namespace {

namespace internal = CGAL::Point_set_skeletonization_3::internal;

/// What a skeleton is compared by: components, cycles, ends.
using Counts = std::array<std::size_t, 3>;

struct Cloud
{
  std::vector<shapes::Vector> points;
  Counts truth;
};

std::vector<Cloud> clouds(const Quality_options& options)
{
  std::vector<Cloud> result;
  for(const std::string& family : shapes::family_names())
    for(unsigned int seed = options.first_seed; seed < options.first_seed + options.seeds; ++seed) {
      const shapes::Known_shape shape = shapes::known_shape(family, seed);
      for(const shapes::Variant variant : shapes::all_variants())
        result.push_back({shapes::sample(shape, variant, options.points, seed),
                          {shape.components, shape.cycles, shape.ends}});
    }
  return result;
}

Counts counts_of(const Cloud& cloud, const internal::Options& options)
{
  internal::Point_source source;
  source.size = cloud.points.size();
  source.read = [&](std::size_t b, double* xyz) {
    const std::size_t first = b * internal::Point_source::block_size;
    for(std::size_t i = first; i < first + source.size_of_block(b); ++i)
      xyz = std::copy_n(cloud.points[i].data(), 3, xyz);
  };
  internal::Skeletonizer skeletonizer(internal::Concurrency::sequential, options);
  const internal::Progress progress;
  skeletonizer.fit_mixture(source, progress);
  skeletonizer.project(progress);
  skeletonizer.link(progress);
  Skeleton skeleton;
  internal::set_public_skeleton(
    skeletonizer.skeleton(), 0, [](const internal::Index_lists&) {}, Kernel(), skeleton);
  const Graph_counts counts = count_graph(skeleton);
  return {counts.components, counts.cycles, counts.ends};
}

std::vector<Counts> counts_of(const std::vector<Cloud>& clouds, const internal::Options& options,
                              std::size_t threads)
{
  std::vector<Counts> result;
  run_jobs(
    clouds.size(), threads, [&](std::size_t i) { return counts_of(clouds[i], options); },
    [&](const Counts& counts) { result.push_back(counts); });
  return result;
}

/// Number of clouds for which `is_so(i)`.
template <typename Predicate>
std::size_t count(std::size_t size, const Predicate& is_so)
{
  std::size_t result = 0;
  for(std::size_t i = 0; i < size; ++i)
    result += is_so(i) ? 1 : 0;
  return result;
}

/// Names and defaults, in their order.
std::vector<std::pair<std::string, double>> all_options()
{
  std::vector<std::pair<std::string, double>> result;
  internal::Options().visit(
    [&](const char* name, double value) { result.emplace_back(name, value); });
  return result;
}

} // namespace

void run(const Quality_options& options)
{
  constexpr double share = 0.2;
  const std::vector<Cloud> all = clouds(options);
  const auto exact = [&](const std::vector<Counts>& counts) {
    return count(all.size(), [&](std::size_t i) { return counts[i] == all[i].truth; });
  };
  const std::vector<Counts> before = counts_of(all, internal::Options(), options.threads);
  const std::size_t exact_before = exact(before);
  std::printf("%zu clouds of seeds %u to %u, %zu points, exact with the defaults: %zu\n", all.size(),
              options.first_seed, options.first_seed + options.seeds - 1, options.points,
              exact_before);
  std::printf("%-20s %8s %10s %10s %12s %12s\n", "option", "default", "exact -20%", "exact +20%",
              "changed -20%", "changed +20%");
  const std::vector<std::pair<std::string, double>> names = all_options();
  for(std::size_t k = 0; k < names.size(); ++k) {
    std::array<std::size_t, 2> exact_then, changed;
    for(std::size_t side = 0; side < 2; ++side) {
      internal::Options moved;
      std::size_t index = 0;
      moved.visit([&](const char*, double& value) {
        if(index++ == k)
          value *= side == 0 ? 1 - share : 1 + share;
      });
      const std::vector<Counts> counts = counts_of(all, moved, options.threads);
      exact_then[side] = exact(counts);
      changed[side] = count(all.size(), [&](std::size_t i) { return counts[i] != before[i]; });
    }
    std::printf("%-20s %8.4g %10zu %10zu %12zu %12zu\n", names[k].first.c_str(), names[k].second,
                exact_then[0], exact_then[1], changed[0], changed[1]);
    std::fflush(stdout);
  }
}

} // namespace sweep
