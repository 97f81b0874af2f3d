// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_AXIS_DISTANCE_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_AXIS_DISTANCE_H

#include "Mean_and_maximum.h"
#include "Segment_tree.h"
#include "skeleton_samples.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <vector>

namespace metrics {

/// How far a skeleton is from the true axis of a shape, in local radii; NaN if all of it is at
/// junctions.
struct Axis_distance
{
  double mean;    ///< over the length of the skeleton
  double maximum; ///< over the samples
  double centred; ///< share of the length that is within half a radius
};

namespace internal {

/// Radii around a true junction within which the axis is a matter of taste.
constexpr double junction_reach = 1.5;

/// Radii; what is no further off is nearer to the axis than to the surface.
constexpr double centred_within = 0.5;

/// Samples in the smallest radius of the shape.
constexpr double samples_per_radius = 4;

template <typename Junctions>
bool is_at_junction(const Point& p, const Junctions& junctions)
{
  for(const auto& junction : junctions) {
    const double reach = junction_reach * junction.radius;
    if(CGAL::squared_distance(p, to_point(junction.position)) <= reach * reach)
      return true;
  }
  return false;
}

/// How many segments of the axis end at a point.
template <typename Axis>
std::map<Point, int> axis_degrees(const Axis& axis)
{
  std::map<Point, int> degrees;
  for(const auto& piece : axis) {
    ++degrees[to_point(piece.a)];
    ++degrees[to_point(piece.b)];
  }
  return degrees;
}

struct Axis_piece
{
  Segment segment;
  double radius_source, radius_target;
};

/// A limb ends in a cap, and a skeleton may follow it up to the surface or stop at its centre: so
/// the axis goes straight on for one radius at its free ends.
template <typename Axis>
std::vector<Axis_piece> axis_to_tips(const Axis& axis)
{
  const std::map<Point, int> degrees = axis_degrees(axis);
  std::vector<Axis_piece> pieces;
  for(const auto& piece : axis) {
    const Point a = to_point(piece.a), b = to_point(piece.b);
    pieces.push_back({Segment(a, b), piece.radius_a, piece.radius_b});
    if(a == b)
      continue;
    const Vector along = (b - a) / std::sqrt(CGAL::squared_distance(a, b));
    if(degrees.at(a) == 1)
      pieces.push_back({Segment(a, a - piece.radius_a * along), piece.radius_a, piece.radius_a});
    if(degrees.at(b) == 1)
      pieces.push_back({Segment(b, b + piece.radius_b * along), piece.radius_b, piece.radius_b});
  }
  return pieces;
}

} // namespace internal

/// Distance of a skeleton to the true axis: every point of the skeleton that is not within 1.5
/// radii of a true junction is as far off as the nearest place of the axis is away, divided by the
/// radius there.
///
/// \param skeleton a BGL graph whose vertices bundle a `.point`
/// \param axis a range of segments with ends `.a`, `.b` and the radii `.radius_a`, `.radius_b` > 0
/// \param junctions a range of places with `.position` and `.radius`
template <typename Skeleton, typename Axis, typename Junctions>
Axis_distance axis_distance(const Skeleton& skeleton, const Axis& axis, const Junctions& junctions)
{
  const std::vector<internal::Axis_piece> pieces = internal::axis_to_tips(axis);
  std::vector<Segment> segments;
  double least_radius = std::numeric_limits<double>::infinity();
  for(const internal::Axis_piece& piece : pieces) {
    segments.push_back(piece.segment);
    least_radius = std::min({least_radius, piece.radius_source, piece.radius_target});
  }
  const Segment_tree tree(segments);
  Mean_and_maximum distances, centred;
  for(const Skeleton_sample& sample :
      sample_skeleton(skeleton, least_radius / internal::samples_per_radius)) {
    if(internal::is_at_junction(sample.point, junctions))
      continue;
    const Nearest nearest = tree.nearest(sample.point);
    const internal::Axis_piece& piece = pieces[nearest.segment];
    const double radius = nearest.interpolate(piece.radius_source, piece.radius_target);
    distances.add(nearest.distance / radius, sample.length);
    centred.add(nearest.distance <= internal::centred_within * radius ? 1 : 0, sample.length);
  }
  return {distances.mean(), distances.maximum(), centred.mean()};
}

} // namespace metrics

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_AXIS_DISTANCE_H
