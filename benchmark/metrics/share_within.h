// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_SHARE_WITHIN_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_SHARE_WITHIN_H

#include "Segment_tree.h"
#include "skeleton_edges.h"
#include "skeleton_samples.h"

namespace metrics {

/// Share of the length of a skeleton that is within a distance of another one, in [0, 1]; NaN if
/// nothing of it counts. Both are BGL graphs whose vertices bundle a `.point`.
///
/// \param counts a predicate of a `metrics::Point`: whether the place is part of the whole
/// \param step distance of the places that are asked; > 0, in the unit of the points
template <typename Skeleton, typename Other, typename Counts>
double share_within(double distance, const Skeleton& skeleton, const Other& other,
                    const Counts& counts, double step)
{
  const Segment_tree tree(edge_segments(other));
  double length = 0, length_within = 0;
  for(const Skeleton_sample& sample : sample_skeleton(skeleton, step))
    if(counts(sample.point)) {
      length += sample.length;
      length_within += tree.nearest(sample.point).distance <= distance ? sample.length : 0;
    }
  return length_within / length;
}

} // namespace metrics

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_SHARE_WITHIN_H
