// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_TRUNK_CURVES_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_TRUNK_CURVES_H

#include "Mean_and_maximum.h"
#include "Segment_tree.h"
#include "robust_circle.h"
#include "skeleton_edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace metrics {

/// The curves of a skeleton in the trunk of a tree, at three heights.
struct Trunk_curves
{
  std::size_t single = 0; ///< At how many of them exactly one curve is in the trunk.
  double off = 0; ///< How far the nearest curve is from the axis of the trunk, in its radii: the
                  ///< mean of these heights; NaN if there is none.
};

namespace internal {

/// Heights of points above the lowest of some, in units of the height of all, and where the points
/// are on the ground.
class Elevation
{
public:
  /// \param points not all at one height
  Elevation(const std::vector<Point>& points, const Vector& up)
      : up_(up)
      , ground_(CGAL::ORIGIN, up)
      , lowest_(along(points.front()))
      , highest_(lowest_)
  {
    for(const Point& p : points) {
      lowest_ = std::min(lowest_, along(p));
      highest_ = std::max(highest_, along(p));
    }
  }

  double height(const Point& p) const { return (along(p) - lowest_) / (highest_ - lowest_); }

  Eigen::Vector2d foot(const Point& p) const
  {
    const Vector u = unit(ground_.base1()), v = unit(ground_.base2()), offset = p - CGAL::ORIGIN;
    return {u * offset, v * offset};
  }

private:
  double along(const Point& p) const { return up_ * (p - CGAL::ORIGIN); }
  static Vector unit(const Vector& v) { return v / std::sqrt(v.squared_length()); }

  Vector up_;
  Kernel::Plane_3 ground_;
  double lowest_, highest_;
};

/// How far each edge of a skeleton that passes a height is from the axis of the trunk there, in its
/// radii. The trunk is the circle that most points at this height are near.
inline std::vector<double> curves_at(double height, const std::vector<Segment>& edges,
                                     const std::vector<Point>& points, const Elevation& elevation)
{
  constexpr double thickness = 0.01; // half of the distance between the heights that are asked
  std::vector<Eigen::Vector2d> section;
  for(const Point& p : points)
    if(std::abs(elevation.height(p) - height) <= thickness)
      section.push_back(elevation.foot(p));
  if(section.empty())
    return {};
  const Circle trunk = robust_circle(section);
  std::vector<double> result;
  for(const Segment& edge : edges) {
    const double a = elevation.height(edge.source()), b = elevation.height(edge.target());
    if((a < height) != (b < height)) {
      const Point crossing = edge.source() + (height - a) / (b - a) * edge.to_vector();
      result.push_back((elevation.foot(crossing) - trunk.center).norm() / trunk.radius);
    }
  }
  return result;
}

} // namespace internal

/// The curves in a trunk at 5, 7 and 9 % of the height of a tree.
///
/// \param skeleton a BGL graph whose vertices bundle a `.point`
/// \param cloud a range of points that are not all at one height
/// \param up where the tree grows to; of any length > 0
template <typename Skeleton, typename PointRange>
Trunk_curves trunk_curves(const Skeleton& skeleton, const PointRange& cloud, const Vector& up)
{
  constexpr std::array<double, 3> heights = {0.05, 0.07, 0.09}; // below the lowest limbs
  std::vector<Point> points;
  for(const auto& p : cloud)
    points.push_back(to_point(p));
  const internal::Elevation elevation(points, up);
  const std::vector<Segment> edges = edge_segments(skeleton);
  Trunk_curves result;
  Mean_and_maximum off;
  for(double height : heights) {
    const std::vector<double> curves = internal::curves_at(height, edges, points, elevation);
    const auto in_trunk = std::count_if(curves.begin(), curves.end(),
                                        [](double distance) { return distance < 1; });
    result.single += in_trunk == 1 ? 1 : 0;
    if(!curves.empty())
      off.add(*std::min_element(curves.begin(), curves.end()), 1);
  }
  result.off = off.mean();
  return result;
}

} // namespace metrics

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_TRUNK_CURVES_H
