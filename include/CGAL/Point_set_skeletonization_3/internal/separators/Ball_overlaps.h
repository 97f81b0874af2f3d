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

/// The medial ball of the limb that a patch belongs to.
struct Medial_ball
{
  Vector3 center = Vector3::Zero();
  double radius = 0; ///< 0: unknown.

  /// The centre, seen from the patch that it was found at.
  Vector3 offset = Vector3::Zero();
};

/// Returns a ball moved until it touches `place`, if it does not reach it: along the surface at the
/// patch that it was found at, as the limb may go on, and across it only as far as no move along it
/// is enough.
inline Medial_ball moved_to_touch(const Medial_ball& ball, const Vector3& place)
{
  const Vector3 way = place - ball.center;
  if(!(way.norm() > ball.radius))
    return ball;
  const Vector3 inwards = ball.offset.normalized();
  const double height = inwards.dot(way), within = std::clamp(height, -ball.radius, ball.radius);
  const Vector3 along = way - height * inwards;
  const double length = along.norm();
  // Of the circle in which the ball meets the plane along the surface through the place.
  const double radius = std::sqrt(ball.radius * ball.radius - within * within);
  Medial_ball result = ball;
  result.center += (height - within) * inwards;
  if(length > radius)
    result.center += (1 - radius / length) * along;
  return result;
}

/// Returns a medial ball for each patch, centred at its sample if that is off the surface. Other
/// patches take the ball of the nearest patch along the surface (Dijkstra), moved until it touches
/// them, within a limited distance and not across a `crease`, the least cosine between adjacent
/// normals: where two limbs touch, normals are unreliable, but nearby patches are in the same limb.
/// Radius 0 if none is found. O(n log n).
inline std::vector<Medial_ball> known_balls(const Patches& patches, const Samples& samples,
                                            double crease)
{
  constexpr double reach = 3;       // spacings: the neighbourhood of a normal, and a margin
  constexpr double ball_share = 0.5; // radii: thick limbs touch along more patches

  std::vector<Medial_ball> balls(patches.size());
  using Step = std::tuple<double, std::size_t, std::size_t>; // length of path, patch, source
  std::priority_queue<Step, std::vector<Step>, std::greater<Step>> queue;
  for(std::size_t i = 0; i < patches.size(); ++i)
    if(is_off_surface(samples[i], patches[i])) {
      const Vector3 offset = samples[i].position - patches[i].mean;
      balls[i] = {samples[i].position, offset.norm(), offset};
    }
  const auto is_unknown = [&](std::size_t i) { return balls[i].radius == 0; };
  for(std::size_t i = 0; i < patches.size(); ++i) {
    const std::vector<std::size_t>& neighbors = patches[i].neighbors;
    if(!is_unknown(i) && std::any_of(neighbors.begin(), neighbors.end(), is_unknown)) // rare
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
    balls[i] = i == from ? balls[from] : moved_to_touch(balls[from], patches[i].mean);
    const double limit = (std::max)(reach * patches[from].spacing, ball_share * balls[from].radius);
    for(std::size_t j : patches[i].neighbors) {
      const double length = std::get<0>(step) + (patches[i].mean - patches[j].mean).norm();
      if(is_unknown(j) && length < limit && patches[i].normal.dot(patches[j].normal) > crease)
        queue.emplace(length, j, from);
    }
  }
  return balls;
}

/// Returns the relative overlap of two balls this far apart, in [0, 1]: the radius of the circle in
/// which their spheres intersect over that of the smaller ball; 0 if they are disjoint, 1 if the
/// centre of the smaller ball is beyond that circle. Adjacent patches of one limb have nearly the
/// same ball, and at a junction the balls of both limbs contain the place in between; balls of two
/// limbs that only touch hardly overlap.
/// \pre both radii are positive
inline double relative_overlap(double radius_a, double radius_b, double distance)
{
  const double smaller = (std::min)(radius_a, radius_b), larger = (std::max)(radius_a, radius_b);
  if(distance >= smaller + larger)
    return 0;
  // Distance of the plane of the circle from the centre of the smaller ball, in its radii: `plane`.
  const double beyond = distance * distance + smaller * smaller - larger * larger;
  if(beyond <= 0)
    return 1;
  const double plane = beyond / (2 * distance * smaller);
  return std::sqrt(std::max(0.0, 1 - plane * plane));
}

/// Returns the part of a vector along a limb: across both directions in which its middle is seen.
inline Vector3 along_limb(const Vector3& v, const Vector3& inwards_a, const Vector3& inwards_b)
{
  const Vector3 first = inwards_a.normalized();
  const Vector3 second = (inwards_b - first.dot(inwards_b) * first).normalized(); // or 0
  return v - first.dot(v) * first - second.dot(v) * second;
}

/// Returns how far the balls of two patches are apart, less what the patches are apart along the
/// limb if that is more than its radius: then balls of one limb hardly overlap, either.
inline double distance_in_limb(const Patch& a, const Medial_ball& ball_a, const Patch& b,
                               const Medial_ball& ball_b)
{
  const Vector3 way = ball_b.center - ball_a.center;
  const auto squared_along = [&](const Vector3& v) {
    return along_limb(v, ball_a.offset, ball_b.offset).squaredNorm();
  };
  const double radius = (std::min)(ball_a.radius, ball_b.radius);
  const double along = (std::min)(squared_along(way), squared_along(b.mean - a.mean));
  return along > radius * radius ? std::sqrt((std::max)(0.0, way.squaredNorm() - along))
                                 : way.norm();
}

/// Whether the balls of two patches are no further apart than the patches, each as seen from the
/// patch that it was found at: the surface between them is flat or convex. Two limbs that touch
/// meet at a crease, where the balls are further apart.
inline bool is_convex_between(const Patch& a, const Medial_ball& ball_a, const Patch& b,
                              const Medial_ball& ball_b)
{
  const Vector3 bend = ball_a.offset - ball_b.offset;
  return 2 * bend.dot(a.mean - b.mean) + bend.squaredNorm() <= 0;
}

/// The relative overlap of the medial balls of adjacent patches, in [0, 1]: near 1 within a limb,
/// near 0 between two limbs that touch. Balls of patches that are as long as a limb is wide hardly
/// overlap either: 1 where the surface is convex, elsewhere as much as they do across the limb. A
/// sheet has no balls; instead of their overlap, how coplanar the patches are says whether they are
/// in one limb.
class Ball_overlaps
{
public:
  /// O(n log n).
  /// \param unknown least overlap of a pair if a patch has no ball, in [0, 1]
  /// \param least_overlap least overlap within a limb, in (0, 1)
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
    const auto is_unknown = [&](std::size_t k) {
      return !(balls[pairs_[k].a].radius > 0 && balls[pairs_[k].b].radius > 0);
    };
    parallel_for(concurrency, pairs_.size(), [&](std::size_t k) {
      const auto [a, b] = pairs_[k];
      if(is_unknown(k))
        overlaps_[k] = coplanarity(patches[a], patches[b]);
      else if(is_convex_between(patches[a], balls[a], patches[b], balls[b]))
        overlaps_[k] = 1;
      else
        overlaps_[k] =
          relative_overlap(balls[a].radius, balls[b].radius,
                           distance_in_limb(patches[a], balls[a], patches[b], balls[b]));
    });
    const auto has_ball = [&](std::size_t i) { return is_off_surface(samples[i], patches[i]); };
    is_measured_.resize(pairs_.size());
    for(std::size_t k = 0; k < pairs_.size(); ++k) {
      is_measured_[k] = has_ball(pairs_[k].a) && has_ball(pairs_[k].b);
      if(is_unknown(k))
        unknown_.push_back({k, overlaps_[k]});
    }
    set_unknown(unknown);
  }

  /// Whether a pair has a patch without ball.
  bool has_unknown() const { return !unknown_.empty(); }

  /// The same with another least overlap of such pairs, in [0, 1].
  Ball_overlaps with_unknown(double overlap) const
  {
    Ball_overlaps result = *this;
    result.set_unknown(overlap);
    return result;
  }

  /// All pairs of adjacent patches, in lexicographic order.
  const std::vector<Patch_pair>& pairs() const { return pairs_; }

  /// Overlap of the `k`-th pair.
  double operator[](std::size_t k) const { return overlaps_[k]; }

  /// The least overlap within a limb.
  double least_overlap() const { return least_overlap_; }

  /// Whether both patches of the `k`-th pair have a ball of their own, none that was guessed from
  /// that of another patch.
  bool is_measured(std::size_t k) const { return is_measured_[k]; }

  /// Whether the patches of the `k`-th pair are in one limb.
  bool are_in_one_limb(std::size_t k) const { return overlaps_[k] >= least_overlap_; }

private:
  /// A pair with a patch that has no ball.
  struct Unknown
  {
    std::size_t pair;
    double coplanarity;
  };

  void set_unknown(double overlap)
  {
    for(const Unknown& unknown : unknown_)
      overlaps_[unknown.pair] = (std::max)(overlap, unknown.coplanarity);
  }

  double least_overlap_;
  std::vector<Patch_pair> pairs_;
  std::vector<double> overlaps_;
  std::vector<bool> is_measured_;
  std::vector<Unknown> unknown_;
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SEPARATORS_BALL_OVERLAPS_H
