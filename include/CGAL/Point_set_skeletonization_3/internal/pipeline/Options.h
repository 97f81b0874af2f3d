// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PIPELINE_OPTIONS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PIPELINE_OPTIONS_H

#include <CGAL/Point_set_skeletonization_3/internal/consolidation/scene_objects.h>
#include <CGAL/Point_set_skeletonization_3/internal/mixture/Grid_mixture.h>
#include <CGAL/Point_set_skeletonization_3/internal/pipeline/link_samples.h>
#include <CGAL/Point_set_skeletonization_3/internal/pipeline/medial_surface.h>

#include <limits>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// The options of all stages; all have defaults.
struct Options
{
  Grid_options mixture;
  Scene_options scene;
  Medial_surface_options medial;
  Linking_options linking;

  /// What is an object; all is if it is known to be in one piece.
  Scene_options scene_options() const
  {
    Scene_options result = scene;
    result.isolated = medial.consolidation.isolated;
    result.stray_share = linking.curve.stray_share;
    if(linking.known.single_component)
      result.apart = std::numeric_limits<double>::infinity();
    return result;
  }

  /// Calls `visit(name, value)` for each numeric option, for `quality sweep`.
  template <typename Visit>
  void visit(const Visit& visit)
  {
    visit("points_per_cell", mixture.points_per_cell);
    scene.visit(visit);
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
