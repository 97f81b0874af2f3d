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
/// to them times their weights, which is robust against outliers: ten of Weiszfeld's iterations
/// from their mean. Distances count as at least `closest`, or a single point would take all the
/// weight. O(points).
/// \pre there is a weight for each point, none is negative, and one is positive; so is `closest`
template <typename Point>
Point l1_median(const std::vector<Point>& points, const std::vector<double>& weights,
                double closest)
{
  Point result = Point::Zero();
  double total = 0;
  for(std::size_t k = 0; k < points.size(); ++k) {
    result += weights[k] * points[k];
    total += weights[k];
  }
  result /= total;
  constexpr int iterations = 10; // it converges linearly, and a tenth of a radius is enough
  for(int iteration = 0; iteration < iterations; ++iteration) {
    Point sum = Point::Zero();
    double attraction = 0;
    for(std::size_t k = 0; k < points.size(); ++k) {
      const double distance = (std::max)((points[k] - result).norm(), closest);
      sum += weights[k] * (points[k] - result) / distance;
      attraction += weights[k] / distance;
    }
    result += sum / attraction;
  }
  return result;
}

/// The same with equal weights. \pre there is a point, and `closest` is positive
template <typename Point>
Point l1_median(const std::vector<Point>& points, double closest)
{
  return l1_median(points, std::vector<double>(points.size(), 1), closest);
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_L1_MEDIAN_H
