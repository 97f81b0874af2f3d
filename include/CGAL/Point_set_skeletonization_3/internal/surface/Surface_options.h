// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_SURFACE_OPTIONS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_SURFACE_OPTIONS_H

#include <CGAL/assertions.h>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// What counts as adjacent, as facing, and as inside. All thresholds on normals and winding numbers are
/// here, whichever stage asks.
struct Surface_options
{
  /// A neighbour further away than this many times the spacing of either patch lies across a gap.
  /// Between two cells of a sampled surface the spacing itself varies by less than that.
  double adjacency_reach = 2.2;

  /// Ratio of the two larger variances around a patch below which it is more and more of a line, which
  /// has no normal.
  double least_width = 0.1;

  /// Cosine; a direction is along a normal if they enclose less: 60 degrees.
  double along_normal = 0.5;

  /// Cosine; normals that enclose more are opposite, the two sides of a limb or of the air between two
  /// limbs: 107 degrees. A crease between two limbs is a right angle or so, and a bump or noise on one
  /// side turns no normal as far. Normals that enclose less than the supplement continue each other.
  double opposite_normals = -0.3;

  /// Sum of the cosines between the normals of two opposite patches and the way between them, above
  /// which they face each other: both by 66 degrees, or one straight ahead.
  double towards = 0.8;

  /// Confidence in [0, 1] of an orientation below which it is a guess, and nothing is built on it.
  double trusted_orientation = 0.3;

  /// Winding number from which on a place counts as inside: 1 inside and 0 outside a closed surface, a
  /// half on it and in the middle of a hole of the data, less in a limb so thin that its patches are no
  /// planes. On the surface: a patch with less than minus that is inside out, with more oriented well.
  double least_inside = 0.25;

  /// Winding number below which a curve through the shape has left it. Stricter than `least_inside`, as
  /// a curve may not take a short cut through the air beside a hole of the data.
  double air = 0.4;

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
