// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_SQUARED_DISTANCE_TO_SEGMENT_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_SQUARED_DISTANCE_TO_SEGMENT_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>

#include <algorithm>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Squared distance of a place from the segment between two points, which may coincide.
inline double squared_distance_to_segment(const Vector3& place, const Vector3& from,
                                          const Vector3& to)
{
  const Vector3 along = to - from, offset = place - from;
  const double squared_length = along.squaredNorm();
  const double t =
    squared_length > 0 ? std::clamp(along.dot(offset) / squared_length, 0.0, 1.0) : 0;
  return (offset - t * along).squaredNorm();
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_SQUARED_DISTANCE_TO_SEGMENT_H
