// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_COMPONENT_GAPS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_COMPONENT_GAPS_H

#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/quantile.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/K_nearest_neighbors.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Surface.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// How far patches are apart, between the components that they are made of. A leaf in a crown may
/// be one patch, which is not further from the next one than patches are there, and yet be by
/// itself: its components are much closer to each other.
class Component_gaps
{
public:
  /// Refers to the surface. O(n log n).
  Component_gaps(const Surface& surface, Concurrency concurrency)
    : surface_(surface), grain_(surface.patches.size())
  {
    constexpr std::size_t on_a_line = 2; // neighbours, one on either side
    const K_nearest_neighbors nearest =
      k_nearest_neighbors(surface.component_tree, on_a_line + 1, concurrency);
    const auto last = static_cast<std::ptrdiff_t>(nearest.k() - 1);
    parallel_for(concurrency, grain_.size(), [&](std::size_t i) {
      std::vector<double> distances;
      for(std::size_t k : surface.groups[i])
        distances.push_back(std::sqrt(nearest[k][last].squared_distance));
      grain_[i] = quantile(std::move(distances), 0.5);
    });
  }

  /// Returns the least distance between components of two patches. O(components of the one, times
  /// those of the other).
  double between(std::size_t i, std::size_t j) const
  {
    double least = std::numeric_limits<double>::infinity();
    for(std::size_t a : surface_.groups[i])
      for(std::size_t b : surface_.groups[j])
        least = (std::min)(least, (surface_.components[a] - surface_.components[b]).squaredNorm());
    return std::sqrt(least);
  }

  /// Returns how far components next to each other are apart in two patches, > 0.
  double grain(std::size_t i, std::size_t j) const
  {
    return (std::max)(least_spacing, (grain_[i] + grain_[j]) / 2);
  }

private:
  const Surface& surface_;
  std::vector<double> grain_; ///< Of each patch.
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_COMPONENT_GAPS_H
