// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SPATIAL_COMPONENTS_WITHIN_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SPATIAL_COMPONENTS_WITHIN_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/Box_tree.h>

#include <cstddef>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Some mixture components.
struct Spread_components
{
  double number = 0;
  Matrix3 covariance = Matrix3::Zero(); ///< Of their positions; each counts as much.
};

/// Returns the components within a distance of a place. They are equally fine everywhere, while
/// patches are large where the surface is flat. O(log n + components found).
/// \param components over their means
inline Spread_components components_within(const Box_tree& components, const Vector3& place,
                                           double distance)
{
  Vector3 sum = Vector3::Zero();
  Spread_components result;
  components.visit_within(place, distance, [&](std::size_t k, double) {
    const Vector3 offset = components.positions()[k] - place;
    sum += offset;
    result.covariance += offset * offset.transpose();
    ++result.number;
  });
  if(result.number > 0) {
    result.covariance /= result.number;
    result.covariance -= sum * sum.transpose() / (result.number * result.number);
  }
  return result;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SPATIAL_COMPONENTS_WITHIN_H
