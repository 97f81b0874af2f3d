// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PIPELINE_OPTIONS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PIPELINE_OPTIONS_H

#include <CGAL/Point_set_skeletonization_3/internal/mixture/Grid_mixture.h>
#include <CGAL/Point_set_skeletonization_3/internal/pipeline/link_samples.h>
#include <CGAL/Point_set_skeletonization_3/internal/pipeline/medial_surface.h>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// The options of all stages; all have defaults.
struct Options
{
  Grid_options mixture;
  Medial_surface_options medial;
  Linking_options linking;

  /// Calls `visit(name, value)` for each numeric option, for `quality sweep`.
  template <typename Visit>
  void visit(const Visit& visit)
  {
    visit("points_per_cell", mixture.points_per_cell);
    medial.consolidation.visit(visit);
    medial.surface.visit(visit);
    medial.samples.visit(visit);
    linking.visit(visit);
  }
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PIPELINE_OPTIONS_H
