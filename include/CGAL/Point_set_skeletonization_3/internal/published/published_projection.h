// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PUBLISHED_PUBLISHED_PROJECTION_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PUBLISHED_PUBLISHED_PROJECTION_H


#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Progress.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/published/Kernel_packet.h>
#include <CGAL/Point_set_skeletonization_3/internal/published/Published_options.h>
#include <CGAL/Point_set_skeletonization_3/internal/published/attraction.h>
#include <CGAL/Point_set_skeletonization_3/internal/published/kernel_growth.h>
#include <CGAL/Point_set_skeletonization_3/internal/published/repulsion.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/Box_tree.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/Packet_tree.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// A point of the input that moves to the middle of the shape; lengths in units of the diagonal.
struct L1_sample
{
  Vector3 origin = Vector3::Zero();
  Vector3 position = Vector3::Zero();
  double kernel_radius = 0;
  double radius = 0; ///< Distance to the nearest component.
};

/// Moves the samples once by Eq. 2 and grows their kernels by Eq. 10, all from the positions
/// before. Returns the number of samples that have settled.
inline std::size_t iterate_projection(std::vector<L1_sample>& samples, const Attractors& attractors,
                               double growth, const Published_projection_options& options,
                               Concurrency concurrency)
{
  std::vector<Vector3> positions;
  for(const L1_sample& s : samples)
    positions.push_back(s.position);
  const Box_tree tree(positions, concurrency);
  const Packet_tree packet_tree(tree);
  Kernels kernels{tree.positions(), {}};
  for(std::size_t i : tree.order())
    kernels.radii.push_back(samples[i].kernel_radius);

  const std::vector<Surroundings> around = surroundings(packet_tree, kernels, concurrency);
  const std::vector<Vector3> to_median = attractors.attraction(kernels, concurrency);
  const std::vector<Vector3> from_others = repulsion(packet_tree, kernels, around, concurrency);
  std::size_t settled = 0;
  for(std::size_t k = 0; k < samples.size(); ++k) {
    L1_sample& s = samples[tree.order()[k]];
    const Vector3 way = to_median[k] + options.repulsion * from_others[k];
    if(around[k].anisotropy >= options.settled_anisotropy &&
       way.norm() < options.settled_movement * options.kernel_growth * s.kernel_radius)
      ++settled;
    s.position += way;
    s.kernel_radius += growth * around[k].growth_factor();
  }
  return settled;
}

/// Samples, and how many iterations moved them.
struct Projected_samples
{
  std::vector<L1_sample> samples;
  std::size_t iterations = 0;
};

/// Returns the samples after the iterations, or earlier if they halt. O(n (n + m)) per iteration
/// for n samples and m components.
inline Projected_samples project_as_published(std::vector<L1_sample> samples,
                                              const Gaussians& mixture,
                                              const Published_projection_options& options,
                                              Concurrency concurrency, const Progress& progress)
{
  options.check();
  Projected_samples result{std::move(samples), 0};
  if(result.samples.empty())
    return result;
  const Attractors attractors(mixture);
  const double growth = options.kernel_growth * result.samples.front().kernel_radius; // Delta h
  while(result.iterations < options.iterations) {
    const std::size_t settled =
      iterate_projection(result.samples, attractors, growth, options, concurrency);
    ++result.iterations;
    progress(static_cast<double>(result.iterations) / static_cast<double>(options.iterations));
    if(options.halts && 2 * settled >= result.samples.size())
      break;
  }
  return result;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PUBLISHED_PUBLISHED_PROJECTION_H
