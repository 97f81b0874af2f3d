// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_LINE_COMPONENTS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_LINE_COMPONENTS_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Dimensionality.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Moments.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/K_nearest_neighbors.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Whether the means of a component and its nearest neighbours are like a line. O(neighbours).
inline bool is_like_line(std::size_t i, const Gaussians& components,
                         const K_nearest_neighbors& nearest)
{
  Moments moments; // about the mean of the component
  for(const Neighbor& near : nearest[i])
    moments.add(1, components[near.index].mean - components[i].mean);
  return dimensionality(moments.gaussian(Vector3::Zero()).covariance, moments.weight()).kind() ==
         Medial_sample_kind::line;
}

/// Marks the components on twigs, wires and other lines: around most of their nearest neighbours,
/// and themselves, the cloud is like a line. Around one alone it is by chance. O(n).
/// \param nearest of the components, each first itself
inline std::vector<char> line_components(const Gaussians& components,
                                         const K_nearest_neighbors& nearest,
                                         Concurrency concurrency)
{
  std::vector<char> is_like(components.size()), result(components.size()); // threads write to them
  parallel_for(concurrency, components.size(), [&](std::size_t i) {
    is_like[i] = is_like_line(i, components, nearest);
  });
  parallel_for(concurrency, components.size(), [&](std::size_t i) {
    std::size_t lines = 0;
    for(const Neighbor& near : nearest[i])
      lines += is_like[near.index] ? 1 : 0;
    result[i] = 2 * lines > nearest.k();
  });
  return result;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_LINE_COMPONENTS_H
