// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_VISIBILITY_COMPLEX_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_VISIBILITY_COMPLEX_H

#include <CGAL/Point_set_skeletonization_3/internal/Neighbor_search.h>
#include <CGAL/Point_set_skeletonization_3/internal/sample_groups.h>
#include <CGAL/Point_set_skeletonization_3/internal/solid_side.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Groups further apart than this many radii of the larger are not asked whether they see each
/// other: a junction of limbs lies within two radii of the body they leave.
constexpr double sight_reach = 2;

/// The complex that carries the shape's topology: groups of samples that see each other inside the
/// solid.
class Visibility_complex
{
public:
  Visibility_complex(const std::vector<Skeleton_graph::Vertex>& groups, const Solid_side& side)
    : groups_(groups), side_(side)
  {}

  /// Whether the segment between two groups stays in the solid. The ball of one may hold the other:
  /// then there is nothing to ask.
  bool sees(std::size_t a, std::size_t b) const
  {
    return length(a, b) < std::max(groups_[a].radius, groups_[b].radius) ||
           !side_.leaves_solid(groups_[a].position, groups_[b].position);
  }

  /// Whether the triangle between three groups that see each other stays in the solid: not if there
  /// is a hole narrower than the triangle.
  bool fills(std::size_t a, std::size_t b, std::size_t c) const
  {
    const double radius = std::max({groups_[a].radius, groups_[b].radius, groups_[c].radius});
    if(length(a, b) < radius && length(b, c) < radius && length(c, a) < radius)
      return true;
    const Vector3 center = (groups_[a].position + groups_[b].position + groups_[c].position) / 3;
    return !side_.leaves_solid(groups_[a].position, center) &&
           !side_.leaves_solid(groups_[b].position, center) &&
           !side_.leaves_solid(groups_[c].position, center);
  }

  double length(std::size_t a, std::size_t b) const
  {
    return (groups_[a].position - groups_[b].position).norm();
  }

private:
  const std::vector<Skeleton_graph::Vertex>& groups_;
  const Solid_side& side_;
};

/// Pairs of groups that are worth asking: their patches are adjacent on the surface, or they are
/// close for their size. Shortest first, without duplicates.
inline std::vector<Skeleton_graph::Edge> neighboring_groups(const Sample_groups& groups,
                                                            const std::vector<Patch>& patches)
{
  std::vector<Skeleton_graph::Edge> edges;
  const auto add = [&](std::size_t a, std::size_t b) {
    if(a != b)
      edges.emplace_back(std::min(a, b), std::max(a, b));
  };
  for(std::size_t i = 0; i < patches.size(); ++i)
    for(std::size_t j : patches[i].neighbors)
      add(groups.group_of_sample[i], groups.group_of_sample[j]);

  const Neighbor_search search(groups.groups.size(),
                               [&](std::size_t g) { return groups.groups[g].position; });
  std::vector<std::size_t> near;
  for(std::size_t g = 0; g < groups.groups.size(); ++g) {
    search.within(groups.groups[g].position, sight_reach * groups.groups[g].radius, near);
    for(std::size_t h : near)
      add(g, h);
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());

  const auto squared_length = [&](const Skeleton_graph::Edge& e) {
    return (groups.groups[e.first].position - groups.groups[e.second].position).squaredNorm();
  };
  std::stable_sort(edges.begin(), edges.end(),
                   [&](const Skeleton_graph::Edge& a, const Skeleton_graph::Edge& b) {
                     return squared_length(a) < squared_length(b);
                   });
  return edges;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_VISIBILITY_COMPLEX_H
