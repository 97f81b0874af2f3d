// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PIPELINE_LINKING_OPTIONS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PIPELINE_LINKING_OPTIONS_H

#include <CGAL/Point_set_skeletonization_3/internal/curve/Curve_options.h>
#include <CGAL/Point_set_skeletonization_3/internal/pipeline/Known_topology.h>
#include <CGAL/Point_set_skeletonization_3/internal/separators/Separator_options.h>

#include <CGAL/assertions.h>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Options of stage 3.
struct Linking_options
{
  Separator_options separators;
  Curve_options curve;

  /// Share of the length of open limbs that is on no loop in the reading as a frame, in (0, 1):
  /// with less, it is a frame. Wire frames leave up to 0.16 where gaps are not bridged, sparse
  /// trees of a few hundred points 0.21 and more, crowns in leaf 0.25, scanned trees 0.28, plants
  /// 0.47. See `loose_open_share()`, and `is_frame()` for strips that are resolved.
  double loose_share = 0.2;

  /// Strength of the noise, in (0, 1), above which it spoils how coplanar patches are.
  double much_noise = 0.5;

  Known_topology known;

  /// Checks all ranges.
  void check() const
  {
    separators.check();
    curve.check();
    CGAL_precondition(loose_share > 0 && loose_share < 1);
    CGAL_precondition(much_noise > 0 && much_noise < 1);
  }

  /// Calls `visit(name, value)` for every option.
  template <typename Visit>
  void visit(const Visit& visit)
  {
    separators.visit(visit);
    curve.visit(visit);
    visit("loose_share", loose_share);
    visit("much_noise", much_noise);
  }
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PIPELINE_LINKING_OPTIONS_H
