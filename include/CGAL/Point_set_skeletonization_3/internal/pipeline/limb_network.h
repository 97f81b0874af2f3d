// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PIPELINE_LIMB_NETWORK_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PIPELINE_LIMB_NETWORK_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Progress.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Curve_evidence.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/limb_evidence.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/loose_ends.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/open_loops.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/prune.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/surface_quotient.h>
#include <CGAL/Point_set_skeletonization_3/internal/medial/Sample.h>
#include <CGAL/Point_set_skeletonization_3/internal/pipeline/Linking_options.h>
#include <CGAL/Point_set_skeletonization_3/internal/separators/Ball_overlaps.h>
#include <CGAL/Point_set_skeletonization_3/internal/separators/Local_separator.h>
#include <CGAL/Point_set_skeletonization_3/internal/separators/local_separators.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Surface.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// The limbs of a shape and how they are connected.
struct Limb_network
{
  Surface_quotient quotient;
  Pruned_quotient pruned;
};

/// How to read limbs that are not resolved (twigs of a few points across, limbs as thin as the
/// noise, open strips), where nothing local tells the joint of two limbs from two that touch.
enum class Limb_reading
{
  frame,      ///< Adjacent patches without medial balls are in one limb: contacts close loops.
  tree,       ///< They are if they are coplanar, in a sheet, whose narrow holes are of the data;
              ///< others are joined where nothing else joins them: only resolved limbs close loops.
  known_tree, ///< The same, and nothing closes a loop.
};

/// Whether there is enough evidence for a loop.
inline bool is_loop(const Curve_evidence& loop, Limb_reading reading, double least_evidence)
{
  return reading != Limb_reading::known_tree && loop.evidence() >= least_evidence &&
         (reading == Limb_reading::frame || !loop.is_open());
}

/// Returns the network of limbs that separators cut a surface into. O(n log n) in practice.
/// \param candidates from `separator_candidates()`
inline Limb_network limb_network(const Surface& surface, const Samples& samples,
                                 const Ball_overlaps& overlaps,
                                 const std::vector<Local_separator>& candidates,
                                 Limb_reading reading, const Linking_options& options,
                                 Concurrency concurrency)
{
  const std::vector<Local_separator> separators =
    local_separators(candidates, surface, samples, overlaps, reading != Limb_reading::frame,
                     options.separators, concurrency);
  Limb_network result;
  result.quotient = surface_quotient(surface.patches, samples, overlaps, separators, concurrency);
  set_evidence(result.quotient, surface, samples, concurrency);
  result.quotient.graph =
    with_loops_opened(std::move(result.quotient.graph), [&](const Curve_evidence& loop) {
      return is_loop(loop, reading, options.curve.limb_evidence);
    });
  result.pruned = prune(result.quotient, surface.patches, surface.components, surface.groups,
                        options.curve);
  return result;
}

/// Part 3a to 3c: returns the network of limbs, or two readings of it: as a frame, then as a tree.
/// There is one reading if all patches have balls, if the frame has no tips, or if the shape is
/// known to be a tree. O(n log n) in practice.
inline std::vector<Limb_network> read_limbs(const Surface& surface, const Samples& samples,
                                            const Linking_options& options,
                                            Concurrency concurrency, const Progress& progress)
{
  constexpr double as_frame = 1, as_tree = 0; // overlap of unknown balls
  const bool is_tree = options.known.is_tree;
  const Ball_overlaps overlaps(surface, samples, is_tree ? as_tree : as_frame,
                               options.separators.overlap, concurrency);
  progress(0.1);
  const std::vector<Local_separator> candidates =
    separator_candidates(surface, samples, overlaps.pairs(), options.separators, concurrency);
  progress(0.6);
  const auto read = [&](const Ball_overlaps& known, Limb_reading reading) {
    return limb_network(surface, samples, known, candidates, reading, options, concurrency);
  };
  if(is_tree || !overlaps.has_unknown())
    return {read(overlaps, is_tree ? Limb_reading::known_tree : Limb_reading::frame)};
  std::vector<Limb_network> result(2);
  const auto has_tips = [&] { return number_of_tips(result[0].pruned.graph) > 0; };
  parallel_invoke(
    concurrency, [&] { result[0] = read(overlaps, Limb_reading::frame); },
    [&] {
      if(concurrency == Concurrency::parallel || has_tips()) // a second thread has nothing to lose
        result[1] = read(overlaps.with_unknown(as_tree), Limb_reading::tree);
    });
  if(!has_tips())
    result.pop_back();
  progress(1);
  return result;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PIPELINE_LIMB_NETWORK_H
