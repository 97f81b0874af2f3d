// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SPATIAL_NEIGHBOR_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SPATIAL_NEIGHBOR_H

#include <cstddef>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Index and squared distance of a neighbour.
struct Neighbor
{
  double squared_distance;
  std::size_t index;

  /// By distance, then by index: an order independent of the search structure.
  bool operator<(const Neighbor& other) const
  {
    return squared_distance != other.squared_distance ? squared_distance < other.squared_distance
                                                      : index < other.index;
  }
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SPATIAL_NEIGHBOR_H
