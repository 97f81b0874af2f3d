// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_SURFACE_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_SURFACE_H

#include <CGAL/Point_set_skeletonization_3/internal/spatial/Box_tree.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Visible_surface.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/patches.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/orient_patches.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Winding_number.h>

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// The patches of a mixture level with all that the projection and the linking ask them.
template <typename ConcurrencyTag>
class Surface
{
public:
  /// With the tree over the means.
  Surface(const Gaussians& gaussians, const Box_tree& over_means)
    : Surface(gaussians, over_means, patch_neighborhoods<ConcurrencyTag>(over_means))
  {}

  /// Where the neighbourhoods are known, too.
  Surface(const Gaussians& gaussians, Box_tree over_means, const K_nearest_neighbors& nearest)
    : patches(surface_patches<ConcurrencyTag>(gaussians, nearest)), spacing(median_spacing(patches)),
      tree(std::move(over_means))
  {
    orient_patches<ConcurrencyTag>(patches);
    winding_number = settle_orientation<ConcurrencyTag>(patches, tree);
    confidence = orientation_confidence<ConcurrencyTag>(patches);
    part_facing_patches<ConcurrencyTag>(patches, confidence);
    visible = std::make_unique<Visible_surface>(patches, confidence, tree);
  }

  // Its parts refer to each other.
  Surface(const Surface&) = delete;
  Surface& operator=(const Surface&) = delete;

  std::vector<Patch> patches;
  double spacing;
  Box_tree tree; ///< Over the patches.
  std::vector<double> confidence;
  std::unique_ptr<Winding_number> winding_number;
  std::unique_ptr<Visible_surface> visible;
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_SURFACE_H
