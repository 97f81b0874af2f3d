// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_SURFACE_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_SURFACE_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/Box_tree.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch_groups.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Surface_options.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Visible_surface.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Winding_number.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/contract_patches.h>
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
  Gaussians gaussians; ///< Of the patches.
  Box_tree tree;       ///< Over the patches.
  std::vector<double> confidence; ///< Of the orientation of each patch, in [0, 1].
  Winding_number winding_number;
  Visible_surface visible;

  // The components of the mixture that the patches are made of.
  std::vector<Vector3> components; ///< Their positions.
  Box_tree component_tree;         ///< Over these.
  Patch_groups groups;             ///< The components of each patch.
  bool is_of_lines = false;        ///< See `is_cloud_of_lines()`.
};

/// Part 2b: returns the oriented surface of a mixture. `component_tree` is over its means, `fine`
/// are the patches of its components, from `estimate_patches()`; those of a group become one patch.
/// O(n log n). \pre there is a component, and no group is empty
inline Surface build_surface(const Gaussians& components, const Box_tree& component_tree,
                             const Patches& fine, Patch_groups groups, bool is_of_lines,
                             const Surface_options& options, Concurrency concurrency)
{
  options.check();
  Gaussians gaussians = contracted(components, groups, concurrency);
  const Box_tree tree(means_of(gaussians), concurrency);
  Patches patches = contracted(fine, gaussians, groups, options, concurrency);
  orient_patches(patches, concurrency);
  Winding_number winding_number = settle_orientation(patches, tree, options, concurrency);
  std::vector<double> confidence = orientation_confidence(patches, concurrency);
  part_facing_patches(patches, confidence, options, concurrency);
  Visible_surface visible(patches, confidence, tree);
  return {options,
          std::move(patches),
          std::move(gaussians),
          tree,
          std::move(confidence),
          std::move(winding_number),
          std::move(visible),
          means_of(components),
          component_tree,
          std::move(groups),
          is_of_lines};
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_SURFACE_H
