// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PIPELINE_MEDIAL_SURFACE_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PIPELINE_MEDIAL_SURFACE_H

#include <CGAL/Point_set_skeletonization_3/internal/consolidation/Neighborhood.h>
#include <CGAL/Point_set_skeletonization_3/internal/consolidation/consolidate.h>
#include <CGAL/Point_set_skeletonization_3/internal/consolidation/merge_rows.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Progress.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/medial/medial_samples.h>
#include <CGAL/Point_set_skeletonization_3/internal/medial/span_holes.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/K_nearest_neighbors.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch_groups.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Surface.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/contract_patches.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/estimate_patches.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/flat_groups.h>

#include <utility>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// A denoised surface, and a medial sample for each patch.
struct Medial_surface
{
  Consolidated_mixture consolidated;
  Surface surface;
  Samples samples;
};

/// Options of stage 2.
struct Medial_surface_options
{
  Consolidation_options consolidation;
  Surface_options surface;
  Medial_options samples;
};

/// Part 2b: returns the surface of a consolidated mixture, whose neighbours are forgotten on the
/// way: here memory is greatest. O(n log n). \pre there is a component
inline Surface surface_of(Consolidated_mixture& consolidated, const Surface_options& options,
                          Concurrency concurrency)
{
  const Gaussians& components = consolidated.components;
  const Patches fine = estimate_patches(components, consolidated.neighbors, options, concurrency);
  const Patch_groups flat = // a few twigs close to each other are flat, but no surface
    consolidated.is_of_lines
      ? Patch_groups(components.size())
      : flat_groups(components, consolidated.tree, fine, consolidated.cell_size, options,
                    concurrency);
  consolidated.neighbors = K_nearest_neighbors();
  return build_surface(components, consolidated.tree, fine,
                       connected_groups(flat, fine), consolidated.is_of_lines, options,
                       concurrency);
}

/// Parts 2a to 2d: returns the denoised surface of mixture components and its medial samples.
/// `cell_size` is the edge length of the grid cells of the components, 0 without a grid.
/// O(n log n). \pre there is a component
inline Medial_surface medial_surface(const Gaussians& components, Neighborhood neighborhood,
                                     double cell_size, const Medial_surface_options& options,
                                     Concurrency concurrency, const Progress& progress)
{
  Consolidated_mixture consolidated =
    with_rows_merged(consolidate(components, std::move(neighborhood), cell_size,
                                 options.consolidation, concurrency),
                     options.surface.flatness, concurrency);
  progress(0.4);
  Surface surface = surface_of(consolidated, options.surface, concurrency);
  progress(0.7);
  Samples samples = medial_samples(surface, options.samples, concurrency);
  span_holes(surface, samples, options.samples, concurrency);
  progress(1);
  return {std::move(consolidated), std::move(surface), std::move(samples)};
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PIPELINE_MEDIAL_SURFACE_H
