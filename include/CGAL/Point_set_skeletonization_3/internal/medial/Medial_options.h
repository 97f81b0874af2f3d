// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MEDIAL_MEDIAL_OPTIONS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MEDIAL_MEDIAL_OPTIONS_H

#include <CGAL/assertions.h>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Options of parts 2c and 2d, medial samples.
struct Medial_options
{
  /// Greatest change of the radius over a path along the surface, per length, > 0: thickness
  /// changes no faster. What faces the tip of a limb is the body at its other end, not the other
  /// side of the tip.
  double slope = 0.5;

  /// Radii, >= 1; greatest distance of a sample from its patch, plus one spacing. A limb is wider
  /// than thick, and in a flat part a sample slides along its medial sheet.
  double reach = 3;

  /// Radii, > 0; two patches have the same medial ball if the centres are closer: samples of a limb
  /// that is not quite round, or measured with noise, are that far off its axis.
  double same_ball = 0.5;

  /// Radii of the medial ball, > 0; greatest width of a hole in the side of a limb. A third of
  /// the circumference is missing if it is 1.73. Of a limb scanned from one side it is half, and
  /// nothing tells how it goes on.
  double widest_hole = 1.73;

  void check() const
  {
    CGAL_precondition(slope > 0 && reach >= 1);
    CGAL_precondition(same_ball > 0 && widest_hole > 0);
  }

  /// Calls `visit(name, value)` for every option.
  template <typename Visit>
  void visit(const Visit& visit)
  {
    visit("slope", slope);
    visit("reach", reach);
    visit("same_ball", same_ball);
    visit("widest_hole", widest_hole);
  }
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MEDIAL_MEDIAL_OPTIONS_H
