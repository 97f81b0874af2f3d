// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_TRUNK_CURVES_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_TRUNK_CURVES_H

#include "Segment_tree.h"
#include "skeleton_edges.h"

#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/convex_hull_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <vector>

namespace metrics {
namespace internal {

/// Seen along `up`: heights of points above the lowest, in units of the height of all, and where
/// they are on the ground.
class Elevation
{
public:
  /// \param points not empty, not all at one height
  Elevation(const std::vector<Point>& points, const Vector& up)
      : up_(up)
      , plane_(CGAL::ORIGIN, up)
      , lowest_(up * (points.front() - CGAL::ORIGIN))
      , highest_(lowest_)
  {
    for(const Point& p : points) {
      const double along = up * (p - CGAL::ORIGIN);
      lowest_ = std::min(lowest_, along);
      highest_ = std::max(highest_, along);
    }
  }

  double height(const Point& p) const
  {
    return (up_ * (p - CGAL::ORIGIN) - lowest_) / (highest_ - lowest_);
  }
  Kernel::Point_2 foot(const Point& p) const { return plane_.to_2d(p); }

private:
  Vector up_;
  Kernel::Plane_3 plane_;
  double lowest_, highest_;
};

/// Whether exactly one edge of a skeleton passes the height, and does so among the points there.
inline bool has_one_curve_at(double height, const std::vector<Segment>& edges,
                             const std::vector<Point>& points, const Elevation& elevation)
{
  constexpr double thickness = 0.01; // half of the distance between the heights that are asked
  std::vector<Kernel::Point_2> crossings;
  for(const Segment& edge : edges) {
    const double a = elevation.height(edge.source()), b = elevation.height(edge.target());
    if((a < height) != (b < height))
      crossings.push_back(
          elevation.foot(edge.source() + (height - a) / (b - a) * edge.to_vector()));
  }
  if(crossings.size() != 1)
    return false;
  std::vector<Kernel::Point_2> section, hull;
  for(const Point& p : points)
    if(std::abs(elevation.height(p) - height) <= thickness)
      section.push_back(elevation.foot(p));
  CGAL::convex_hull_2(section.begin(), section.end(), std::back_inserter(hull));
  return hull.size() >= 3 &&
         CGAL::bounded_side_2(hull.begin(), hull.end(), crossings.front(), Kernel()) !=
             CGAL::ON_UNBOUNDED_SIDE;
}

} // namespace internal

/// At how many of three heights, 5, 7 and 9 % of a tree's, exactly one curve of its skeleton is in
/// its trunk: no other passes there, and points are around it.
///
/// \param skeleton a BGL graph whose vertices bundle a `.point`
/// \param cloud a range of points that are not all at one height
/// \param up where the tree grows to; of any length > 0
template <typename Skeleton, typename PointRange>
std::size_t trunk_curves(const Skeleton& skeleton, const PointRange& cloud, const Vector& up)
{
  constexpr std::array<double, 3> heights = {0.05, 0.07, 0.09}; // below the lowest limbs
  std::vector<Point> points;
  for(const auto& p : cloud)
    points.push_back(to_point(p));
  const internal::Elevation elevation(points, up);
  const std::vector<Segment> edges = edge_segments(skeleton);
  return static_cast<std::size_t>(
      std::count_if(heights.begin(), heights.end(), [&](double height) {
        return internal::has_one_curve_at(height, edges, points, elevation);
      }));
}

} // namespace metrics

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_TRUNK_CURVES_H
