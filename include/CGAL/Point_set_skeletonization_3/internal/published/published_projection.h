// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PUBLISHED_PUBLISHED_PROJECTION_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PUBLISHED_PUBLISHED_PROJECTION_H


#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Progress.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/published/Point_search.h>
#include <CGAL/Point_set_skeletonization_3/internal/published/attraction.h>
#include <CGAL/Point_set_skeletonization_3/internal/published/kernel_growth.h>

#include <CGAL/assertions.h>

#include <algorithm>
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

/// Kernel radii; components further away are ignored: theta is below 1e-2 at 0.55 h and 4e-3 at 0.6
/// h.
constexpr double published_reach = 0.6;

/// Returns the density at each point, v of Eq. 7 and w of Eq. 8: 1 + sum of theta over the others.
template <typename Radius>
std::vector<double> densities(const std::vector<Vector3>& points, const Radius& kernel_radius,
                              Concurrency concurrency)
{
  const Point_search search(points);
  std::vector<double> result(points.size(), 1);
  parallel_for(concurrency, points.size(), [&](std::size_t i) {
    const double h = kernel_radius(i);
    std::vector<std::size_t> near;
    search.within(points[i], published_reach * h, near);
    for(std::size_t j : near)
      if(j != i)
        result[i] += theta((points[j] - points[i]).squaredNorm(), h);
  });
  return result;
}

/// The components of a mixture as attractors, with their search structure.
struct Attractors
{
  explicit Attractors(const Gaussians& mixture)
    : components(mixture.begin(), mixture.end()),
      search(means_of(mixture))
  {
    for(const Attractor& a : components)
      extent = std::max(extent, 2 * std::sqrt(a.largest_variance()));
  }

  std::vector<Attractor> components;
  Point_search search;
  double extent = 0; ///< Two standard deviations of the largest component.
};

/// Returns F1 of Eq. 9: the local L1-median of the mixture around `q`; `q` itself where no
/// component is near.
inline Vector3 attraction(const Vector3& q, double h, const Attractors& mixture)
{
  std::vector<std::size_t> near;
  mixture.search.within(q, published_reach * h + mixture.extent, near);
  Pull sum;
  for(std::size_t j : near) {
    const Pull pull = mixture.components[j].pull(q, h);
    sum.weighted_position += pull.weighted_position;
    sum.weight += pull.weight;
  }
  return sum.weight > 0 ? Vector3(sum.weighted_position / sum.weight) : q;
}

/// Returns F2 of Eq. 4 with the weights of Eq. 6 and 8 for eta(r) = -r (Huang et al. 2009):
/// repulsion from the other samples. Samples at exactly the same place give no direction and are
/// ignored.
inline Vector3 repulsion(std::size_t i, const std::vector<L1_sample>& samples,
                         const std::vector<std::size_t>& near, const std::vector<double>& density)
{
  const double h = samples[i].kernel_radius;
  Vector3 sum = Vector3::Zero();
  double weight = 0;
  for(std::size_t j : near) {
    const Vector3 d = samples[i].position - samples[j].position;
    const double r = d.norm();
    if(j == i || !(r > 0))
      continue;
    const double beta = density[j] * theta(r * r, h) / r;
    sum += beta * d;
    weight += beta;
  }
  return weight > 0 ? Vector3(sum / weight) : sum;
}

/// Returns the samples after a fixed number of iterations of Eq. 2 with kernels grown by Eq. 10.
/// Each iteration reads the positions of the one before.
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
    std::vector<Vector3> positions;
    for(const L1_sample& s : samples)
      positions.push_back(s.position);
    const std::vector<double> density = densities(
      positions, [&](std::size_t i) { return samples[i].kernel_radius; }, concurrency);
    const Point_search search(positions);

    std::vector<L1_sample> next = samples;
    parallel_for(concurrency, samples.size(), [&](std::size_t i) {
      const L1_sample& s = samples[i];
      std::vector<std::size_t> near;
      search.within(s.position, s.kernel_radius, near);
      next[i].position = attraction(s.position, s.kernel_radius, attractors) +
                         options.repulsion * repulsion(i, samples, near, density);
      next[i].kernel_radius +=
        growth * growth_factor(s.position, s.kernel_radius, positions, near);
    });
    samples.swap(next);
    progress(static_cast<double>(iteration + 1) / static_cast<double>(options.iterations));
  }
  return samples;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PUBLISHED_PUBLISHED_PROJECTION_H
