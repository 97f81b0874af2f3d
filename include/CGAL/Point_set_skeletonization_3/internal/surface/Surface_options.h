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
  /// Greatest variance across a patch of several components, in (0, 1), relative to that of a cell
  /// of its width that is filled with points. A round limb then has five to nine patches around it.
  double flatness = 0.02;

  /// Ratio of variances, the middle to the largest of several components, in (0, 1], below which
  /// they are a piece of a line and no patch, however flat: nearly twice as long as wide.
  double narrow = 0.3;

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

  /// Orientation confidence, in (0, 1), below which a normal is not used.
  double trusted_orientation = 0.3;

  /// Least winding number inside, in (0, 0.5). It is 1 inside and 0 outside a closed surface, 0.5
  /// on it, in the middle of a hole of the data, and in a limb that was seen from one side, where
  /// grazing views take some of it. Patches count as much as they are planar: the medial balls of
  /// a thin limb, whose patches are not, need as much less. Further out in the mouth of a funnel,
  /// such as a rolled leaf, it falls below.
  double least_inside = 0.35;

  /// Checks all ranges.
  void check() const
  {
    CGAL_precondition(flatness > 0 && flatness < 1);
    CGAL_precondition(narrow > 0 && narrow <= 1);
    CGAL_precondition(adjacency_reach >= 1);
    CGAL_precondition(least_width > 0 && least_width <= 1);
    CGAL_precondition(along_normal > 0 && along_normal < 1);
    CGAL_precondition(opposite_normals > -1 && opposite_normals <= 0);
    CGAL_precondition(trusted_orientation > 0 && trusted_orientation < 1);
    CGAL_precondition(0 < least_inside && least_inside < 0.5);
  }

  /// Calls `visit(name, value)` for every option.
  template <typename Visit>
  void visit(const Visit& visit)
  {
    visit("flatness", flatness);
    visit("narrow", narrow);
    visit("adjacency_reach", adjacency_reach);
    visit("least_width", least_width);
    visit("along_normal", along_normal);
    visit("opposite_normals", opposite_normals);
    visit("trusted_orientation", trusted_orientation);
    visit("least_inside", least_inside);
  }
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_SURFACE_OPTIONS_H
