// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SEPARATORS_SEPARATOR_OPTIONS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SEPARATORS_SEPARATOR_OPTIONS_H

#include <CGAL/assertions.h>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// What a separator of a limb looks like.
struct Separator_options
{
  /// The flattest limbs that are seen: their width over their thickness.
  double flattest = 6;

  /// Share of the larger of two parts of a region's front that the smaller has at least: limbs do not
  /// taper faster in one ball.
  double least_share = 0.2;

  /// Share of the second part of a front from which on a third makes a junction, which is what the
  /// separators around it leave over; less is a dent or a bump.
  double junction_share = 0.3;

  /// Radii; regions that grow from places closer than that are the same, and only one is grown.
  double same_seed = 0.15;

  /// Radii; regions that grow from places closer than that end in much the same way, and two are enough.
  double same_place = 0.4;

  /// Radius of the circle in which the medial balls of two neighbours meet, over that of the smaller
  /// ball, from which on they are in one limb: a half where two round limbs of the same size cross each
  /// other with an eighth of their width.
  double overlap = 0.5;

  /// Patches; what the points show as a hole is surrounded by more.
  double around_a_tip = 4;

  void check() const
  {
    CGAL_precondition(flattest > 1);
    CGAL_precondition(least_share > 0 && least_share < 1);
    CGAL_precondition(junction_share > 0 && junction_share < 1);
    CGAL_precondition(same_seed > 0 && same_place > 0);
    CGAL_precondition(overlap > 0 && overlap < 1);
    CGAL_precondition(around_a_tip >= 0);
  }

  /// Calls `visit(name, value)` for every option.
  template <typename Visit>
  void visit(const Visit& visit)
  {
    visit("flattest", flattest);
    visit("least_share", least_share);
    visit("junction_share", junction_share);
    visit("same_seed", same_seed);
    visit("same_place", same_place);
    visit("overlap", overlap);
    visit("around_a_tip", around_a_tip);
  }
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SEPARATORS_SEPARATOR_OPTIONS_H
