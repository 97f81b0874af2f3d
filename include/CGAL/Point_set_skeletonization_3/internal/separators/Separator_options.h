// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SEPARATORS_SEPARATOR_OPTIONS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SEPARATORS_SEPARATOR_OPTIONS_H

#include <CGAL/assertions.h>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Options of part 3a, local separators. Radii are those of the sample.
struct Separator_options
{
  /// Greatest ratio of width to thickness of a limb that is found, > 1.
  double flattest = 9;

  /// Least ratio of a part of the front to the next larger one, in (0, 1), for it to be on a limb
  /// of its own: limbs do not taper faster within one ball, and less is a dent or a bump. Two parts
  /// are on both sides of a separator; with a third one the region is at a junction, which has
  /// none.
  double least_share = 0.2;

  /// Radii; regions grown from samples closer than this are the same: only one is grown.
  double same_seed = 0.15;

  /// Radii; regions grown from samples closer than this end alike: two are enough.
  double same_place = 0.4;

  /// Least relative overlap of the medial balls of adjacent patches in one limb, in (0, 1): 0.5
  /// where two equal round limbs intersect by an eighth of their width.
  double overlap = 0.5;

  /// Patches; a path around a separator that is not longer leads around a tip. A hole is surrounded
  /// by more.
  double around_a_tip = 4;

  /// Checks all ranges.
  void check() const
  {
    CGAL_precondition(flattest > 1);
    CGAL_precondition(least_share > 0 && least_share < 1);
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
