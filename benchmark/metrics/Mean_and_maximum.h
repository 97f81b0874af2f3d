// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_MEAN_AND_MAXIMUM_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_MEAN_AND_MAXIMUM_H

#include <algorithm>
#include <cmath>
#include <limits>

namespace metrics {

/// Weighted mean, and maximum, of the values that were added; NaN if there were none.
class Mean_and_maximum
{
public:
  void add(double value, double weight)
  {
    sum_ += weight * value;
    weight_ += weight;
    maximum_ = std::fmax(maximum_, value);
  }

  double mean() const { return sum_ / weight_; }
  double maximum() const { return maximum_; }

private:
  double sum_ = 0;
  double weight_ = 0;
  double maximum_ = std::numeric_limits<double>::quiet_NaN(); // fmax() ignores it
};

} // namespace metrics

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_MEAN_AND_MAXIMUM_H
