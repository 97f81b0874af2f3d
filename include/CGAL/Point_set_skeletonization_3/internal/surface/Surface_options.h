// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_SURFACE_OPTIONS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_SURFACE_OPTIONS_H

#include <CGAL/assertions.h>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Options of part 2b: all thresholds on normals and winding numbers, for all parts.
struct Surface_options
{
  /// Greatest distance of adjacent patches, in spacings of either, >= 1: beyond it there is a gap.
  /// Between two cells of a sampled surface the spacing itself varies by less.
  double adjacency_reach = 2.2;

  /// Ratio of variances, the middle to the largest around a patch, in (0, 1]. Below it the
  /// planarity falls to 0: the neighbourhood becomes a line, which has no normal.
  double least_width = 0.1;

  /// Cosine, in (0, 1); a direction is along a normal if the angle between them is less than 60
  /// degrees.
  double along_normal = 0.5;

  /// Cosine, in (-1, 0]; normals more than 107 degrees apart are opposite: the two sides of a limb,
  /// or of the air between two limbs. A crease between two limbs is about a right angle; bumps and
  /// noise turn normals by less. Normals less than 73 degrees apart, the supplement, continue each
  /// other.
  double opposite_normals = -0.3;

  /// Two patches with opposite normals face each other if the cosines between their normals and the
  /// segment between them add up to more than this, in (0, 2): both 66 degrees, or one straight
  /// ahead.
  double towards = 0.8;

  /// Orientation confidence, in (0, 1), below which a normal is not used.
  double trusted_orientation = 0.3;

  /// Least winding number inside, in (0, 0.5). It is 1 inside and 0 outside a closed surface, 0.5
  /// on it and in the middle of a hole of the data, and lower in limbs so thin that their patches
  /// are not planar. On the surface, patches below its negative are oriented inwards, patches above
  /// it outwards.
  double least_inside = 0.25;

  /// Winding number, in (0, 1), below which a curve has left the shape. Higher than `least_inside`:
  /// a curve must not pass through the air beside a hole of the data.
  double air = 0.4;

  /// Checks all ranges.
  void check() const
  {
    CGAL_precondition(adjacency_reach >= 1);
    CGAL_precondition(least_width > 0 && least_width <= 1);
    CGAL_precondition(along_normal > 0 && along_normal < 1);
    CGAL_precondition(opposite_normals > -1 && opposite_normals <= 0);
    CGAL_precondition(towards > 0 && towards < 2);
    CGAL_precondition(trusted_orientation > 0 && trusted_orientation < 1);
    CGAL_precondition(0 < least_inside && least_inside < 0.5);
    CGAL_precondition(0 < air && air < 1);
  }

  /// Calls `visit(name, value)` for every option.
  template <typename Visit>
  void visit(const Visit& visit)
  {
    visit("adjacency_reach", adjacency_reach);
    visit("least_width", least_width);
    visit("along_normal", along_normal);
    visit("opposite_normals", opposite_normals);
    visit("towards", towards);
    visit("trusted_orientation", trusted_orientation);
    visit("least_inside", least_inside);
    visit("air", air);
  }
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_SURFACE_OPTIONS_H
