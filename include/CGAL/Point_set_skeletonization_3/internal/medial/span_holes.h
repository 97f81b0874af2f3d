// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MEDIAL_SPAN_HOLES_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MEDIAL_SPAN_HOLES_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/medial/Medial_options.h>
#include <CGAL/Point_set_skeletonization_3/internal/medial/Sample.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/Box_tree.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Surface.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// The directions in which the surface goes on around a patch.
class Ways_onwards
{
public:
  /// O(neighbours).
  Ways_onwards(const Patch& patch, const Patches& patches)
    : normal_(patch.normal)
  {
    for(std::size_t j : patch.neighbors)
      ways_.push_back(along_surface(patches[j].mean - patch.mean));
  }

  /// Whether nothing adjacent is within 45 degrees of a direction along the surface: on a border
  /// are 180 degrees free, but between seven irregular neighbours seldom 90.
  bool is_open_towards(const Vector3& direction) const
  {
    constexpr double least_cosine = 0.7071; // of 45 degrees, and below it by more than rounding
    const Vector3 way = along_surface(direction);
    return std::none_of(ways_.begin(), ways_.end(),
                        [&](const Vector3& other) { return way.dot(other) > least_cosine; });
  }

  /// Whether there is such a direction: the patch is on the border of a hole. O(neighbours^2).
  bool has_border() const
  {
    constexpr double turn = 1.001; // the tangent of 45 degrees, and a little more
    return ways_.empty() || std::any_of(ways_.begin(), ways_.end(), [&](const Vector3& way) {
             return is_open_towards(way + turn * normal_.cross(way)); // the first one beside it
           });
  }

private:
  Vector3 along_surface(const Vector3& direction) const
  {
    return (direction - normal_.dot(direction) * normal_).normalized();
  }

  Vector3 normal_;
  std::vector<Vector3> ways_; ///< Of unit length.
};

/// Holes in the data on one side of a limb, as where no scanner saw it, and the patches across.
class Limb_holes
{
public:
  /// Refers to all arguments. O(patches).
  Limb_holes(const Surface& surface, const Samples& samples, const Medial_options& options,
             Concurrency concurrency)
    : surface_(surface), samples_(samples), options_(options),
      on_border_(surface.patches.size())
  {
    parallel_for(concurrency, on_border_.size(), [&](std::size_t i) {
      const Patch& patch = surface_.patches[i];
      on_border_[i] = is_off_surface(samples_[i], patch) &&
                      Ways_onwards(patch, surface_.patches).has_border();
    });
  }

  /// Returns the patches across a hole from patch `i`, ascending; none if it is on no border.
  /// O(log n + patches within its medial ball).
  std::vector<std::size_t> across_from(std::size_t i) const
  {
    std::vector<std::size_t> result;
    if(!on_border_[i])
      return result;
    const Patch& patch = surface_.patches[i];
    const Ways_onwards around(patch, surface_.patches);
    const double reach = options_.widest_hole * ball_radius(i);
    surface_.tree.visit_within(patch.mean, reach, [&](std::size_t k, double) {
      const std::size_t j = surface_.tree.order()[k];
      if(j != i && on_border_[j] && have_one_ball(i, j) &&
         around.is_open_towards(surface_.patches[j].mean - patch.mean) && are_across(i, j))
        result.push_back(j);
    });
    std::sort(result.begin(), result.end());
    return result;
  }

private:
  double ball_radius(std::size_t i) const
  {
    return (samples_[i].position - surface_.patches[i].mean).norm();
  }

  /// Whether two patches are on the same medial ball, and the hole is not too wide for it.
  bool have_one_ball(std::size_t i, std::size_t j) const
  {
    const double radius = (std::min)(ball_radius(i), ball_radius(j));
    const double width = (surface_.patches[i].mean - surface_.patches[j].mean).norm();
    return (samples_[i].position - samples_[j].position).norm() < options_.same_ball * radius &&
           width < options_.widest_hole * radius;
  }

  /// Whether there is nothing between two patches, the first of which is open towards the second.
  bool are_across(std::size_t i, std::size_t j) const
  {
    const Vector3 &from = surface_.patches[i].mean, &to = surface_.patches[j].mean;
    if(!Ways_onwards(surface_.patches[j], surface_.patches).is_open_towards(from - to))
      return false;
    constexpr double rounding = 1e-6; // both are on the sphere
    bool is_empty = true;
    surface_.tree.visit_within((from + to) / 2, (1 - rounding) * (to - from).norm() / 2,
                               [&](std::size_t, double) { is_empty = false; });
    return is_empty;
  }

  const Surface& surface_;
  const Samples& samples_;
  const Medial_options& options_;
  std::vector<char> on_border_; ///< Of a hole; the other side of the limb was seen.
};

/// Part 2d: makes patches adjacent that are across a hole from each other. A limb of which a
/// scanner left out a strip along it is a channel, and one of which it left out two is in two
/// pieces; neither has the cross-sections of a limb. Two patches are across a hole of a limb if
/// they have the same medial ball, none is adjacent to either in the direction of the other, and
/// the ball between them is empty (as for Gabriel neighbours). On closed surfaces a few irregular
/// patches have a gap beside them, one in a hundred; else nothing changes. O(n log n) in practice.
inline void span_holes(Surface& surface, const Samples& samples, const Medial_options& options,
                       Concurrency concurrency)
{
  const Limb_holes holes(surface, samples, options, concurrency);
  std::vector<std::vector<std::size_t>> across(samples.size());
  parallel_for(concurrency, across.size(),
               [&](std::size_t i) { across[i] = holes.across_from(i); });
  for(std::size_t i = 0; i < across.size(); ++i) {
    std::vector<std::size_t>& neighbors = surface.patches[i].neighbors;
    const auto middle = static_cast<std::ptrdiff_t>(neighbors.size());
    neighbors.insert(neighbors.end(), across[i].begin(), across[i].end());
    std::inplace_merge(neighbors.begin(), neighbors.begin() + middle, neighbors.end());
  }
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MEDIAL_SPAN_HOLES_H
