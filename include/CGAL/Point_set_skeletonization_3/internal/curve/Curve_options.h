// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_CURVE_OPTIONS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_CURVE_OPTIONS_H

#include <CGAL/assertions.h>
#include <CGAL/number_utils.h>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// What a limb is, and how the curve through it is drawn.
struct Curve_options
{
  /// Share of the points of the largest component below which a component is a cluster of outliers: a
  /// part of the shape that small has no skeleton to speak of.
  double stray_share = 0.01;

  /// A limb is this much longer than half the width of one of its cross-sections. The corner of a plate
  /// and a dome are 1, a cone of 60 degrees is 1.7; a finger or toe 3 and more.
  double slenderness = 1.25;

  /// Patches that a limb shows, a ring around it; fewer are outliers that stick out, or that bridge the
  /// gap between two limbs.
  double least_patches = 6;

  /// Radii of a gap that is bridged, along a limb: the eye bridges one that is twice as long as the limb
  /// is thick.
  double widest_gap = 4;

  /// Spacings; of a limb with a smaller radius neither that nor the direction is known, and it counts as
  /// that thick for a gap in any direction.
  double thin_limb = 2;

  /// Cosine between the direction of a tip and the gap that it is bridged over: limbs bend by less than
  /// 37 degrees.
  double aligned = 0.8;

  /// Radii: half of the length of a limb that the points of one cross-section are taken from.
  double half_width = 0.25;

  /// Radii: waves of 2 pi times that length are halved when a curve is centred, shorter ones vanish. A
  /// limb does not wind within less than its own width.
  double stiffness = 0.4;

  /// Radians of a cross-section without points, from which on its centre is a guess: half of it.
  double unknown = CGAL_PI;

  void check() const
  {
    CGAL_precondition(stray_share >= 0 && stray_share < 1);
    CGAL_precondition(slenderness >= 0 && least_patches >= 0);
    CGAL_precondition(widest_gap >= 0 && thin_limb >= 0 && aligned > 0 && aligned <= 1);
    CGAL_precondition(half_width > 0 && stiffness >= 0 && unknown > 0);
  }

  /// Calls `visit(name, value)` for every option.
  template <typename Visit>
  void visit(const Visit& visit)
  {
    visit("stray_share", stray_share);
    visit("slenderness", slenderness);
    visit("least_patches", least_patches);
    visit("widest_gap", widest_gap);
    visit("thin_limb", thin_limb);
    visit("aligned", aligned);
    visit("half_width", half_width);
    visit("stiffness", stiffness);
    visit("unknown", unknown);
  }
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_CURVE_OPTIONS_H
