// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SKELETON_BRANCHES_H
#define CGAL_SKELETON_BRANCHES_H

#include <CGAL/license/Point_set_skeletonization_3.h>

#include <CGAL/Point_set_skeletonization_3/internal/branches/Numbered_skeleton.h>
#include <CGAL/Point_set_skeletonization_3/internal/branches/ordered_branches.h>
#include <CGAL/Skeleton_branch_3.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {

/// \ingroup PkgPointSetSkeletonization3Ref
///
/// A branch of a skeleton of this type.
template <typename Skeleton>
using Skeleton_branch_of =
    Skeleton_branch_3<typename boost::graph_traits<Skeleton>::vertex_descriptor>;

/// \ingroup PkgPointSetSkeletonization3Ref
///
/// Returns the branches of a skeleton with their measures, from the roots outwards.
///
/// A branch is a path between two vertices whose degree is not 2; a root is an end of branches even
/// if its degree is 2. Each edge is in exactly one branch. The branches of a component are ordered
/// by the distance of their far ends from the nearest root, measured along the skeleton: a parent
/// comes before its children. Components are ordered by their first vertices. Where the skeleton
/// has a cycle, the branch that is reached from both ends is marked by `closes_cycle`; it starts at
/// the end that is nearer to the root. A cycle without a junction is one closed branch.
///
/// \tparam Skeleton a `Curve_skeleton_3`, or another BGL graph with `.point` and `.radius` in its
///   vertex bundle
///
/// \param skeleton the skeleton
/// \param roots vertices from which orders are counted, for example the foot of a tree. A component
///   without any gets its lowest tip or junction, see `lowest_vertices()`.
///
/// \throws std::out_of_range if a root is no vertex of the skeleton
///
/// O(n log n) for n vertices and edges. The same skeleton gives the same branches in the same
/// order.
template <typename Skeleton>
std::vector<Skeleton_branch_of<Skeleton>> skeleton_branches(
    const Skeleton& skeleton,
    const std::vector<typename boost::graph_traits<Skeleton>::vertex_descriptor>& roots = {})
{
  namespace internal = Point_set_skeletonization_3::internal;
  const internal::Numbered_skeleton<Skeleton> numbered(skeleton);
  std::vector<Skeleton_branch_of<Skeleton>> result;
  for(const internal::Plain_branch& plain :
      internal::ordered_branches(numbered.plain, numbered.numbers_of(roots))) {
    Skeleton_branch_of<Skeleton> branch;
    branch.vertices = numbered.vertices_of(plain.vertices);
    branch.parent = plain.parent;
    branch.axis = plain.axis;
    branch.order = plain.order;
    branch.closes_cycle = plain.closes_cycle;
    branch.length = plain.length;
    branch.chord = plain.chord;
    branch.mean_radius = plain.mean_radius;
    branch.volume = plain.volume;
    branch.angle = plain.angle;
    result.push_back(std::move(branch));
  }
  return result;
}

/// \ingroup PkgPointSetSkeletonization3Ref
///
/// Returns, for every vertex, the position of its branch in the result of `skeleton_branches()`. A
/// junction belongs to the branch that leads to it, a root to the first of its branches. O(n).
/// \param branches all branches of a skeleton
template <typename Vertex>
std::unordered_map<Vertex, std::size_t>
branch_of_vertices(const std::vector<Skeleton_branch_3<Vertex>>& branches)
{
  std::unordered_map<Vertex, std::size_t> result;
  for(std::size_t b = 0; b < branches.size(); ++b)
    for(const Vertex& v : branches[b].vertices)
      result.emplace(v, b); // the first stays
  return result;
}

/// \ingroup PkgPointSetSkeletonization3Ref
///
/// Returns the lowest tip or junction of each component, the first of several; of a cycle without a
/// junction, its lowest vertex. Roots for a tree that stands. O(n).
/// \param skeleton the skeleton
/// \param axis the vertical one: 0 for x, 1 for y, 2 for z
template <typename Skeleton>
std::vector<typename boost::graph_traits<Skeleton>::vertex_descriptor>
lowest_vertices(const Skeleton& skeleton, std::size_t axis = 2)
{
  namespace internal = Point_set_skeletonization_3::internal;
  const internal::Numbered_skeleton<Skeleton> numbered(skeleton);
  return numbered.vertices_of(internal::least_ends(
      numbered.plain, [&](std::size_t v) { return numbered.plain.vertices[v].point[axis]; }));
}

/// \ingroup PkgPointSetSkeletonization3Ref
///
/// Returns the tip or junction of each component with the greatest radius, the first of several; of
/// a cycle without a junction, its vertex with the greatest radius. Does not depend on the
/// direction in which the shape lies. O(n).
template <typename Skeleton>
std::vector<typename boost::graph_traits<Skeleton>::vertex_descriptor>
thickest_vertices(const Skeleton& skeleton)
{
  namespace internal = Point_set_skeletonization_3::internal;
  const internal::Numbered_skeleton<Skeleton> numbered(skeleton);
  return numbered.vertices_of(internal::least_ends(
      numbered.plain, [&](std::size_t v) { return -numbered.plain.vertices[v].radius; }));
}

} // namespace CGAL

#endif // CGAL_SKELETON_BRANCHES_H
