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
  /// Refers to all arguments. O(n log n).
  Limb_holes(const Surface& surface, const Samples& samples, const Medial_options& options,
             Concurrency concurrency)
    : surface_(surface), samples_(samples), options_(options)
  {
    std::vector<char> is_on_border(surface.patches.size());
    parallel_for(concurrency, is_on_border.size(), [&](std::size_t i) {
      is_on_border[i] =
        is_off_surface(samples[i], surface.patches[i]) && ways_onwards(i).has_border();
    });
    std::vector<Vector3> places;
    for(std::size_t i = 0; i < is_on_border.size(); ++i)
      if(is_on_border[i]) {
        border_.push_back(i);
        ways_.push_back(ways_onwards(i));
        places.push_back(surface.patches[i].mean);
      }
    tree_ = Box_tree(places, concurrency);
  }

  /// The patches on the border of a hole, ascending; the other side of the limb was seen.
  const std::vector<std::size_t>& border() const { return border_; }

  /// Returns the patches across a hole from the `b`-th of the border. O(log n) for each
  /// patch of the border that is within its medial ball.
  std::vector<std::size_t> across_from(std::size_t b) const
  {
    std::vector<std::size_t> result;
    const double reach = options_.widest_hole * ball_radius(border_[b]);
    tree_.visit_within(mean(b), reach, [&](std::size_t k, double) {
      const std::size_t other = tree_.order()[k];
      if(other != b && have_one_ball(border_[b], border_[other]) && are_across(b, other))
        result.push_back(border_[other]);
    });
    return result;
  }

private:
  Ways_onwards ways_onwards(std::size_t i) const
  {
    return Ways_onwards(surface_.patches[i], surface_.patches);
  }

  const Vector3& mean(std::size_t b) const { return surface_.patches[border_[b]].mean; }

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

  /// Whether two of the border are open towards each other, with nothing between them.
  bool are_across(std::size_t a, std::size_t b) const
  {
    constexpr double rounding = 1e-6; // both are on the sphere
    const Vector3 way = mean(b) - mean(a);
    return ways_[a].is_open_towards(way) && ways_[b].is_open_towards(-way) &&
           !surface_.tree.has_any_within(mean(a) + way / 2, (1 - rounding) * way.norm() / 2);
  }

  const Surface& surface_;
  const Samples& samples_;
  const Medial_options& options_;
  std::vector<std::size_t> border_;
  std::vector<Ways_onwards> ways_; ///< Of each patch of the border.
  Box_tree tree_;                  ///< Over these.
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
  std::vector<std::vector<std::size_t>> across(holes.border().size());
  parallel_for(concurrency, across.size(),
               [&](std::size_t b) { across[b] = holes.across_from(b); });
  for(std::size_t b = 0; b < across.size(); ++b) {
    std::vector<std::size_t>& neighbors = surface.patches[holes.border()[b]].neighbors;
    neighbors.insert(neighbors.end(), across[b].begin(), across[b].end());
    std::sort(neighbors.begin(), neighbors.end());
    neighbors.erase(std::unique(neighbors.begin(), neighbors.end()), neighbors.end());
  }
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MEDIAL_SPAN_HOLES_H
