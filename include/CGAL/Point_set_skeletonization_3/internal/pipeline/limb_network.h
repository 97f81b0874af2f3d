// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PIPELINE_LIMB_NETWORK_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PIPELINE_LIMB_NETWORK_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Progress.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Blocks.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Curve_evidence.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/handle_fronts.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/limb_curve.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/limb_evidence.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/line_trees.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/loose_ends.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/open_loops.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/path_trees.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/prune.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/surface_quotient.h>
#include <CGAL/Point_set_skeletonization_3/internal/medial/Sample.h>
#include <CGAL/Point_set_skeletonization_3/internal/medial/sample_kinds.h>
#include <CGAL/Point_set_skeletonization_3/internal/pipeline/Linking_options.h>
#include <CGAL/Point_set_skeletonization_3/internal/separators/Ball_overlaps.h>
#include <CGAL/Point_set_skeletonization_3/internal/separators/Local_separator.h>
#include <CGAL/Point_set_skeletonization_3/internal/separators/local_separators.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Surface.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// The limbs of a shape and how they are connected.
struct Limb_network
{
  Limb_curve curve;
  std::vector<bool> is_outlier; ///< For each sample.
  double unresolved = 0; ///< `share_unresolved()`; 0 in a frame, in which no limbs are told.
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

/// Whether there is enough evidence for a loop, and room for a hole. In a tree, what was not seen
/// from all sides counts against what was, since a limb may end there, or have another way: the less
/// of a loop was seen, the wider its hole must be, and of one that is kept more was seen than not.
/// O(length of the loop).
inline bool is_loop(const Loop& loop, const Skeleton_graph& graph, Limb_reading reading,
                    double least_evidence)
{
  const Curve_evidence seen = evidence_along(loop, graph);
  if(reading == Limb_reading::known_tree || seen.evidence() < least_evidence)
    return false;
  const double share = reading == Limb_reading::frame ? 1 : seen.surplus();
  return share * room_for_hole(loop, graph) >= 1;
}

/// Returns the number of components at each vertex. O(patches).
inline std::vector<double> components_of(const Surface_quotient& quotient, const Patches& patches)
{
  std::vector<double> result;
  for(const std::vector<std::size_t>& members : quotient.members) {
    double components = 0;
    for(std::size_t i : members)
      components += static_cast<double>(patches[i].components);
    result.push_back(components);
  }
  return result;
}

/// Returns how well each vertex was seen to be in a limb: its evidence, less for a cross-section
/// with fewer components than go around any limb (`Curve_options::least_points`). Such a thread
/// is pruned, so of two ways through one limb it must not be the one that is left. On a line of
/// points every point is a cross-section. O(n).
/// \param components `components_of()`
inline std::vector<double> strengths(const Skeleton_graph& graph,
                                     const std::vector<double>& components, double least_points)
{
  std::vector<double> result;
  for(std::size_t v = 0; v < components.size(); ++v) {
    const Skeleton_graph::Vertex& vertex = graph.vertices[v];
    const bool is_thread =
      vertex.is_cross_section && !vertex.is_on_line && components[v] < least_points;
    result.push_back(is_thread ? vertex.evidence * components[v] / least_points
                               : vertex.evidence);
  }
  return result;
}

/// Returns the separators that are not mostly of marked patches, in their order. O(n).
inline std::vector<Local_separator> without_marked(std::vector<Local_separator> separators,
                                                   const std::vector<bool>& is_marked)
{
  separators.erase(std::remove_if(separators.begin(), separators.end(),
                                  [&](const Local_separator& separator) {
                                    return are_mostly(separator.patches, is_marked);
                                  }),
                   separators.end());
  return separators;
}

/// Returns the separators but those that are only there because they cut a handle, if they are on
/// no cycle of their quotient, since its loops have been opened. O(n).
inline std::vector<Local_separator> without_idle(std::vector<Local_separator> separators,
                                                 const Surface_quotient& quotient)
{
  const Blocks blocks = blocks_of(quotient.graph);
  std::vector<bool> is_on_cycle(quotient.graph.vertices.size(), false);
  for(std::size_t e = 0; e < quotient.graph.edges.size(); ++e)
    if(!blocks.is_bridge[e]) {
      const auto [v, w] = quotient.graph.edges[e];
      is_on_cycle[v] = is_on_cycle[w] = true;
    }
  std::vector<Local_separator> result;
  for(std::size_t s = 0; s < separators.size(); ++s) // the first vertices are separators
    if(!separators[s].is_of_handle || is_on_cycle[s])
      result.push_back(std::move(separators[s]));
  return result;
}

/// Moves cross-sections whose middle is outside the shape, as that of a channel or of an arc of the
/// wall of a pipe, to the nearest sample of their own that is inside. What is not resolved has no
/// inside. O(patches) at most.
inline void move_inside(Surface_quotient& quotient, const Surface& surface, const Samples& samples,
                        Concurrency concurrency)
{
  std::vector<std::size_t> cross_sections;
  std::vector<Vector3> middles;
  for(std::size_t v = 0; v < quotient.graph.vertices.size(); ++v)
    if(quotient.graph.vertices[v].is_cross_section && !quotient.graph.vertices[v].is_on_line) {
      cross_sections.push_back(v);
      middles.push_back(quotient.graph.vertices[v].position);
    }
  const std::vector<double> winding_numbers =
    surface.winding_number.at_places(middles, concurrency);
  for(std::size_t k = 0; k < cross_sections.size(); ++k) {
    if(winding_numbers[k] >= surface.options.least_inside)
      continue;
    double nearest = std::numeric_limits<double>::infinity();
    for(std::size_t i : quotient.members[cross_sections[k]]) {
      const double distance = (samples[i].position - middles[k]).norm();
      if(distance < nearest && is_off_surface(samples[i], surface.patches[i])) {
        nearest = distance;
        quotient.graph.vertices[cross_sections[k]].position = samples[i].position;
      }
    }
  }
}

/// Returns the network of limbs that separators cut a surface into. In a tree, separators mean
/// nothing where limbs are not resolved: there are trees of paths or, through twigs of single
/// points, spanning trees of these instead. They come before fronts around handles, which would
/// gather twigs. O(n log n) in practice.
/// \param candidates from `separator_candidates()`
inline Limb_network limb_network(const Surface& surface, const Samples& samples,
                                 const Ball_overlaps& overlaps,
                                 const std::vector<Local_separator>& candidates,
                                 Limb_reading reading, const Linking_options& options,
                                 Concurrency concurrency)
{
  const bool is_frame = reading == Limb_reading::frame;
  const std::vector<bool> none(samples.size(), false);
  const Unresolved_limbs unresolved =
    is_frame ? Unresolved_limbs{none, none}
             : unresolved_limbs(surface, samples, options.separators.overlap);
  std::vector<Local_separator> separators = without_marked(
    without_marked(local_separators(candidates, surface, samples, overlaps, !is_frame,
                                    options.separators, concurrency),
                   unresolved.is_of_twig),
    unresolved.is_loose);
  const auto quotient_of = [&] {
    Surface_quotient quotient =
      surface_quotient(surface.patches, samples, overlaps, separators, concurrency);
    quotient = with_line_trees(std::move(quotient), surface.patches, samples, overlaps.pairs(),
                               unresolved);
    quotient = with_path_trees(std::move(quotient), surface, samples, overlaps.pairs(),
                               unresolved.is_loose, concurrency);
    quotient = with_handle_fronts(std::move(quotient), separators, surface.patches, samples,
                                  overlaps.pairs());
    move_inside(quotient, surface, samples, concurrency);
    return quotient;
  };
  const auto with_loops_seen = [&](Surface_quotient quotient) {
    set_evidence(quotient, surface, samples, is_frame ? Strip::side : Strip::leaf, concurrency);
    const std::vector<double> components = components_of(quotient, surface.patches);
    quotient.graph = with_loops_opened(
      quotient.graph, strengths(quotient.graph, components, options.curve.least_points),
      [&](const Loop& loop) {
        return is_loop(loop, quotient.graph, reading, options.curve.limb_evidence) &&
               !leads_through_row(loop, quotient.graph, components, options.curve);
      });
    return quotient;
  };
  Surface_quotient quotient = quotient_of();
  if(std::any_of(separators.begin(), separators.end(),
                 [](const Local_separator& separator) { return separator.is_of_handle; })) {
    separators = without_idle(std::move(separators), with_loops_seen(std::move(quotient)));
    quotient = quotient_of();
  }
  quotient = with_loops_seen(std::move(quotient));
  const Pruned_quotient pruned = prune(quotient, surface.patches, overlaps.pairs(),
                                       surface.components, surface.groups, options.curve);
  Limb_network result;
  result.unresolved = share_unresolved(surface, unresolved, options.separators.overlap);
  // In a frame, what faces a strip is the other side of its limb, though nothing else joins them.
  result.curve = is_frame ? Limb_curve{pruned.graph, samples}
                          : limb_curve(quotient, pruned, surface, samples, concurrency);
  for(std::size_t v : quotient.vertex_of_patch)
    result.is_outlier.push_back(pruned.is_stray[v]);
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
  const auto has_tips = [&] { return number_of_tips(result[0].curve.graph) > 0; };
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
