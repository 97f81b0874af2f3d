// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SKELETON_BRANCH_3_H
#define CGAL_SKELETON_BRANCH_3_H

#include <CGAL/license/Point_set_skeletonization_3.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {

/// \ingroup PkgPointSetSkeletonization3Ref
///
/// A branch of a curve skeleton: a path between two vertices whose degree is not 2, or a whole
/// cycle without a junction, or a lone vertex. Lengths are in the unit of the input, angles in
/// degrees.
///
/// Where limbs grow from limbs, as in a tree, several branches make one limb: the trunk goes on
/// after every junction. Such a limb is an *axis*. Its branches have the same `axis` and `order`.
///
/// \tparam Vertex the vertex descriptor of the skeleton
template <typename Vertex = std::size_t>
struct Skeleton_branch_3
{
  /// The `parent` of a branch that has none.
  static constexpr std::size_t none = std::size_t(-1);

  /// The vertices of the path, from the end that is nearer to the root. The first and the last are
  /// the same if the branch is closed; a lone vertex is given once.
  std::vector<Vertex> vertices;

  /// Position of the branch that leads from the root to `vertices.front()`, always less than the
  /// position of this branch; `none` if it starts at the root.
  std::size_t parent = none;

  /// Number of the axis, counted from 0. An axis goes on into that child with which most of the
  /// skeleton's length hangs; every other child starts an axis.
  std::size_t axis = 0;

  /// Number of axes between this one and the root: 0 for the trunk, 1 for a limb on the trunk.
  std::size_t order = 0;

  /// Whether both ends are reached from the root without it: without all such branches the skeleton
  /// has no cycle. Each starts an axis.
  bool closes_cycle = false;

  double length = 0;      ///< Of the path.
  double chord = 0;       ///< Distance of its two ends.
  double mean_radius = 0; ///< Mean along the path; of a lone vertex, its radius.
  double volume = 0;      ///< Of truncated cones, one per edge.

  /// Angle to the parent where the branch starts, in [0, 180]: 0 straight on, 180 back. Directions
  /// are those of chords from two to five radii along the paths, as these bend inside the parent;
  /// that of the parent is measured farther back where a branch leaves so sharply that it stays
  /// half inside for longer. Not a number if there is no parent, or nothing but a point to have a
  /// direction.
  double angle = std::numeric_limits<double>::quiet_NaN();
};

} // namespace CGAL

#endif // CGAL_SKELETON_BRANCH_3_H
