// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MEDIAL_MEDIAL_SAMPLES_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MEDIAL_MEDIAL_SAMPLES_H

#include <CGAL/Point_set_skeletonization_3/internal/surface/Surface.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Progress.h>
#include <CGAL/Point_set_skeletonization_3/internal/medial/medial_balls.h>
#include <CGAL/Point_set_skeletonization_3/internal/medial/oriented_mixture.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel_for.h>
#include <CGAL/Point_set_skeletonization_3/internal/medial/Sample.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Winding_number.h>

#include <CGAL/assertions.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

struct Projection_options
{
  /// Bound on the iterations. From its medial ball a sample in a limb needs a few; more draw samples of
  /// a bend to its inside, and in a sparse cloud towards single patches. 0 leaves them in the centres
  /// of their balls.
  std::size_t maximum_iterations = 3;

  /// Kernel radius over the radius of the medial ball. The centre of a round tube attracts under
  /// Eq. 9 for ratios above sqrt(32) = 5.7 only (below, the ring itself does); far above, neighbouring
  /// limbs and bends count.
  double kernel_ratio = 8;

  /// A sample that moves less than this share of its kernel radius has arrived.
  double tolerance = 0.003;

  /// A sample stops where its distance to the nearest patch would fall below this share of the
  /// largest it had: the median of a bent shape, of a cupped hand say, may lie outside of it.
  double least_clearance = 0.5;

  void check() const
  {
    CGAL_precondition(kernel_ratio > 0);
    CGAL_precondition(least_clearance >= 0 && least_clearance < 1);
    CGAL_precondition(tolerance >= 0);
  }
};

/// theta falls to 2 % at half its support radius: what lies beyond does not count.
constexpr double kernel_reach = 0.5;

/// Components up to a fourteenth of the kernel radius - half the ball's radius - are points to it.
constexpr double level_ratio = 1.0 / 14;

/// The axis of the limb around a sample: the direction in which the normals it sees do not point.
/// (The idea of ROSA, Tagliasacchi et al. 2009.)
struct Limb_axis
{
  Vector3 direction = Vector3::Zero();
  double certainty = 0; ///< In [0, 1]; 0: the normals point everywhere, or cannot be trusted.
};

inline Limb_axis limb_axis(const Matrix3& normal_tensor)
{
  Eigen::SelfAdjointEigenSolver<Matrix3> solver;
  solver.computeDirect(normal_tensor);
  const Vector3 variance = solver.eigenvalues();
  if(!(variance[2] > 0))
    return {};
  // The normals of a cone of half-angle phi vary 2 tan^2(phi) times as much along its axis as across
  // it: 0.1 is a cone of 13 degrees, 0.4 one of 24 degrees, as a rounded tip or a junction.
  const double along = (variance[0] / variance[2] - 0.1) / 0.3;
  return {solver.eigenvectors().col(0), 1 - std::min(1.0, std::max(0.0, along))};
}

/// The gated attraction of the mixture on a sample, across the limb that it is in.
///
/// Along the axis a sample must not slide, or the tips of the skeleton shrink; and what it sees there
/// must not count, or the median of a bent limb lies on the inside of the bend: the kernel is as thin
/// as the limb in that direction.
inline Vector3 attracted(const Sample& sample, double slab, const Oriented_mixture& mixture,
                         std::vector<std::size_t>& near)
{
  const double h = sample.kernel_radius;
  const Oriented_mixture::Level& level = mixture.level_for(level_ratio * h);
  level.search.within(sample.position, kernel_reach * h, near);

  Matrix3 normal_tensor = Matrix3::Zero();
  std::vector<double> gates;
  for(std::size_t j : near) {
    const Oriented_attractor& a = level.attractors[j];
    gates.push_back(a.seen_from(sample.position));
    const double distance = (a.attractor.mean() - sample.position).squaredNorm();
    normal_tensor += gates.back() * a.attractor.weight() * a.confidence * theta(distance, h) *
                     a.normal * a.normal.transpose();
  }
  const Limb_axis axis = limb_axis(normal_tensor);

  Pull sum;
  for(std::size_t k = 0; k < near.size(); ++k) {
    const Attractor& attractor = level.attractors[near[k]].attractor;
    const double along = axis.direction.dot(attractor.mean() - sample.position) / slab;
    const double gate = gates[k] * std::exp(-2 * axis.certainty * along * along);
    if(!(gate > 0))
      continue;
    const Pull pull = attractor.pull(sample.position, h);
    sum.weighted_position += gate * pull.weighted_position;
    sum.weight += gate * pull.weight;
  }
  if(!(sum.weight > 0))
    return sample.position;
  const Vector3 step = sum.weighted_position / sum.weight - sample.position;
  return sample.position + step - axis.certainty * axis.direction.dot(step) * axis.direction;
}

/// Samples at the patch means, moved to the centre of their medial ball where there is one.
template <typename ConcurrencyTag>
std::vector<Sample> medial_samples(const std::vector<Patch>& patches,
                                   const std::vector<double>& confidence,
                                   const Winding_number& winding_number,
                                   const std::vector<double>& ball_radii,
                                   const Projection_options& options)
{
  const auto center = [&](std::size_t i) {
    return Vector3(patches[i].mean - ball_radii[i] * patches[i].normal);
  };
  const std::vector<double> at_centers = winding_number.beside_patches<ConcurrencyTag>(center);
  std::vector<Sample> samples(patches.size());
  parallel_for<ConcurrencyTag>(patches.size(), [&](std::size_t i) {
    Sample& s = samples[i];
    s.origin = s.position = patches[i].mean;
    s.kernel_radius = options.kernel_ratio * std::max(ball_radii[i], patches[i].spacing / 2);
    // Else the normal points the wrong way: let the projection find the way in.
    s.inside = confidence[i] >= trusted_orientation && at_centers[i] >= least_inside;
    if(s.inside)
      s.position = center(i);
  });
  return samples;
}

/// Puts samples that went astray back on their patch. A sample is in the middle of the shape where its
/// patch is: inside, and its ball, the largest around it, reaches that patch. Others had a wrong
/// normal, or sit on a twig that has no inside.
template <typename ConcurrencyTag>
void bring_back_lost_samples(std::vector<Sample>& samples, const std::vector<Patch>& patches,
                             const Winding_number& winding_number)
{
  // A limb is wider than thick, and in a flat part a sample slides along its medial sheet.
  constexpr double reach = 3;
  parallel_for<ConcurrencyTag>(samples.size(), [&](std::size_t i) {
    Sample& sample = samples[i];
    if((sample.position - sample.origin).norm() > reach * sample.radius + patches[i].spacing ||
       (!sample.inside && winding_number(sample.position) < least_inside)) {
      sample.position = sample.origin;
      sample.radius = 0;
    }
  });
}

/// The components of the mixture whose patches a surface has, with their normals.
template <typename ConcurrencyTag>
std::vector<Oriented_gaussian> oriented_gaussians(const Gaussians& components,
                                                  const Surface<ConcurrencyTag>& surface)
{
  // A patch of a few points is thinner than the surface is known; a tenth of the spacing is not.
  const Matrix3 blur = 0.01 * surface.spacing * surface.spacing * Matrix3::Identity();
  std::vector<Oriented_gaussian> result;
  result.reserve(components.size());
  for(std::size_t i = 0; i < components.size(); ++i)
    result.push_back(
      {{components[i].weight, components[i].mean, components[i].covariance + blur},
       surface.patches[i].normal,
       surface.confidence[i]});
  return result;
}

/// Moves the samples to the local L1-medians of the surface, whose patches are those of `components`.
/// Every iteration reads the positions of the one before only, so the bits do not depend on the number
/// of threads.
template <typename ConcurrencyTag>
Projection_outcome project_samples(std::vector<Sample>& samples, const Gaussians& components,
                                   const Surface<ConcurrencyTag>& surface,
                                   const Projection_options& options, const Progress& progress)
{
  options.check();
  Projection_outcome outcome;
  outcome.reason = samples.empty()                   ? Projection_stop_reason::empty
                   : options.maximum_iterations == 0 ? Projection_stop_reason::converged
                                                     : Projection_stop_reason::iteration_limit;
  if(options.maximum_iterations == 0)
    for(Sample& s : samples)
      s.frozen = true;
  std::unique_ptr<Oriented_mixture> mixture; // for the iterations only
  if(options.maximum_iterations > 0)
    mixture = std::make_unique<Oriented_mixture>(oriented_gaussians(components, surface),
                                                 surface.spacing, ConcurrencyTag());
  while(outcome.iterations < options.maximum_iterations && !samples.empty()) {
    parallel_for<ConcurrencyTag>(samples.size(), [&](std::size_t i) {
      Sample& s = samples[i]; // reads and writes no other sample: Jacobi and in place at once
      if(s.frozen)
        return;
      std::vector<std::size_t> near;
      const Vector3 moved = attracted(s, s.kernel_radius / options.kernel_ratio, *mixture, near);
      const double clearance = std::sqrt(mixture->finest().search.nearest(moved).squared_distance);
      s.frozen = (moved - s.position).norm() < options.tolerance * s.kernel_radius ||
                 clearance < options.least_clearance * s.radius;
      if(clearance >= options.least_clearance * s.radius) {
        s.position = moved;
        s.inside = false;
        s.radius = std::max(s.radius, clearance);
      }
    });
    ++outcome.iterations;
    if(!progress(static_cast<double>(outcome.iterations) /
                 static_cast<double>(options.maximum_iterations))) {
      outcome.reason = Projection_stop_reason::cancelled;
      return outcome;
    }
    if(std::all_of(samples.begin(), samples.end(), [](const Sample& s) { return s.frozen; })) {
      outcome.reason = Projection_stop_reason::converged;
      break;
    }
  }
  const std::vector<double> distances =
    surface.visible->template distances_beside_patches<ConcurrencyTag>(
      [&](std::size_t i) { return samples[i].position; });
  for(std::size_t i = 0; i < samples.size(); ++i)
    samples[i].radius = distances[i];
  return outcome;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MEDIAL_MEDIAL_SAMPLES_H
