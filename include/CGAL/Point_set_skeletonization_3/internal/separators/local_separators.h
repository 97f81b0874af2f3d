// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SEPARATORS_LOCAL_SEPARATORS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SEPARATORS_LOCAL_SEPARATORS_H


#include <CGAL/Point_set_skeletonization_3/internal/core/Per_thread.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/medial/Sample.h>
#include <CGAL/Point_set_skeletonization_3/internal/separators/Ball_overlaps.h>
#include <CGAL/Point_set_skeletonization_3/internal/separators/Growing_region.h>
#include <CGAL/Point_set_skeletonization_3/internal/separators/Local_separator.h>
#include <CGAL/Point_set_skeletonization_3/internal/separators/Separator_options.h>
#include <CGAL/Point_set_skeletonization_3/internal/separators/choose_separators.h>
#include <CGAL/Point_set_skeletonization_3/internal/separators/handle_separators.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/Box_tree.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch_graph.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Surface.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Returns the patches from which regions grow, ascending; of samples within `same_seed` radii the
/// first only. O(n log n).
inline std::vector<std::size_t> separator_seeds(const Samples& samples,
                                                const Separator_options& options,
                                                Concurrency concurrency)
{
  const Box_tree places(positions_of(samples), concurrency);
  std::vector<bool> tried(samples.size(), false);
  std::vector<std::size_t> seeds;
  for(std::size_t seed = 0; seed < samples.size(); ++seed) {
    if(tried[seed])
      continue;
    seeds.push_back(seed);
    places.visit_within(samples[seed].position, options.same_seed * samples[seed].radius,
                        [&](std::size_t k, double) { tried[places.order()[k]] = true; });
  }
  return seeds;
}

/// Returns the separators grown from `seeds`, in their order. A seed is skipped if its patch is on
/// two separators, or if two regions have grown from nearby: most of them are equal, and the
/// shortest is among the first few. (Baerentzen & Rotenberg 2021 skip such seeds with a
/// probability.)
inline std::vector<Local_separator> grown_separators(const Patches& patches,
                                                     const Samples& samples,
                                                     const Patch_graph& graph,
                                                     const std::vector<std::size_t>& seeds,
                                                     const Separator_options& options,
                                                     Concurrency concurrency)
{
  constexpr int enough = 2;
  // In each round regions grow all over the shape; results count for later rounds only, and so do
  // not depend on the number of threads. More rounds skip hardly more seeds.
  constexpr std::size_t rounds = 8;
  Per_thread<Growing_region> region(
    concurrency, [&] { return Growing_region(patches, graph, samples, options); });
  std::vector<Growing_region::Result> results(seeds.size());
  std::vector<int> tried(patches.size(), 0);
  for(std::size_t round = 0; round < rounds; ++round) {
    std::vector<std::size_t> open;
    for(std::size_t s = round; s < seeds.size(); s += rounds)
      if(tried[seeds[s]] < enough)
        open.push_back(s);
    parallel_for(concurrency, open.size(), [&](std::size_t k) {
      results[open[k]] = region.local().grow_from(seeds[open[k]]);
    });
    for(std::size_t s : open)
      for(const auto* held : {&results[s].separator.patches, &results[s].same})
        for(std::size_t i : *held)
          ++tried[i];
  }
  std::vector<Local_separator> found;
  for(Growing_region::Result& result : results)
    if(!result.separator.patches.empty())
      found.push_back(std::move(result.separator));
  return found;
}

/// Part 3a: returns candidates for separators, the shortest first: of all separators at one place
/// the shortest is the cross-section. O(n log n) in practice.
/// \param pairs adjacent patches, `Ball_overlaps::pairs()`
inline std::vector<Local_separator> separator_candidates(const Surface& surface,
                                                         const Samples& samples,
                                                         const std::vector<Patch_pair>& pairs,
                                                         const Separator_options& options,
                                                         Concurrency concurrency)
{
  std::vector<std::size_t> seeds;
  std::optional<Patch_graph> graph;
  parallel_invoke(
    concurrency, [&] { seeds = separator_seeds(samples, options, concurrency); },
    [&] { graph.emplace(surface.patches, pairs); });
  std::vector<Local_separator> found =
    grown_separators(surface.patches, samples, *graph, seeds, options, concurrency);
  std::sort(found.begin(), found.end(), [](const Local_separator& a, const Local_separator& b) {
    return a.length != b.length ? a.length < b.length : a.patches < b.patches;
  });
  return found;
}

/// Part 3a: returns those of the candidates that cut limbs, in their order, no patch on two of
/// them; then rings around the handles that these leave. O(n log n) in practice.
/// \param fills_gaps see `Separator_choice`
inline std::vector<Local_separator>
local_separators(std::vector<Local_separator> candidates, const Surface& surface,
                 const Samples& samples, const Ball_overlaps& overlaps, bool fills_gaps,
                 const Separator_options& options, Concurrency concurrency)
{
  const Patch_graph graph(surface.patches, overlaps.pairs());
  const Patch_graph limbs(surface.patches, overlaps.pairs(),
                          [&](std::size_t k) { return overlaps.are_in_one_limb(k); });
  Separator_choice choice(std::move(candidates), surface, samples, limbs, fills_gaps, options,
                          concurrency);
  return Handle_cuts(choice.run(), choice, surface.patches, samples, limbs, graph, options).run();
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SEPARATORS_LOCAL_SEPARATORS_H
