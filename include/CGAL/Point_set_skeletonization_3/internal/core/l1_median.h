// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_L1_MEDIAN_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_L1_MEDIAN_H

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Returns the L1-median of some points (Eigen vectors), the place with the least sum of distances
/// to them, which is robust against outliers: ten of Weiszfeld's iterations from their mean.
/// Distances count as at least `closest`, or a single point would take all the weight. O(points).
/// \pre there is a point, and `closest` is positive
template <typename Point>
Point l1_median(const std::vector<Point>& points, double closest)
{
  Point result = Point::Zero();
  for(const Point& point : points)
    result += point / static_cast<double>(points.size());
  constexpr int iterations = 10; // it converges linearly, and a tenth of a radius is enough
  for(int iteration = 0; iteration < iterations; ++iteration) {
    Point sum = Point::Zero();
    double attraction = 0;
    for(const Point& point : points) {
      const double distance = (std::max)((point - result).norm(), closest);
      sum += (point - result) / distance;
      attraction += 1 / distance;
    }
    result += sum / attraction;
  }
  return result;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_L1_MEDIAN_H
