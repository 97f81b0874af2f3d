// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_FACING_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_FACING_H

#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Surface_options.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

// Tests whether two patches face each other, before and after the signs of normals are known.

/// Whether two patches, with normals of arbitrary sign, are on two sheets: the segment between them
/// is within 60 degrees of both normals, or less if the patches are less planar.
inline bool are_opposite_sheets(const Patch& a, const Patch& b, const Surface_options& options)
{
  const Vector3 d = (b.mean - a.mean).normalized();
  return std::abs(a.normal.dot(d)) * a.planarity > options.along_normal &&
         std::abs(b.normal.dot(d)) * b.planarity > options.along_normal;
}

/// Whether two oriented patches face each other, through the solid of a thin limb or through the
/// air between two limbs: normals are opposite, and each lies above the other or each below it, by
/// more in sum than the resolution: less cannot be told from a crease.
inline bool face_each_other(const Patch& a, const Patch& b, const Surface_options& options)
{
  const Vector3 d = b.mean - a.mean;
  const double above_a = a.normal.dot(d), above_b = -b.normal.dot(d); // heights
  return a.normal.dot(b.normal) < options.opposite_normals && above_a * above_b > 0 &&
         std::abs(above_a + above_b) > (std::min)(a.resolution(), b.resolution());
}

/// Returns the least cosine between the normal of a patch and the direction to it at which a place
/// sees it from inside. -0.2, or 12 degrees behind the tangent plane, with confidence 1: 6 degrees
/// since a curved patch deviates from its plane, and 6 for its normal, more if confidence is less.
/// Below 0.5 always visible.
inline double least_visible_cosine(double confidence)
{
  return confidence >= 0.5 ? -0.1 - 0.1 / confidence : -2;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_FACING_H
