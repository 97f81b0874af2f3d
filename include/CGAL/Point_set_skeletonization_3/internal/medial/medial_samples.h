// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MEDIAL_MEDIAL_SAMPLES_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MEDIAL_MEDIAL_SAMPLES_H

#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/medial/Sample.h>
#include <CGAL/Point_set_skeletonization_3/internal/medial/medial_balls.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Surface.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// What a medial ball may be like.
struct Medial_options
{
  /// How much the radius may change over a path along the surface: thickness changes no faster. What
  /// faces the tip of a limb is the body at its other end, not the tip's other side.
  double slope = 0.5;

  /// Radii that a sample may be away from its patch, beside one spacing. A limb is wider than thick,
  /// and in a flat part a sample slides along its medial sheet.
  double reach = 3;

  void check() const { CGAL_precondition(slope > 0 && reach >= 1); }

  /// Calls `visit(name, value)` for every option.
  template <typename Visit>
  void visit(const Visit& visit)
  {
    visit("slope", slope);
    visit("reach", reach);
  }
};

/// Moves every patch of a surface to the centre of its medial ball. The sample of a patch stays on the
/// patch where its orientation is in doubt, or the ball is outside of the shape or does not reach the
/// patch: there the normal is wrong, or it is a twig that has no inside. O(n log n).
inline Samples medial_samples(const Surface& surface, const Medial_options& options,
                              Concurrency concurrency)
{
  options.check();
  const double least_inside = surface.options.least_inside;
  const Patches& patches = surface.patches;
  const std::vector<double> balls = medial_ball_radii(surface, options.slope, concurrency);

  std::vector<Vector3> centers; // in the order of the tree: those next to each other are close
  centers.reserve(patches.size());
  for(std::size_t i : surface.tree.order())
    centers.push_back(patches[i].mean - balls[i] * patches[i].normal);
  const std::vector<double> at_centers =
    surface.tree.by_index(surface.winding_number.at_places(centers, concurrency));
  std::vector<Vector3> positions(patches.size());
  std::vector<char> is_inside(patches.size());
  for(std::size_t i = 0; i < patches.size(); ++i) {
    is_inside[i] = surface.confidence[i] >= surface.options.trusted_orientation &&
                   at_centers[i] >= least_inside;
    positions[i] =
      is_inside[i] ? Vector3(patches[i].mean - balls[i] * patches[i].normal) : patches[i].mean;
  }

  const std::vector<double> radii =
    surface.visible.distances_beside_patches(positions, concurrency);
  Samples samples(patches.size());
  parallel_for(concurrency, samples.size(), [&](std::size_t i) {
    const double away = (positions[i] - patches[i].mean).norm();
    const bool is_lost =
      away > options.reach * radii[i] + patches[i].spacing ||
      (!is_inside[i] && surface.winding_number(positions[i]) < least_inside);
    if(is_lost)
      samples[i] = {patches[i].mean, 0};
    else
      samples[i] = {positions[i], radii[i]};
  });
  return samples;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MEDIAL_MEDIAL_SAMPLES_H
