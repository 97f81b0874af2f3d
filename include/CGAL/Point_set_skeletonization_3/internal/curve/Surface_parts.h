// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_SURFACE_PARTS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_SURFACE_PARTS_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Union_find.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/surface_quotient.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch_graph.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// What is left of the parts of a surface in a graph from which vertices are removed. Between parts
/// are gaps, over which edges may lead. Who asks `are_last()` before leaves something of each.
class Surface_parts
{
public:
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  /// No part.
  Surface_parts() = default;

  /// \param part_of_vertex the part of each vertex, a number below that of the vertices, or `none`.
  ///        O(n)
  explicit Surface_parts(std::vector<std::size_t> part_of_vertex)
    : part_(std::move(part_of_vertex)), left_(part_.size(), 0)
  {
    for(std::size_t part : part_)
      if(part != none)
        ++left_[part];
  }

  /// Removes a vertex. \pre it was not removed before
  void remove(std::size_t v)
  {
    if(has_part(v))
      --left_[part_[v]];
  }

  /// Whether different vertices are all that is left of a part. O(vertices).
  bool are_last(const std::vector<std::size_t>& vertices) const
  {
    std::unordered_map<std::size_t, std::size_t> number; // of each part
    return std::any_of(vertices.begin(), vertices.end(), [&](std::size_t v) {
      return has_part(v) && ++number[part_[v]] == left_[part_[v]];
    });
  }

private:
  bool has_part(std::size_t v) const { return v < part_.size() && part_[v] != none; }

  std::vector<std::size_t> part_; ///< Of each vertex.
  std::vector<std::size_t> left_; ///< Number of vertices of each part.
};

/// Returns the parts of a surface that have at least `least_share` of the points of the largest:
/// adjacent patches are in one. O(patches + pairs).
inline Surface_parts surface_parts(const Surface_quotient& quotient, const Patches& patches,
                                   const std::vector<Patch_pair>& pairs, double least_share)
{
  Union_find sets(patches.size());
  for(const Patch_pair& pair : pairs)
    sets.join(pair.a, pair.b);
  std::vector<double> points(patches.size(), 0);
  for(std::size_t i = 0; i < patches.size(); ++i)
    points[sets.find(i)] += patches[i].weight;
  const double least = least_share * *std::max_element(points.begin(), points.end());
  std::vector<std::size_t> first(patches.size(), Surface_parts::none); // vertex of each part
  std::vector<std::size_t> part(quotient.graph.vertices.size(), Surface_parts::none);
  for(std::size_t i = 0; i < patches.size(); ++i) {
    const std::size_t v = quotient.vertex_of_patch[i], set = sets.find(i);
    if(points[set] < least)
      continue;
    if(first[set] == Surface_parts::none)
      first[set] = v;
    if(part[v] == Surface_parts::none)
      part[v] = first[set];
  }
  return Surface_parts(std::move(part));
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_SURFACE_PARTS_H
