// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MEDIAL_MEDIAL_SAMPLES_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MEDIAL_MEDIAL_SAMPLES_H

#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/medial/Medial_options.h>
#include <CGAL/Point_set_skeletonization_3/internal/medial/Sample.h>
#include <CGAL/Point_set_skeletonization_3/internal/medial/medial_balls.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Surface.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Part 2c: returns for each patch the centre of its medial ball and the distance to the nearest
/// visible patch. The sample stays on its patch if the orientation is not trusted, the centre is
/// outside the shape, or the ball does not reach the patch: the normal is wrong, or a twig is too
/// thin to have an inside. O(n log n) in practice.
inline Samples medial_samples(const Surface& surface, const Medial_options& options,
                              Concurrency concurrency)
{
  options.check();
  const Patches& patches = surface.patches;
  const auto is_inside_beside = [&](std::size_t i, double winding_number) {
    return winding_number >= surface.options.least_inside * patches[i].planarity;
  };
  const std::vector<double> balls = medial_ball_radii(surface, options.slope, concurrency);

  std::vector<Vector3> centers; // in the order of the tree, so that consecutive ones are close
  centers.reserve(patches.size());
  for(std::size_t i : surface.tree.order())
    centers.push_back(patches[i].mean - balls[i] * patches[i].normal);
  const std::vector<double> at_centers =
    surface.tree.by_index(surface.winding_number.at_places(centers, concurrency));
  std::vector<Vector3> positions(patches.size());
  std::vector<char> is_inside(patches.size());
  for(std::size_t i = 0; i < patches.size(); ++i) {
    is_inside[i] = surface.confidence[i] >= surface.options.trusted_orientation &&
                   is_inside_beside(i, at_centers[i]);
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
      (!is_inside[i] && !is_inside_beside(i, surface.winding_number(positions[i])));
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
