// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sweep.h"

#include "graph_counts.h"
#include "jobs.h"
#include "methods/Method.h"
#include "scans.h"

#include "generator/clouds.h"
#include "generator/families.h"
#include "generator/scanned_families.h"

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

/// What a skeleton is compared by: components, cycles, ends. Of a scan the ends do not count: it
/// may not reach them.
using Counts = std::array<std::size_t, 3>;

struct Cloud
{
  std::vector<shapes::Vector> points;
  Counts truth;
  bool is_scan;
};

std::vector<Cloud> clouds(const Quality_options& options)
{
  std::vector<Cloud> result;
  for(const std::string& family : shapes::family_names())
    for(unsigned int seed = options.first_seed; seed < options.first_seed + options.seeds; ++seed) {
      const shapes::Known_shape shape = shapes::known_shape(family, seed);
      for(const shapes::Variant variant : shapes::usual_variants())
        result.push_back({shapes::sample(shape, variant, options.points, seed),
                          {shape.components, shape.cycles, shape.ends},
                          false});
    }
  Quality_options sparse = options;
  sparse.sizes = {5000}; // where options change most
  for(const scans::Job& job : scans::chosen_jobs(sparse)) {
    const shapes::Known_shape shape = scans::scene_of(job).shape;
    result.push_back({scans::points_of(job, shape), {shape.components, shape.cycles, 0}, true});
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
  return {counts.components, counts.cycles, cloud.is_scan ? 0 : counts.ends};
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

/// Names and defaults, in their order.
std::vector<std::pair<std::string, double>> all_options()
{
  std::vector<std::pair<std::string, double>> result;
  internal::Options().visit(
    [&](const char* name, double value) { result.emplace_back(name, value); });
  return result;
}

bool is_chosen(const std::string& name, const std::vector<std::string>& chosen)
{
  return chosen.empty() || std::find(chosen.begin(), chosen.end(), name) != chosen.end();
}

/// The clouds that are scans, or those that are not.
std::vector<std::size_t> indices(const std::vector<Cloud>& clouds, bool are_scans)
{
  std::vector<std::size_t> result;
  for(std::size_t i = 0; i < clouds.size(); ++i)
    if(clouds[i].is_scan == are_scans)
      result.push_back(i);
  return result;
}

/// A group of clouds.
struct Group
{
  const char* name;
  std::vector<std::size_t> indices;
};

/// How one option changes a group.
struct Changes
{
  std::size_t exact, changed;
};

Changes changes(const std::vector<Cloud>& clouds, const std::vector<std::size_t>& group,
                const std::vector<Counts>& before, const std::vector<Counts>& after)
{
  Changes result{0, 0};
  for(std::size_t i : group) {
    result.exact += after[i] == clouds[i].truth ? 1 : 0;
    result.changed += after[i] != before[i] ? 1 : 0;
  }
  return result;
}

} // namespace

std::vector<std::string> option_names()
{
  std::vector<std::string> result;
  for(const auto& option : all_options())
    result.push_back(option.first);
  return result;
}

void run(const Quality_options& options)
{
  constexpr double share = 0.2;
  const std::vector<Cloud> all = clouds(options);
  const std::array<Group, 2> groups = {
    {{"closed", indices(all, false)}, {"scans", indices(all, true)}}};
  const std::vector<Counts> before = counts_of(all, internal::Options(), options.threads);
  for(const Group& group : groups)
    std::printf("%-7s %zu of %zu exact with the defaults\n", group.name,
                changes(all, group.indices, before, before).exact, group.indices.size());
  std::printf("%-20s %8s  %s\n%-29s", "", "", "closed: exact, changed      scans: exact, changed",
              "option                default");
  for(std::size_t k = 0; k < 2 * groups.size(); ++k)
    std::printf(" %5s%% %5s%%", "-20", "+20");
  std::printf("\n");
  const std::vector<std::pair<std::string, double>> names = all_options();
  for(std::size_t k = 0; k < names.size(); ++k) {
    if(!is_chosen(names[k].first, options.constants))
      continue;
    std::array<std::vector<Counts>, 2> after; // lower, higher
    for(std::size_t side = 0; side < after.size(); ++side) {
      internal::Options moved;
      std::size_t index = 0;
      moved.visit([&](const char*, double& value) {
        if(index++ == k)
          value *= side == 0 ? 1 - share : 1 + share;
      });
      after[side] = counts_of(all, moved, options.threads);
    }
    std::printf("%-20s %8.4g", names[k].first.c_str(), names[k].second);
    for(const Group& group : groups) {
      const Changes low = changes(all, group.indices, before, after[0]),
                    high = changes(all, group.indices, before, after[1]);
      std::printf(" %6zu %6zu %6zu %6zu", low.exact, high.exact, low.changed, high.changed);
    }
    std::printf("\n");
    std::fflush(stdout);
  }
}

} // namespace sweep
