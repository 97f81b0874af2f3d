// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PIPELINE_LINK_SAMPLES_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PIPELINE_LINK_SAMPLES_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Progress.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Skeleton_graph.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/fit_curve.h>
#include <CGAL/Point_set_skeletonization_3/internal/medial/Sample.h>
#include <CGAL/Point_set_skeletonization_3/internal/pipeline/Linking_options.h>
#include <CGAL/Point_set_skeletonization_3/internal/pipeline/limb_network.h>
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
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  Skeleton_graph graph;
  std::vector<std::size_t> vertex_of_sample; ///< `none` for outliers.
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
  const Limb_network network =
    read_limbs(surface, samples, options, concurrency, progress.part(0, 0.7));
  const Pruned_quotient& pruned = network.pruned;

  const auto is_outlier = [&](std::size_t sample) {
    return pruned.is_stray[network.quotient.vertex_of_patch[sample]];
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
