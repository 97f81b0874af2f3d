// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_UNEXPLAINED_POINTS_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_UNEXPLAINED_POINTS_H

#include "Segment_tree.h"
#include "skeleton_edges.h"

#include <cstddef>

namespace metrics {

/// Share of the points that no branch of a skeleton explains, in [0, 1]; NaN without points. A
/// point is explained if it is not further from the nearest edge than `1 + tolerance` times the
/// radius there, interpolated between the vertices.
///
/// \param points any range of points
/// \param skeleton a BGL graph whose vertices bundle a `.point` and a `.radius`
/// \param tolerance the radius is the least distance to the surface; at 1, sections twice as wide
/// as
///   they are thick are explained, and so is noise of the size of the radius
template <typename PointRange, typename Skeleton>
double unexplained_points(const PointRange& points, const Skeleton& skeleton, double tolerance = 1)
{
  const auto ends = edge_ends(skeleton);
  const Segment_tree tree(edge_segments(skeleton));
  const auto reach = [&](const Nearest& nearest) {
    const auto& [a, b] = ends[nearest.segment];
    return (1 + tolerance) * nearest.interpolate(skeleton[a].radius, skeleton[b].radius);
  };
  std::size_t total = 0, unexplained = 0;
  for(const auto& p : points) {
    const Nearest nearest = tree.nearest(to_point(p));
    ++total;
    if(ends.empty() || nearest.distance > reach(nearest))
      ++unexplained;
  }
  return static_cast<double>(unexplained) / static_cast<double>(total);
}

} // namespace metrics

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_UNEXPLAINED_POINTS_H
