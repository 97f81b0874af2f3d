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

  Way_around<ConcurrencyTag> way_around(patches, samples, joints, winding_number);
  std::vector<typename Way_around<ConcurrencyTag>::Evidence> evidence(found.size());
  std::vector<bool> known(found.size(), false); // whether there is evidence
  std::vector<bool> taken(patches.size(), false);
  const auto touches = [](const Local_separator& separator, const std::vector<bool>& marked) {
    return std::any_of(separator.patches.begin(), separator.patches.end(),
                       [&](std::size_t i) { return marked[i]; });
  };
  const auto mark = [](const Local_separator& separator, std::vector<bool>& marked) {
    for(std::size_t i : separator.patches)
      marked[i] = true;
  };
  // For one, and for all after it for which it is likely to be needed: they touch nothing that is
  // taken, nor a separator before them that is still to be decided on.
  const auto find_evidence = [&](std::size_t first) {
    std::vector<bool> open = taken;
    std::vector<std::size_t> wanted;
    std::vector<const Local_separator*> separators;
    for(std::size_t s = first; s < found.size(); ++s)
      if(!touches(found[s], taken)) {
        if(!known[s] && !touches(found[s], open)) {
          wanted.push_back(s);
          separators.push_back(&found[s]);
        }
        mark(found[s], open);
      }
    auto all = way_around.evidence(separators);
    for(std::size_t k = 0; k < wanted.size(); ++k) {
      evidence[wanted[k]] = std::move(all[k]);
      known[wanted[k]] = true;
    }
  };
  std::vector<Local_separator> result;
  for(std::size_t s = 0; s < found.size(); ++s) {
    if(touches(found[s], taken))
      continue;
    if(!known[s])
      find_evidence(s);
    if(!way_around.cuts(found[s], evidence[s]))
      continue;
    mark(found[s], taken);
    result.push_back(std::move(found[s]));
  }
  return result;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_LOCAL_SEPARATORS_H
