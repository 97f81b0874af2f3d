// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_SURFACE_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_SURFACE_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/Box_tree.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/K_nearest_neighbors.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Surface_options.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Visible_surface.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Winding_number.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/estimate_patches.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/orient_patches.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/settle_orientation.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// An oriented surface of patches, with the structures for queries of later parts.
struct Surface
{
  Surface_options options;
  Patches patches;
  double spacing; ///< Median over the patches.
  Box_tree tree;  ///< Over the patches.
  std::vector<double> confidence; ///< Of the orientation of each patch, in [0, 1].
  Winding_number winding_number;
  Visible_surface visible;
};

/// Part 2b: returns the oriented surface of Gaussians. `tree` is over their means; `nearest` are
/// the `surface_neighbors` of each, itself first. O(n log n).
/// \pre there is a Gaussian
inline Surface build_surface(const Gaussians& gaussians, const Box_tree& tree,
                             const K_nearest_neighbors& nearest, const Surface_options& options,
                             Concurrency concurrency)
{
  options.check();
  Patches patches = estimate_patches(gaussians, nearest, options, concurrency);
  const double spacing = median_spacing(patches);
  orient_patches(patches, concurrency);
  Winding_number winding_number = settle_orientation(patches, tree, options, concurrency);
  std::vector<double> confidence = orientation_confidence(patches, concurrency);
  part_facing_patches(patches, confidence, options, concurrency);
  Visible_surface visible(patches, confidence, tree);
  return {options, std::move(patches),        spacing,           tree, std::move(confidence),
          std::move(winding_number), std::move(visible)};
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_SURFACE_H
