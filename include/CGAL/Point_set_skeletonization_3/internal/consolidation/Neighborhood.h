// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CONSOLIDATION_NEIGHBORHOOD_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CONSOLIDATION_NEIGHBORHOOD_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/Box_tree.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/K_nearest_neighbors.h>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Where the components of a mixture are, and the neighbours of each, first itself.
struct Neighborhood
{
  Box_tree tree; ///< Over the means.
  K_nearest_neighbors nearest;

  Neighborhood() = default;

  /// O(n log n).
  Neighborhood(const Gaussians& mixture, Concurrency concurrency)
    : tree(means_of(mixture), concurrency),
      nearest(k_nearest_neighbors(tree, surface_neighbors + 1, concurrency))
  {}
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CONSOLIDATION_NEIGHBORHOOD_H
