// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_SKELETON_DISTANCE_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_SKELETON_DISTANCE_H

#include "Mean_and_maximum.h"
#include "Segment_tree.h"
#include "skeleton_edges.h"
#include "skeleton_samples.h"

#include <algorithm>

namespace metrics {

/// How far one skeleton is from another, in the unit of the points; NaN if it is empty, infinite if
/// the other is.
struct Skeleton_distance
{
  double mean;    ///< over the length of the skeleton
  double maximum; ///< over the samples
};

/// From the points of `from` to the nearest place of `to`. Both are BGL graphs whose vertices
/// bundle a `.point`. \param step distance of the points that are taken of `from`; > 0, in the unit
/// of the points
template <typename From, typename To>
Skeleton_distance one_way_distance(const From& from, const To& to, double step)
{
  const Segment_tree tree(edge_segments(to));
  Mean_and_maximum distances;
  for(const Skeleton_sample& sample : sample_skeleton(from, step))
    distances.add(tree.nearest(sample.point).distance, sample.length);
  return {distances.mean(), distances.maximum()};
}

/// The larger of both ways, of the means and of the maxima: what one of them has too much and what
/// it lacks count alike. The maximum is the Hausdorff distance.
template <typename Skeleton_a, typename Skeleton_b>
Skeleton_distance two_way_distance(const Skeleton_a& a, const Skeleton_b& b, double step)
{
  const Skeleton_distance there = one_way_distance(a, b, step);
  const Skeleton_distance back = one_way_distance(b, a, step);
  return {std::max(there.mean, back.mean), std::max(there.maximum, back.maximum)};
}

} // namespace metrics

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_SKELETON_DISTANCE_H
