// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_LOCAL_SEPARATORS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_LOCAL_SEPARATORS_H

#include <CGAL/Point_set_skeletonization_3/internal/Growing_region.h>
#include <CGAL/Point_set_skeletonization_3/internal/Neighbor_search.h>
#include <CGAL/Point_set_skeletonization_3/internal/Per_thread.h>
#include <CGAL/Point_set_skeletonization_3/internal/Way_around.h>
#include <CGAL/Point_set_skeletonization_3/internal/parallel_for.h>
#include <CGAL/Point_set_skeletonization_3/internal/patch_adjacency.h>
#include <CGAL/Point_set_skeletonization_3/internal/samples.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Patches to grow regions from, ascending: no sample of one at the place of that of another.
template <typename ConcurrencyTag>
std::vector<std::size_t> separator_seeds(const std::vector<Sample>& samples)
{
  // Regions grown from places closer than this share of their radius would be the same.
  constexpr double same_place = 0.15;
  const Neighbor_search places(
    samples.size(), [&](std::size_t i) { return samples[i].position; }, ConcurrencyTag());
  std::vector<bool> tried(samples.size(), false);
  std::vector<std::size_t> seeds;
  std::vector<std::size_t> near;
  for(std::size_t seed = 0; seed < samples.size(); ++seed) {
    if(tried[seed])
      continue;
    seeds.push_back(seed);
    places.within(samples[seed].position, same_place * samples[seed].radius, near);
    for(std::size_t i : near)
      tried[i] = true;
  }
  return seeds;
}

/// Separators grown from the seeds, in their order. A patch that two separators hold needs no third
/// (Baerentzen & Rotenberg 2021 skip such seeds the more likely the more separators hold them): most
/// of them are the same, and the tightest cross-section is among the first few. Nor does a place from
/// which two regions have found none.
template <typename ConcurrencyTag>
std::vector<Local_separator> grown_separators(const std::vector<Patch>& patches,
                                              const std::vector<Sample>& samples,
                                              const std::vector<std::size_t>& seeds)
{
  constexpr int enough = 2;
  // Every round grows from seeds all over the shape; what is found counts for the rounds after it,
  // so the result does not depend on the number of threads. More rounds skip hardly more seeds.
  constexpr std::size_t rounds = 8;
  const Patch_edges edges(patches);
  std::vector<Vector3> means;
  means.reserve(patches.size());
  for(const Patch& patch : patches)
    means.push_back(patch.mean);
  Per_thread<ConcurrencyTag, Growing_region> region(
    [&] { return Growing_region(patches, means, edges, samples); });
  std::vector<Growing_region::Result> results(seeds.size());
  std::vector<int> tried(patches.size(), 0);
  for(std::size_t round = 0; round < rounds; ++round) {
    std::vector<std::size_t> open;
    for(std::size_t s = round; s < seeds.size(); s += rounds)
      if(tried[seeds[s]] < enough)
        open.push_back(s);
    parallel_for<ConcurrencyTag>(open.size(), [&](std::size_t k) {
      results[open[k]] = region.local().grow_from(seeds[open[k]]);
    });
    for(std::size_t s : open)
      for(std::size_t i : results[s].same)
        ++tried[i];
  }
  std::vector<Local_separator> found;
  for(Growing_region::Result& result : results)
    if(!result.separator.patches.empty())
      found.push_back(std::move(result.separator));
  return found;
}

/// Separators that cut limbs, all over the shape, the shortest first and none touching a patch of
/// another: of all that cross one place the tightest is the cross-section.
template <typename ConcurrencyTag = Sequential_tag>
std::vector<Local_separator> disjoint_separators(const std::vector<Patch>& patches,
                                                 const std::vector<Sample>& samples,
                                                 const Limb_joints& joints,
                                                 const Winding_number& winding_number)
{
  std::vector<Local_separator> found =
      grown_separators<ConcurrencyTag>(patches, samples, separator_seeds<ConcurrencyTag>(samples));
  std::sort(found.begin(), found.end(), [](const Local_separator& a, const Local_separator& b) {
    return a.length != b.length ? a.length < b.length : a.patches < b.patches;
  });

  Way_around way_around(patches, samples, joints, winding_number);
  std::vector<bool> taken(patches.size(), false);
  std::vector<Local_separator> result;
  for(Local_separator& separator : found) {
    if(std::any_of(separator.patches.begin(), separator.patches.end(),
                   [&](std::size_t i) { return taken[i]; }) ||
       !way_around.cuts(separator))
      continue;
    for(std::size_t i : separator.patches)
      taken[i] = true;
    result.push_back(std::move(separator));
  }
  return result;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_LOCAL_SEPARATORS_H
