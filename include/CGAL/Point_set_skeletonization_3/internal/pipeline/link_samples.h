// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PIPELINE_LINK_SAMPLES_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PIPELINE_LINK_SAMPLES_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Progress.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Curve_options.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Skeleton_graph.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/fit_curve.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/limb_evidence.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/open_loops.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/prune.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/surface_quotient.h>
#include <CGAL/Point_set_skeletonization_3/internal/medial/Sample.h>
#include <CGAL/Point_set_skeletonization_3/internal/pipeline/Known_topology.h>
#include <CGAL/Point_set_skeletonization_3/internal/separators/Ball_overlaps.h>
#include <CGAL/Point_set_skeletonization_3/internal/separators/Separator_options.h>
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

/// A skeleton, and the vertex of each sample.
struct Linked_samples
{
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  Skeleton_graph graph;
  std::vector<std::size_t> vertex_of_sample; ///< `none` for outliers.
};

/// Options of stage 3.
struct Linking_options
{
  Separator_options separators;
  Curve_options curve;

  Known_topology known;

  /// Checks all ranges.
  void check() const
  {
    separators.check();
    curve.check();
  }
};

/// Stage 3: returns the curve skeleton of samples. O(n log n) in practice.
///
/// \param noise strength of the noise removed, in [0, 1]
/// \param points surface points before denoising, which shrinks curved surfaces, each with its
///        sample; those of a sample are consecutive
/// \pre there is a sample
inline Linked_samples link_samples(const Surface& surface, const Samples& samples, double noise,
                                   std::vector<Surface_point> points,
                                   const Linking_options& options, Concurrency concurrency,
                                   const Progress& progress)
{
  options.check();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  // Unknown balls count as `noise`: without noise they are where limbs touch, with noise in any
  // thin limb.
  const Ball_overlaps overlaps(surface, samples, noise, options.separators.overlap, concurrency);
  progress(0.1);
  const std::vector<Local_separator> separators =
    local_separators(surface, samples, overlaps, options.separators, concurrency);
  progress(0.6);
  Surface_quotient quotient =
    surface_quotient(surface.patches, samples, overlaps, separators, concurrency);
  const std::vector<double> evidence = limb_evidence(surface, samples, quotient, concurrency);
  const double least = options.known.is_tree ? infinity : options.curve.loop_evidence;
  quotient.graph = with_loops_opened(std::move(quotient.graph), evidence, least);
  const Pruned_quotient pruned =
    prune(quotient, surface.patches, surface.components, surface.groups, options.curve);
  progress(0.7);

  const auto is_outlier = [&](std::size_t sample) {
    return pruned.is_stray[quotient.vertex_of_patch[sample]];
  };
  points.erase(std::remove_if(points.begin(), points.end(),
                              [&](const Surface_point& p) { return is_outlier(p.sample); }),
               points.end());
  Linked_samples result;
  result.graph = fit_curve(pruned.graph, surface, samples, points, noise,
                           options.known.single_component, options.curve, concurrency);
  progress(0.95);
  result.vertex_of_sample = vertices_of_samples(result.graph, surface, samples, concurrency);
  for(std::size_t i = 0; i < samples.size(); ++i)
    if(is_outlier(i))
      result.vertex_of_sample[i] = Linked_samples::none;
  progress(1);
  return result;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PIPELINE_LINK_SAMPLES_H
