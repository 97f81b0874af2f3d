// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_CURVE_OPTIONS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_CURVE_OPTIONS_H

#include <CGAL/assertions.h>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Options of parts 3c and 3d: pruning and fitting the curve.
struct Curve_options
{
  /// Share of the points of the largest component, in [0, 1), below which a component is dropped as
  /// a cluster of outliers, unless it is a fragment.
  double stray_share = 0.01;

  /// Share of the points of another component, in [0, 1], up to which a single limb may be a
  /// fragment of it; what has more is the next one of a row of posts. What branches must have fewer,
  /// by its length in lengths of its longest path: it may be a shape of its own, as the next tree.
  double fragment_share = 0.3;

  /// Greatest gap between a fragment and what it is a piece of, > 0, in lengths of the longest path
  /// in the fragment: of plants scanned from one place 68 % are in one piece with 1, 82 % with 2.
  double fragment_gap = 2;

  /// Least mean evidence along a loop or a fragment, in [0, 1], see `Limb_evidence`; loops with
  /// less are opened. 0.6 and more where limbs are resolved, 0.3 to 0.5 in crowns in leaf.
  double limb_evidence = 0.5;

  /// Least slenderness of a branch, >= 0: its length beyond a cross-section, or a ring around its
  /// root, over half the width of that. 1 for a dome and the corner of a plate, 1.7 for a cone of 60
  /// degrees, 3 and more for a finger or toe.
  double slenderness = 1.25;

  /// Least number of surface points of a branch, a ring around a limb; fewer are outliers that
  /// stick out or bridge the gap between two limbs.
  double least_points = 6;

  /// Radii; widest gap between points that is bridged along a limb: twice its thickness. >= 0.
  double widest_gap = 4;

  /// Resolutions; limbs of smaller radius have no reliable radius, and count as this thick. >= 0.
  double thin_limb = 2;

  /// Resolutions; widest gap between points that is bridged in any direction, as limbs so thin have
  /// no reliable one: on a surface, points are not further apart. >= 0.
  double thin_gap = 3;

  /// Least cosine between the direction of a tip and the gap, in (0, 1]: 37 degrees, which limbs
  /// bend by at most.
  double aligned = 0.8;

  /// Radii; distance of the vertices of the result where the surface is known finely enough, > 0,
  /// and half the thickness of the slab whose points are the cross-section at one.
  double step = 0.3;

  /// Radii; centring halves waves of 2 pi times this length and removes shorter ones, >= 0. Limbs
  /// do not undulate within their own width.
  double stiffness = 0.4;

  /// Checks all ranges.
  void check() const
  {
    CGAL_precondition(stray_share >= 0 && stray_share < 1);
    CGAL_precondition(fragment_share >= 0 && fragment_share <= 1 && fragment_gap > 0);
    CGAL_precondition(limb_evidence >= 0 && limb_evidence <= 1);
    CGAL_precondition(slenderness >= 0 && least_points >= 0);
    CGAL_precondition(widest_gap >= 0 && thin_limb >= 0 && thin_gap >= 0);
    CGAL_precondition(aligned > 0 && aligned <= 1);
    CGAL_precondition(step > 0 && stiffness >= 0);
  }

  /// Calls `visit(name, value)` for every option.
  template <typename Visit>
  void visit(const Visit& visit)
  {
    visit("stray_share", stray_share);
    visit("fragment_share", fragment_share);
    visit("fragment_gap", fragment_gap);
    visit("limb_evidence", limb_evidence);
    visit("slenderness", slenderness);
    visit("least_points", least_points);
    visit("widest_gap", widest_gap);
    visit("thin_limb", thin_limb);
    visit("thin_gap", thin_gap);
    visit("aligned", aligned);
    visit("step", step);
    visit("stiffness", stiffness);
  }
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_CURVE_OPTIONS_H
