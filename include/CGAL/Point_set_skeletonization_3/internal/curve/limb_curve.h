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

/// Tells the balls that are in a limb from those between two: their other side is on another one, as
/// that of a leaf which faces it.
class Balls_between_limbs
{
public:
  /// Refers to all arguments. O(n).
  Balls_between_limbs(const Surface_quotient& quotient, const Pruned_quotient& limbs,
                      const Surface& surface, const Samples& samples)
    : quotient_(quotient), limbs_(limbs), surface_(surface), samples_(samples),
      adjacency_(limbs.graph.adjacency())
  {}

  /// Whether most balls of a vertex of the quotient, of those that touch something opposite, are
  /// between limbs; false if it is in no limb. O(patches log n) in practice.
  bool are_most_of(std::size_t vertex) const
  {
    constexpr std::size_t enough = 16; // to be asked; the patches of large pieces are many
    if(limbs_.vertex_of[vertex] == no_vertex)
      return false;
    const std::vector<std::size_t>& patches = quotient_.members[vertex];
    const std::size_t step = (patches.size() + enough - 1) / enough;
    std::size_t between = 0, all = 0;
    for(std::size_t k = 0; k < patches.size(); k += step)
      if(const std::optional<std::size_t> other = opposite(patches[k])) {
        between += is_of_other_limb(vertex, patches[k], *other) ? 1 : 0;
        ++all;
      }
    return 2 * between > all;
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

  /// Whether a patch opposite of patch `i` of a vertex is further along the limbs than it may be in
  /// one: twice as far as they are apart, as in a cross-section at 30 degrees.
  bool is_of_other_limb(std::size_t vertex, std::size_t i, std::size_t opposite) const
  {
    constexpr double longest = 2; // distances of the patches
    const std::size_t from = limbs_.vertex_of[vertex],
                      to = limbs_.vertex_of[quotient_.vertex_of_patch[opposite]];
    if(to == no_vertex) // what is in no limb is of the nearest one
      return false;
    const double most =
      longest * (surface_.patches[i].mean - surface_.patches[opposite].mean).norm();
    bool is_near = false;
    visit_around(limbs_.graph, adjacency_, from, [&](std::size_t v, double way) {
      is_near = v == to && way <= most;
      return v != to && way <= most;
    });
    return !is_near;
  }

  const Surface_quotient& quotient_;
  const Pruned_quotient& limbs_;
  const Surface& surface_;
  const Samples& samples_;
  std::vector<std::vector<std::size_t>> adjacency_; ///< Of the limbs.
};

/// Part 3c: returns the curve of limbs. What the balls of a vertex between limbs have found is the
/// space between these: the vertex is on its patches, as in a sheet whose other side was not seen.
/// O(n log n) in practice.
inline Limb_curve limb_curve(const Surface_quotient& quotient, const Pruned_quotient& limbs,
                             const Surface& surface, const Samples& samples,
                             Concurrency concurrency)
{
  const Balls_between_limbs between(quotient, limbs, surface, samples);
  std::vector<char> is_between(quotient.members.size());
  parallel_for(concurrency, is_between.size(),
               [&](std::size_t v) { is_between[v] = between.are_most_of(v); });
  Limb_curve result{limbs.graph, samples};
  for(std::size_t i = 0; i < samples.size(); ++i)
    if(is_between[quotient.vertex_of_patch[i]])
      result.samples[i] = {surface.patches[i].mean, 0};
  for(std::size_t v = 0; v < is_between.size(); ++v) {
    if(!is_between[v])
      continue;
    Skeleton_graph::Vertex& vertex = result.graph.vertices[limbs.vertex_of[v]];
    const Skeleton_graph::Vertex on_sheet =
      middle(quotient.members[v], surface.patches, result.samples);
    vertex.position = on_sheet.position;
    vertex.radius = on_sheet.radius;
    vertex.open = on_sheet.open;
    vertex.half_width = on_sheet.half_width;
  }
  return result;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_LIMB_CURVE_H
