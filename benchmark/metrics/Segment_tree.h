// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_SEGMENT_TREE_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_SEGMENT_TREE_H

#include <CGAL/AABB_tree.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/version.h>
#if CGAL_VERSION_NR < 1060000000
#include <CGAL/AABB_segment_primitive.h>
#include <CGAL/AABB_traits.h>
#else
#include <CGAL/AABB_segment_primitive_3.h>
#include <CGAL/AABB_traits_3.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

/// How good a skeleton is, in numbers. Distances are computed in this kernel, whatever the
/// skeleton's.
namespace metrics {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Segment = Kernel::Segment_3;

/// From anything that has `.x()`, `.y()`, `.z()`.
template <typename Any_point>
Point to_point(const Any_point& p)
{
  return Point(p.x(), p.y(), p.z());
}

/// The place on a set of segments that is nearest to a point.
struct Nearest
{
  double distance;     ///< infinite if there is no segment
  std::size_t segment; ///< its number
  double parameter;    ///< in [0, 1], from the source of the segment to its target

  /// What is `at_source` and `at_target`, at the place.
  double interpolate(double at_source, double at_target) const
  {
    return at_source + parameter * (at_target - at_source);
  }
};

/// Finds the nearest of many segments, of which some may be points.
class Segment_tree
{
public:
  explicit Segment_tree(std::vector<Segment> segments)
      : segments_(std::move(segments))
      , tree_(segments_.begin(), segments_.end())
  {}
  Segment_tree(const Segment_tree&) = delete;
  Segment_tree& operator=(const Segment_tree&) = delete;

  Nearest nearest(const Point& p) const
  {
    if(segments_.empty())
      return {std::numeric_limits<double>::infinity(), 0, 0};
    const auto [place, found] = tree_.closest_point_and_primitive(p);
    const Vector along = found->to_vector();
    const double squared_length = along.squared_length();
    const double parameter =
        squared_length > 0 ? (place - found->source()) * along / squared_length : 0;
    return {std::sqrt(CGAL::squared_distance(p, place)),
            static_cast<std::size_t>(found - segments_.begin()), std::clamp(parameter, 0., 1.)};
  }

private:
  using Iterator = std::vector<Segment>::const_iterator;
#if CGAL_VERSION_NR < 1060000000
  using Traits = CGAL::AABB_traits<Kernel, CGAL::AABB_segment_primitive<Kernel, Iterator>>;
#else
  using Traits = CGAL::AABB_traits_3<Kernel, CGAL::AABB_segment_primitive_3<Kernel, Iterator>>;
#endif

  const std::vector<Segment> segments_;
  const CGAL::AABB_tree<Traits> tree_;
};

} // namespace metrics

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_SEGMENT_TREE_H
