// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SEPARATORS_BALL_OVERLAPS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SEPARATORS_BALL_OVERLAPS_H


#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/medial/Sample.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch_graph.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Surface.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <queue>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// The medial ball in the limb that a patch belongs to.
struct Medial_ball
{
  Vector3 center = Vector3::Zero();
  double radius = 0; ///< 0: not known.
};

/// The ball of every patch: around its sample, if that is off the surface. Patches without one take
/// that of the nearest patch along the surface, but not across a `crease`, a cosine between normals, and
/// not from far away: where
/// two limbs touch no normal can be trusted, and every patch is beside the limb it belongs to.
inline std::vector<Medial_ball> known_balls(const Patches& patches,
                                         const Samples& samples, double crease)
{
  constexpr double reach = 3;       // spacings: half of what a normal is estimated from, and a bit
  constexpr double ball_share = 0.5; // radii: a thick limb touches another with more patches

  std::vector<Medial_ball> balls(patches.size());
  using Step = std::tuple<double, std::size_t, std::size_t>; // length, patch, the one it comes from
  std::priority_queue<Step, std::vector<Step>, std::greater<Step>> queue;
  for(std::size_t i = 0; i < patches.size(); ++i) {
    const double radius = (samples[i].position - patches[i].mean).norm();
    if(radius > 0.01 * patches[i].spacing)
      balls[i] = {samples[i].position, radius};
  }
  const auto is_unknown = [&](std::size_t i) { return balls[i].radius == 0; };
  for(std::size_t i = 0; i < patches.size(); ++i) {
    const std::vector<std::size_t>& neighbors = patches[i].neighbors;
    if(!is_unknown(i) && std::any_of(neighbors.begin(), neighbors.end(), is_unknown)) // few are
      queue.emplace(0, i, i);
  }
  std::vector<bool> done(patches.size(), false);
  while(!queue.empty()) {
    const Step step = queue.top();
    queue.pop();
    const std::size_t i = std::get<1>(step), from = std::get<2>(step);
    if(done[i])
      continue;
    done[i] = true;
    balls[i] = balls[from];
    const double limit = std::max(reach * patches[from].spacing, ball_share * balls[from].radius);
    for(std::size_t j : patches[i].neighbors) {
      const double length = std::get<0>(step) + (patches[i].mean - patches[j].mean).norm();
      if(is_unknown(j) && length < limit && patches[i].normal.dot(patches[j].normal) > crease)
        queue.emplace(length, j, from);
    }
  }
  return balls;
}

/// How far two balls overlap: the radius of the circle in which their spheres meet over that of the
/// smaller ball; 1 if the centre of that is beyond the circle. Neighbours in one limb have nearly the
/// same ball, and where a limb leaves another both balls hold the place between them; the balls of two
/// limbs that only touch do not meet. \pre both are known
inline double relative_overlap(const Medial_ball& a, const Medial_ball& b)
{
  const double smaller = std::min(a.radius, b.radius), larger = std::max(a.radius, b.radius);
  const double distance = (a.center - b.center).norm();
  if(distance >= smaller + larger)
    return 0;
  // How far the plane of the circle lies from the centre of the smaller ball, in its radii.
  const double beyond = distance * distance + smaller * smaller - larger * larger;
  if(beyond <= 0)
    return 1;
  const double plane = beyond / (2 * distance * smaller);
  return std::sqrt(std::max(0.0, 1 - plane * plane));
}

/// How far the medial balls of neighbouring patches overlap, in [0, 1]: 1 in a limb, towards 0 from one
/// limb to another that it touches.
class Ball_overlaps
{
public:
  /// `unknown` counts for a pair of which a patch has no ball; `least_overlap` is what the balls in one
  /// limb have at least.
  Ball_overlaps(const Surface& surface, const Samples& samples, double unknown,
                double least_overlap, Concurrency concurrency)
    : least_overlap_(least_overlap)
  {
    const Patches& patches = surface.patches;
    std::vector<Medial_ball> balls;
    parallel_invoke(
      concurrency, [&] { pairs_ = adjacent_pairs(patches); },
      [&] { balls = known_balls(patches, samples, -surface.options.opposite_normals); });
    overlaps_.resize(pairs_.size());
    parallel_for(concurrency, pairs_.size(), [&](std::size_t k) {
      const Medial_ball &a = balls[pairs_[k].a], &b = balls[pairs_[k].b];
      overlaps_[k] = a.radius > 0 && b.radius > 0 ? relative_overlap(a, b) : unknown;
    });
  }

  /// The pairs of neighbouring patches.
  const std::vector<Patch_pair>& pairs() const { return pairs_; }

  /// Of the `k`-th pair.
  double operator[](std::size_t k) const { return overlaps_[k]; }

  /// Whether one limb goes on from one patch of the `k`-th pair to the other.
  bool are_in_one_limb(std::size_t k) const { return overlaps_[k] >= least_overlap_; }

private:
  double least_overlap_;
  std::vector<Patch_pair> pairs_;
  std::vector<double> overlaps_;
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SEPARATORS_BALL_OVERLAPS_H
