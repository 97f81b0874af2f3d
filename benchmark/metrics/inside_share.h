// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_INSIDE_SHARE_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_INSIDE_SHARE_H

#include "skeleton_samples.h"

#include <vector>

namespace metrics {

/// Share of the length of a skeleton that lies inside a shape, in [0, 1]; NaN if it is empty.
///
/// \param skeleton a BGL graph whose vertices bundle a `.point`
/// \param inside a predicate of a `metrics::Point`
/// \param step distance of the places that are asked; > 0, in the unit of the points
template <typename Skeleton, typename Inside>
double inside_share(const Skeleton& skeleton, const Inside& inside, double step)
{
  double length = 0, length_inside = 0;
  for(const Skeleton_sample& sample : sample_skeleton(skeleton, step)) {
    length += sample.length;
    length_inside += inside(sample.point) ? sample.length : 0;
  }
  return length_inside / length;
}

} // namespace metrics

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_INSIDE_SHARE_H
