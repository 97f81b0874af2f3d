// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_FACING_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_FACING_H

#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Surface_options.h>

#include <cmath>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

// Whether two patches face each other is asked before and after the signs of normals are known, and of
// patches that see each other through the shape or through the air. All of it is decided here.

/// Whether two patches, of arbitrary signs, belong to two sheets rather than to one: the segment
/// between them leaves both along their normals; the less flat they are, the closer to them.
inline bool are_opposite_sheets(const Patch& a, const Patch& b, const Surface_options& options)
{
  const Vector3 d = (b.mean - a.mean).normalized();
  return std::abs(a.normal.dot(d)) * a.planarity > options.along_normal &&
         std::abs(b.normal.dot(d)) * b.planarity > options.along_normal;
}

/// Whether two oriented patches face each other through the air between two limbs that nearly touch:
/// their normals are opposite, and each lies in front of the other.
inline bool face_through_air(const Patch& a, const Patch& b, const Surface_options& options)
{
  const Vector3 d = (b.mean - a.mean).normalized();
  const double from_a = a.normal.dot(d), from_b = -b.normal.dot(d);
  return a.normal.dot(b.normal) < options.opposite_normals && from_a > 0 && from_b > 0 &&
         from_a + from_b > options.towards;
}

/// The cosine between a patch's normal and the way to the patch below which a place does not see it
/// from inside; the plane of a curved patch is only exact to 6 degrees (cosine -0.1), and the less its
/// normal can be trusted the further it may be off. Below a half it hides nothing.
inline double least_visible_cosine(double confidence)
{
  return confidence >= 0.5 ? -0.1 - 0.1 / confidence : -2;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_FACING_H
