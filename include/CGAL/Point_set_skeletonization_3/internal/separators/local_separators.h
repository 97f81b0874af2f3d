// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SEPARATORS_LOCAL_SEPARATORS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SEPARATORS_LOCAL_SEPARATORS_H

#include <CGAL/Point_set_skeletonization_3/internal/spatial/Box_tree.h>
#include <CGAL/Point_set_skeletonization_3/internal/separators/Growing_region.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch_graph.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Per_thread.h>
#include <CGAL/Point_set_skeletonization_3/internal/separators/Separator_test.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel_for.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/patches.h>
#include <CGAL/Point_set_skeletonization_3/internal/medial/Sample.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <optional>
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
  const Box_tree places(
    samples.size(), [&](std::size_t i) { return samples[i].position; }, ConcurrencyTag());
  std::vector<bool> tried(samples.size(), false);
  std::vector<std::size_t> seeds;
  for(std::size_t seed = 0; seed < samples.size(); ++seed) {
    if(tried[seed])
      continue;
    seeds.push_back(seed);
    places.visit_within(samples[seed].position, same_place * samples[seed].radius,
                        [&](std::size_t k, double) { tried[places.order()[k]] = true; });
  }
  return seeds;
}

/// Separators grown from the seeds, in their order. A patch that two separators hold needs no third
/// (Baerentzen & Rotenberg 2021 skip such seeds the more likely the more separators hold them): most
/// of them are the same, and the tightest cross-section is among the first few. Nor does a place from
/// which two regions have grown, whether they have found one or none.
template <typename ConcurrencyTag>
std::vector<Local_separator> grown_separators(const std::vector<Patch>& patches,
                                              const std::vector<Sample>& samples,
                                              const Patch_graph& edges,
                                              const std::vector<std::size_t>& seeds)
{
  constexpr int enough = 2;
  // Every round grows from seeds all over the shape; what is found counts for the rounds after it,
  // so the result does not depend on the number of threads. More rounds skip hardly more seeds.
  constexpr std::size_t rounds = 8;
  Per_thread<ConcurrencyTag, Growing_region> region(
    [&] { return Growing_region(patches, edges, samples); });
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

/// Chooses separators that cut limbs, one after the other, none touching a patch of another.
template <typename ConcurrencyTag>
class Separator_choice
{
public:
  Separator_choice(std::vector<Local_separator> separators, Separator_test<ConcurrencyTag>& way_around,
                   std::size_t number_of_patches)
      : separators_(std::move(separators))
      , way_around_(way_around)
      , evidence_(separators_.size())
      , has_evidence_(separators_.size(), false)
      , taken_(number_of_patches, false)
  {}

  std::vector<Local_separator> operator()()
  {
    std::vector<Local_separator> result;
    for(std::size_t s = 0; s < separators_.size(); ++s) {
      if(touches(s, taken_))
        continue;
      if(!has_evidence_[s])
        find_evidence(s);
      if(!way_around_.cuts(separators_[s], evidence_[s]))
        continue;
      mark(s, taken_);
      result.push_back(std::move(separators_[s]));
    }
    return result;
  }

private:
  bool touches(std::size_t s, const std::vector<bool>& marked) const
  {
    return std::any_of(separators_[s].patches.begin(), separators_[s].patches.end(),
                       [&](std::size_t i) { return marked[i]; });
  }

  void mark(std::size_t s, std::vector<bool>& marked) const
  {
    for(std::size_t i : separators_[s].patches)
      marked[i] = true;
  }

  /// For a separator, and for all after it that will be asked for theirs whatever is chosen until
  /// then: they touch neither what is taken nor a separator that comes before them.
  void find_evidence(std::size_t first)
  {
    std::vector<bool> before = taken_;
    std::vector<std::size_t> wanted;
    std::vector<const Local_separator*> separators;
    for(std::size_t s = first; s < separators_.size(); ++s) {
      if(touches(s, taken_))
        continue;
      if(!has_evidence_[s] && !touches(s, before)) {
        wanted.push_back(s);
        separators.push_back(&separators_[s]);
      }
      mark(s, before);
    }
    auto evidence = way_around_.evidence(separators);
    for(std::size_t k = 0; k < wanted.size(); ++k) {
      evidence_[wanted[k]] = std::move(evidence[k]);
      has_evidence_[wanted[k]] = true;
    }
  }

  std::vector<Local_separator> separators_;
  Separator_test<ConcurrencyTag>& way_around_;
  std::vector<typename Separator_test<ConcurrencyTag>::Evidence> evidence_; ///< Of every separator.
  std::vector<bool> has_evidence_;
  std::vector<bool> taken_; ///< Of every patch.
};

/// Separators that cut limbs, grown from the seeds, the shortest first and none touching a patch of
/// another: of all that cross one place the tightest is the cross-section.
template <typename ConcurrencyTag = Sequential_tag>
std::vector<Local_separator> disjoint_separators(const std::vector<Patch>& patches,
                                                 const std::vector<Sample>& samples,
                                                 const std::vector<std::size_t>& seeds,
                                                 const Ball_overlaps& joints,
                                                 const Winding_number& winding_number)
{
  std::optional<Patch_graph> edges;
  std::optional<Separator_test<ConcurrencyTag>> way_around;
  parallel_invoke<ConcurrencyTag>(
    [&] { edges.emplace(patches, joints.pairs()); },
    [&] { way_around.emplace(patches, samples, joints, winding_number); });
  std::vector<Local_separator> found =
    grown_separators<ConcurrencyTag>(patches, samples, *edges, seeds);
  std::sort(found.begin(), found.end(), [](const Local_separator& a, const Local_separator& b) {
    return a.length != b.length ? a.length < b.length : a.patches < b.patches;
  });
  return Separator_choice<ConcurrencyTag>(std::move(found), *way_around, patches.size())();
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SEPARATORS_LOCAL_SEPARATORS_H
