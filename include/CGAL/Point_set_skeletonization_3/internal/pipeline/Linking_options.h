// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PIPELINE_LINKING_OPTIONS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PIPELINE_LINKING_OPTIONS_H

#include <CGAL/Point_set_skeletonization_3/internal/curve/Curve_options.h>
#include <CGAL/Point_set_skeletonization_3/internal/pipeline/Known_topology.h>
#include <CGAL/Point_set_skeletonization_3/internal/separators/Separator_options.h>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Options of stage 3.
struct Linking_options
{
  Separator_options separators;
  Curve_options curve;

  Known_topology known;

  /// Checks all ranges.
  void check() const
  {
    separators.check();
    curve.check();
  }
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PIPELINE_LINKING_OPTIONS_H
