// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial

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
/// \param tolerance the radius is the least distance to the surface: at 0.5 the corners of a square
///   section are explained, 0.41 beyond it, with a margin for noise
template <typename PointRange, typename Skeleton>
double unexplained_points(const PointRange& points, const Skeleton& skeleton,
                          double tolerance = 0.5)
{
  const auto ends = edge_ends(skeleton);
  const Segment_tree tree(edge_segments(skeleton));
  std::size_t total = 0, unexplained = 0;
  for(const auto& p : points) {
    ++total;
    const Nearest nearest = tree.nearest(to_point(p));
    if(ends.empty()) {
      ++unexplained;
      continue;
    }
    const double a = skeleton[ends[nearest.segment].first].radius;
    const double b = skeleton[ends[nearest.segment].second].radius;
    const double radius = a + nearest.parameter * (b - a);
    unexplained += nearest.distance > (1 + tolerance) * radius ? 1 : 0;
  }
  return static_cast<double>(unexplained) / static_cast<double>(total);
}

} // namespace metrics

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_UNEXPLAINED_POINTS_H
