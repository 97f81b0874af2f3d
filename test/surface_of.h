// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_TEST_SURFACE_OF_H
#define POINT_SET_SKELETONIZATION_3_TEST_SURFACE_OF_H

#include "analytic_surfaces.h"

#include <CGAL/Point_set_skeletonization_3/internal/surface/Surface.h>

#include <vector>

namespace surfaces {

/// A surface of patches that are oriented already, without a doubt.
inline CGAL::Point_set_skeletonization_3::internal::Surface surface_of(const Patches& patches)
{
  namespace internal = CGAL::Point_set_skeletonization_3::internal;
  const Box_tree tree = tree_of(patches);
  const std::vector<double> confidence(patches.size(), 1);
  internal::Gaussians gaussians;
  std::vector<internal::Vector3> means;
  for(const Patch& patch : patches) {
    gaussians.push_back({patch.weight, patch.mean, internal::Matrix3::Zero()});
    means.push_back(patch.mean);
  }
  return {internal::Surface_options(),
          patches,
          gaussians,
          tree,
          confidence,
          internal::Winding_number(patches, tree, internal::Concurrency::sequential),
          internal::Visible_surface(patches, confidence, tree),
          means,
          tree,
          internal::Patch_groups(patches.size())};
}

} // namespace surfaces

#endif // POINT_SET_SKELETONIZATION_3_TEST_SURFACE_OF_H
