// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_LIMB_CURVE_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_LIMB_CURVE_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Skeleton_graph.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/prune.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/surface_quotient.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/visit_around.h>
#include <CGAL/Point_set_skeletonization_3/internal/medial/Sample.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Surface.h>

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// A curve in the middle of limbs, and the samples that it is made of.
struct Limb_curve
{
  Skeleton_graph graph;
  Samples samples; ///< One per patch, in their order.
};

/// What some patches of a limb are opposite of, by their balls.
struct Patches_opposite
{
  std::size_t all = 0;           ///< Patches.
  std::size_t of_limbs = 0;      ///< Those that are opposite of something.
  std::size_t of_other_limb = 0; ///< Those that are opposite of another limb.

  /// Whether most of their balls are between limbs.
  bool are_between_limbs() const { return 2 * of_other_limb > of_limbs; }

  /// The share of the patches that face another limb, in [0, 1]; 0 if there are none.
  double share_facing() const
  {
    return all > 0 ? static_cast<double>(of_other_limb) / static_cast<double>(all) : 0;
  }
};

/// Tells the balls that are in a limb from those between two: their other side is on another one, as
/// that of a leaf which faces it.
class Balls_between_limbs
{
public:
  /// Refers to all arguments. O(n) in practice.
  Balls_between_limbs(const Surface_quotient& quotient, const Pruned_quotient& limbs,
                      const Surface& surface, const Samples& samples)
    : quotient_(quotient), limbs_(limbs), surface_(surface), samples_(samples),
      adjacency_(limbs.graph.adjacency()), is_at_junction_(adjacency_.size(), false)
  {
    constexpr double reach = 2; // radii: limbs that part at 60 degrees are not apart yet
    for(std::size_t junction = 0; junction < adjacency_.size(); ++junction)
      if(is_junction(junction))
        visit_around(
          limbs.graph, adjacency_, junction,
          [&](std::size_t u, std::size_t) { return u == junction || !is_junction(u); },
          [&](std::size_t v, double way) {
            const bool is_at = way <= reach * limbs.graph.vertices[junction].radius;
            is_at_junction_[v] = is_at_junction_[v] || is_at;
            return is_at;
          });
  }

  /// Returns what the patches of a vertex of the quotient are opposite of; none if it is in no limb,
  /// or where limbs join. O(patches log n) in practice.
  Patches_opposite of(std::size_t vertex) const
  {
    constexpr std::size_t enough = 16; // to be asked; the patches of large pieces are many
    Patches_opposite result;
    const std::size_t limb_vertex = limbs_.vertex_of[vertex];
    if(limb_vertex == no_vertex || is_at_junction_[limb_vertex])
      return result;
    const std::vector<std::size_t>& patches = quotient_.members[vertex];
    const std::size_t step = (patches.size() + enough - 1) / enough;
    for(std::size_t k = 0; k < patches.size(); k += step) {
      ++result.all;
      if(const std::optional<std::size_t> other = opposite(patches[k])) {
        ++result.of_limbs;
        result.of_other_limb += is_of_other_limb(limb_vertex, patches[k], *other) ? 1 : 0;
      }
    }
    return result;
  }

private:
  /// The patch nearest to the point of the ball of patch `i` that is opposite of it, within a radius;
  /// none if the sample is on the patch.
  std::optional<std::size_t> opposite(std::size_t i) const
  {
    std::optional<std::size_t> result;
    if(!is_off_surface(samples_[i], surface_.patches[i]))
      return result;
    const Vector3 radius = samples_[i].position - surface_.patches[i].mean;
    double nearest = std::numeric_limits<double>::infinity();
    surface_.tree.visit_within(samples_[i].position + radius, radius.norm(),
                               [&](std::size_t k, double squared_distance) {
                                 if(squared_distance < nearest) {
                                   nearest = squared_distance;
                                   result = surface_.tree.order()[k];
                                 }
                               });
    return result;
  }

  /// Whether a patch opposite of patch `i` of a vertex of a limb is of another one: beyond a junction
  /// at the end of the limb, or further along it than it may be, twice as far as the patches are
  /// apart, as in a cross-section at 30 degrees.
  bool is_of_other_limb(std::size_t vertex, std::size_t i, std::size_t opposite) const
  {
    constexpr double longest = 2; // distances of the patches
    const std::size_t other = limbs_.vertex_of[quotient_.vertex_of_patch[opposite]];
    if(other == no_vertex) // what is in no limb is of the nearest one
      return false;
    const double most =
      longest * (surface_.patches[i].mean - surface_.patches[opposite].mean).norm();
    bool is_near = false;
    visit_around(
      limbs_.graph, adjacency_, vertex, [&](std::size_t u, std::size_t) { return !is_junction(u); },
      [&](std::size_t v, double way) {
        is_near = v == other && way <= most;
        return v != other && way <= most;
      });
    return !is_near;
  }

  bool is_junction(std::size_t limb_vertex) const { return adjacency_[limb_vertex].size() > 2; }

  const Surface_quotient& quotient_;
  const Pruned_quotient& limbs_;
  const Surface& surface_;
  const Samples& samples_;
  std::vector<std::vector<std::size_t>> adjacency_; ///< Of the limbs.
  std::vector<bool> is_at_junction_; ///< Vertices of limbs, where these are not apart yet.
};

/// Part 3c: returns the curve of limbs. What the balls of a vertex between limbs have found is the
/// space between these: the vertex is on its patches, as in a sheet whose other side was not seen.
/// O(n log n) in practice.
inline Limb_curve limb_curve(const Surface_quotient& quotient, const Pruned_quotient& limbs,
                             const Surface& surface, const Samples& samples,
                             Concurrency concurrency)
{
  const Balls_between_limbs balls(quotient, limbs, surface, samples);
  std::vector<Patches_opposite> opposite(quotient.members.size());
  parallel_for(concurrency, opposite.size(), [&](std::size_t v) { opposite[v] = balls.of(v); });
  Limb_curve result{limbs.graph, samples};
  for(std::size_t i = 0; i < samples.size(); ++i)
    if(opposite[quotient.vertex_of_patch[i]].are_between_limbs())
      result.samples[i] = {surface.patches[i].mean, 0};
  for(std::size_t v = 0; v < opposite.size(); ++v) {
    if(!opposite[v].are_between_limbs())
      continue;
    Skeleton_graph::Vertex& vertex = result.graph.vertices[limbs.vertex_of[v]];
    const Skeleton_graph::Vertex on_sheet =
      middle(quotient.members[v], surface.patches, result.samples);
    vertex.position = on_sheet.position;
    vertex.radius = on_sheet.radius;
    vertex.open = on_sheet.open;
    vertex.half_width = on_sheet.half_width;
    vertex.facing = opposite[v].share_facing();
  }
  return result;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_LIMB_CURVE_H
