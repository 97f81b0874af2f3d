// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_NEAREST_POINT_RADII_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_NEAREST_POINT_RADII_H

#include "Point_tree.h"

#include <boost/graph/graph_traits.hpp>
#include <boost/range/iterator_range.hpp>

#include <vector>

namespace metrics {

/// Gives every vertex of a skeleton, which bundles a `.point` and a `.radius`, its distance to the
/// nearest of the points: for skeletons of methods that know no radius.
/// \pre there is a point
template <typename Skeleton, typename Point_3>
void set_nearest_point_radii(Skeleton& skeleton, const std::vector<Point_3>& points)
{
  const Point_tree tree(points);
  for(const auto v : boost::make_iterator_range(vertices(skeleton)))
    skeleton[v].radius = tree.distance(to_point(skeleton[v].point));
}

} // namespace metrics

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_NEAREST_POINT_RADII_H
