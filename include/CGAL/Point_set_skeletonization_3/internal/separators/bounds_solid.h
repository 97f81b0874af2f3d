// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SEPARATORS_BOUNDS_SOLID_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SEPARATORS_BOUNDS_SOLID_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/medial/Sample.h>
#include <CGAL/Point_set_skeletonization_3/internal/separators/Local_separator.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch.h>

#include <cstddef>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Whether what a separator encloses is solid: a ring around the inner wall of a pipe encloses air,
/// one around the outer wall mostly air. Neither is a cross-section of a limb.
///
/// By the divergence theorem a ring with outward normals n around c encloses half the integral of
/// n.(p - c); that is negative around air. Between the ring and its medial samples lies as much
/// solid as the integral of the radius, but for the curvature: what the ring encloses, if it is
/// around a flat limb, and twice as much around a round one. A ring around a pipe encloses as many
/// times that as the radius is the thickness of the wall. Patches without a medial ball count
/// nothing, so sheets bound solid. O(patches).
inline bool bounds_solid(const Local_separator& separator, const Patches& patches,
                         const Samples& samples)
{
  constexpr double most = 2; // above 1, and unless a wall is thicker than half the radius
  Vector3 middle = Vector3::Zero();
  for(std::size_t i : separator.patches)
    middle += patches[i].mean / static_cast<double>(separator.patches.size());
  double enclosed = 0, solid = 0;
  for(std::size_t i : separator.patches)
    if(is_off_surface(samples[i], patches[i])) {
      const Vector3 outwards = patches[i].mean - samples[i].position;
      enclosed +=
        patches[i].spacing * outwards.normalized().dot(patches[i].mean - middle) / 2;
      solid += patches[i].spacing * outwards.norm();
    }
  return enclosed >= 0 && enclosed <= most * solid;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SEPARATORS_BOUNDS_SOLID_H
