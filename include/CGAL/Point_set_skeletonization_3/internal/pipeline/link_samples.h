// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PIPELINE_LINK_SAMPLES_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PIPELINE_LINK_SAMPLES_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Progress.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Curve_evidence.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Skeleton_graph.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/fit_curve.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/loose_ends.h>
#include <CGAL/Point_set_skeletonization_3/internal/medial/Sample.h>
#include <CGAL/Point_set_skeletonization_3/internal/pipeline/Linking_options.h>
#include <CGAL/Point_set_skeletonization_3/internal/pipeline/limb_network.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Surface.h>

#include <cstddef>
#include <limits>
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

/// Whether the reading as a frame explains a shape: contacts and continuations close loops of
/// nearly all open limbs. If many of them are on no loop or left out, limbs end freely as in a tree,
/// and what touches does so by accident. Limbs that were seen from all sides say nothing about
/// others. Of strips that are resolved less is enough: they end where the scanner saw no further,
/// and what touches is adjacent along a border. If most of the shape is of such limbs, and most of
/// these are resolved and on loops, it is a frame.
///
/// Where noise hides the other sides, a frame with no more loops is kept nevertheless: what tells
/// limbs apart in a tree is how coplanar patches are, which noise spoils. O(n log n).
/// \param noise strength of the noise removed, in [0, 1]
/// \param unresolved share of the patches that are in no resolved limb nor on a surface, in [0, 1]
inline bool is_frame(const Skeleton_graph& frame, const Skeleton_graph& tree, double noise,
                     double unresolved, const Linking_options& options)
{
  constexpr double most = 0.5;
  if(noise > options.much_noise && number_of_loops(frame) <= number_of_loops(tree))
    return true;
  const double loose = loose_open_share(frame, tree);
  return loose < options.loose_share ||
         (evidence_along(frame).is_open() && (1 - unresolved) * (1 - loose) > most);
}

/// Stage 3: returns the curve skeleton of samples. O(n log n) in practice.
///
/// \param noise strength of the noise removed, in [0, 1]
/// \param points surface points before denoising, which shrinks curved surfaces, each with its
///        sample; those of a sample are consecutive
/// \pre there is a sample
inline Linked_samples link_samples(const Surface& surface, const Samples& samples, double noise,
                                   const std::vector<Surface_point>& points,
                                   const Linking_options& options, Concurrency concurrency,
                                   const Progress& progress)
{
  options.check();
  const std::vector<Limb_network> readings =
    read_limbs(surface, samples, options, concurrency, progress.part(0, 0.7));
  std::vector<Curve_fitting> curves;
  for(const Limb_network& reading : readings)
    curves.emplace_back(reading.curve, reading.is_outlier, surface, points, noise, options.curve,
                        concurrency);
  Curve_fitting& frame = curves.front();
  Curve_fitting& tree = curves.back();
  const bool single_component = options.known.single_component;
  if(curves.size() == 1)
    tree.connect(false, single_component);
  else
    parallel_invoke(
      concurrency, [&] { frame.connect(true, single_component); },
      [&] { tree.connect(false, single_component); });
  Curve_fitting& curve =
    is_frame(frame.graph(), tree.graph(), noise, readings.back().unresolved, options) ? frame
                                                                                      : tree;
  curve.centre();
  progress(0.95);
  Linked_samples result;
  result.graph = curve.graph();
  result.vertex_of_sample = curve.vertices_of_samples();
  for(std::size_t i = 0; i < samples.size(); ++i)
    if(curve.is_outlier()[i])
      result.vertex_of_sample[i] = Linked_samples::none;
  progress(1);
  return result;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PIPELINE_LINK_SAMPLES_H
