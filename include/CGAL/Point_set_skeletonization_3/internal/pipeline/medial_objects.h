// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PIPELINE_MEDIAL_OBJECTS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PIPELINE_MEDIAL_OBJECTS_H

#include <CGAL/Point_set_skeletonization_3/internal/consolidation/Neighborhood.h>
#include <CGAL/Point_set_skeletonization_3/internal/consolidation/consolidate.h>
#include <CGAL/Point_set_skeletonization_3/internal/consolidation/scene_objects.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Progress.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/pipeline/medial_surface.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// An object of a scene: some components of a mixture, and their surface.
struct Medial_object
{
  static constexpr std::size_t none = Consolidated_mixture::none;

  std::vector<std::size_t> components; ///< Of the mixture, ascending.
  Medial_surface medial;

  /// The patch of the `k`-th of its components; `none` for an outlier.
  std::size_t patch_of(std::size_t k) const
  {
    const std::size_t component = medial.consolidated.merged_into[k];
    return component == none ? none : medial.surface.groups.group_of()[component];
  }
};

/// Stage 2: returns the objects of a scene, each with its medial samples. `cell_size` is the edge
/// length of the grid cells of the components, 0 without a grid. O(n log n).
/// \pre there is a component
inline std::vector<Medial_object> medial_objects(const Gaussians& mixture, double cell_size,
                                                 const Scene_options& scene,
                                                 const Medial_surface_options& options,
                                                 Concurrency concurrency,
                                                 const Progress& progress)
{
  Neighborhood neighborhood(mixture, concurrency);
  std::vector<std::vector<std::size_t>> objects =
    scene_objects(mixture, neighborhood.nearest, scene, concurrency);
  std::vector<Medial_object> result;
  if(objects.size() == 1) {
    result.push_back({std::move(objects.front()),
                      medial_surface(mixture, std::move(neighborhood), cell_size, options,
                                     concurrency, progress)});
    return result;
  }
  neighborhood = Neighborhood();
  std::size_t done = 0;
  const auto share = [&] { return static_cast<double>(done) / static_cast<double>(mixture.size()); };
  for(std::vector<std::size_t>& object : objects) {
    Gaussians components;
    for(std::size_t i : object)
      components.push_back(mixture[i]);
    const double begin = share();
    done += object.size();
    result.push_back({std::move(object),
                      medial_surface(components, Neighborhood(components, concurrency), cell_size,
                                     options, concurrency, progress.part(begin, share()))});
  }
  return result;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PIPELINE_MEDIAL_OBJECTS_H
