// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_DIMENSIONALITY_AROUND_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_DIMENSIONALITY_AROUND_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Dimensionality.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/Box_tree.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/components_within.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch.h>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Spacings: about 30 patches of a sheet, 6 of a line.
constexpr double spacings_around = 3;

/// Returns what the cloud around a patch is like. O(log n + components around).
inline Dimensionality dimensionality_around(const Patch& patch, const Box_tree& components)
{
  const Spread_components around =
    components_within(components, patch.mean, spacings_around * patch.spacing);
  return dimensionality(around.covariance, around.number);
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_DIMENSIONALITY_AROUND_H
