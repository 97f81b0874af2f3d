// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_PATCH_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_PATCH_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// A mixture component read as a piece of surface.
struct Patch
{
  Vector3 mean = Vector3::Zero();
  double weight = 0;

  /// Area of the surface that it stands for.
  double area = 0;

  /// Unit normal; its sign means something once the surface is oriented.
  Vector3 normal = Vector3::UnitZ();

  /// How flat the patch and its surroundings are, in [0, 1]: 1 for a plane, 0 where the two
  /// smaller principal variances are equal and a normal is a guess.
  double planarity = 0;

  /// Distance at which neighbouring patches lie.
  double spacing = 0;

  /// Patches next to it on the surface, ascending; symmetric.
  std::vector<std::size_t> neighbors;
};

using Patches = std::vector<Patch>;

/// Patches of a mixture may all lie at one place; lengths and weights relative to their spacing stay
/// finite if it is no less than this, in bounding box diagonals. Below any spacing of a grid's patches.
constexpr double least_spacing = 1e-6;

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_PATCH_H
