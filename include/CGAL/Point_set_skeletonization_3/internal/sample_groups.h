// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SAMPLE_GROUPS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SAMPLE_GROUPS_H

#include <CGAL/Point_set_skeletonization_3/internal/Neighbor_search.h>
#include <CGAL/Point_set_skeletonization_3/internal/Skeleton_graph.h>
#include <CGAL/Point_set_skeletonization_3/internal/patch_adjacency.h>
#include <CGAL/Point_set_skeletonization_3/internal/samples.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Samples that stand for the same place of the skeleton.
struct Sample_groups
{
  std::vector<std::size_t> group_of_sample;
  std::vector<Skeleton_graph::Vertex> groups;
};

/// Samples closer than this share of the local radius are one place: a ball is covered by a few
/// groups, and a limb keeps its bends.
constexpr double group_reach = 0.5;

/// Covers the samples by balls of `group_reach` times their radius, the thickest first. Such a ball
/// lies deep inside the solid, so what it covers belongs together.
inline Sample_groups group_samples(const std::vector<Sample>& samples,
                                   const std::vector<Patch>& patches)
{
  constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> order(samples.size());
  for(std::size_t i = 0; i < order.size(); ++i)
    order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return samples[a].radius != samples[b].radius ? samples[a].radius > samples[b].radius : a < b;
  });

  const Neighbor_search search(samples.size(), [&](std::size_t i) { return samples[i].position; });
  Sample_groups result;
  result.group_of_sample.assign(samples.size(), none);
  std::vector<std::size_t> covered;
  for(std::size_t seed : order) {
    if(result.group_of_sample[seed] != none)
      continue;
    // No place can be told from another within half the spacing of the patches.
    const double reach = group_reach * std::max(samples[seed].radius, patches[seed].spacing);
    search.within(samples[seed].position, reach, covered);
    covered.push_back(seed); // within() may leave out what lies on its sphere
    Skeleton_graph::Vertex group{Vector3::Zero(), 0};
    double count = 0;
    for(std::size_t i : covered) {
      if(result.group_of_sample[i] != none)
        continue;
      result.group_of_sample[i] = result.groups.size();
      group.position += samples[i].position - samples[seed].position;
      group.radius += samples[i].radius;
      count += 1;
    }
    group.position = samples[seed].position + group.position / count;
    group.radius /= count;
    result.groups.push_back(group);
  }
  return result;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SAMPLE_GROUPS_H
