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

#include <algorithm>
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

/// Samples, and how many iterations moved them.
struct Projected_samples
{
  std::vector<L1_sample> samples;
  std::size_t iterations = 0;
};

/// Moves the samples once by Eq. 2 and grows their kernels by Eq. 10, all from the positions
/// before. Returns the share of the samples that were on a curve there, in [0, 1].
inline double iterate_projection(Projected_samples& projected, const Attractors& attractors,
                                 double growth, const Published_projection_options& options,
                                 Concurrency concurrency)
{
  std::vector<L1_sample>& samples = projected.samples;
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
  std::size_t on_curves = 0;
  for(std::size_t k = 0; k < samples.size(); ++k) {
    L1_sample& s = samples[tree.order()[k]];
    const double growth_factor = around[k].growth_factor();
    const Vector3 way = to_median[k] + options.repulsion * from_others[k],
                  across = way - way.dot(around[k].direction) * around[k].direction;
    on_curves += growth_factor <= options.curve_growth &&
                 across.norm() < options.curve_movement * options.kernel_growth * s.kernel_radius;
    s.position += way;
    s.kernel_radius += growth * growth_factor;
  }
  ++projected.iterations;
  return static_cast<double>(on_curves) / static_cast<double>(samples.size());
}

/// The automatic halt: knows when most samples were on curves.
class Automatic_halt
{
public:
  explicit Automatic_halt(const Published_projection_options& options) : options_(options) {}

  /// Looks at samples of which this share is on curves; returns whether that has stopped growing.
  bool is_reached(const Projected_samples& samples, double on_curves)
  {
    constexpr double step = 0.01; // less is chance
    if(on_curves >= (std::max)(options_.least_on_curves, greatest_ + step)) {
      greatest_ = on_curves;
      then_ = samples;
    }
    const auto since = static_cast<double>(samples.iterations - then_.iterations);
    return greatest_ > 0 && since * options_.kernel_growth >= options_.halting_growth;
  }

  /// The samples when their share on curves stopped growing.
  const Projected_samples& samples() const { return then_; }

private:
  Published_projection_options options_;
  double greatest_ = 0; ///< Share of the samples on curves.
  Projected_samples then_;
};

/// Returns the samples after the iterations, or as they were when they should have halted.
/// O(n (n + m)) per iteration for n samples and m components.
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
  Automatic_halt halt(options);
  while(result.iterations < options.iterations) {
    const Projected_samples before = result;
    const double on_curves = iterate_projection(result, attractors, growth, options, concurrency);
    progress(static_cast<double>(result.iterations) / static_cast<double>(options.iterations));
    if(options.halts && halt.is_reached(before, on_curves))
      return halt.samples();
  }
  return result;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PUBLISHED_PUBLISHED_PROJECTION_H
