// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PUBLISHED_PUBLISHED_PROJECTION_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PUBLISHED_PUBLISHED_PROJECTION_H


#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Progress.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/published/Kernel_packet.h>
#include <CGAL/Point_set_skeletonization_3/internal/published/attraction.h>
#include <CGAL/Point_set_skeletonization_3/internal/published/kernel_growth.h>
#include <CGAL/Point_set_skeletonization_3/internal/published/repulsion.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/Box_tree.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/Packet_tree.h>

#include <CGAL/assertions.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Options of the projection as published (Sec. 3.1 and 3.2).
struct Published_projection_options
{
  /// "20 to 30 iterations turned out to be a good choice for all inputs" (Sec. 5).
  std::size_t iterations = 30;

  /// mu of Eq. 2, in [0, 0.5).
  double repulsion = 0.35;

  void check() const { CGAL_precondition(repulsion >= 0 && repulsion < 0.5); }
};

/// A point of the input that moves to the middle of the shape; lengths in units of the diagonal.
struct L1_sample
{
  Vector3 origin = Vector3::Zero();
  Vector3 position = Vector3::Zero();
  double kernel_radius = 0;
  double radius = 0; ///< Distance to the nearest component.
};

/// Returns h^(0) = 2 diag / |P|^(1/3) (Huang et al. 2013).
inline double initial_kernel_radius(std::size_t number_of_points)
{
  return 2 / std::cbrt(static_cast<double>(number_of_points));
}

/// Moves the samples once by Eq. 2 and grows their kernels by Eq. 10, all from the positions before.
inline void iterate_projection(std::vector<L1_sample>& samples, const Attractors& attractors,
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
  for(std::size_t k = 0; k < samples.size(); ++k) {
    L1_sample& s = samples[tree.order()[k]];
    s.position += to_median[k] + options.repulsion * from_others[k];
    s.kernel_radius += growth * around[k].growth_factor();
  }
}

/// Returns the samples after a fixed number of iterations. O(n (n + m)) per iteration for n samples
/// and m components.
inline std::vector<L1_sample> project_as_published(std::vector<L1_sample> samples,
                                                   const Gaussians& mixture,
                                                   const Published_projection_options& options,
                                                   Concurrency concurrency,
                                                   const Progress& progress)
{
  options.check();
  if(samples.empty())
    return samples;
  const Attractors attractors(mixture);
  const double growth = samples.front().kernel_radius / 2; // delta h of Eq. 10
  for(std::size_t iteration = 0; iteration < options.iterations; ++iteration) {
    iterate_projection(samples, attractors, growth, options, concurrency);
    progress(static_cast<double>(iteration + 1) / static_cast<double>(options.iterations));
  }
  return samples;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PUBLISHED_PUBLISHED_PROJECTION_H
