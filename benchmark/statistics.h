// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_STATISTICS_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_STATISTICS_H

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

/// What was not measured.
constexpr double not_measured = std::numeric_limits<double>::quiet_NaN();

inline std::vector<double> measured(std::vector<double> numbers)
{
  numbers.erase(
      std::remove_if(numbers.begin(), numbers.end(), [](double x) { return std::isnan(x); }),
      numbers.end());
  return numbers;
}

/// Of those that were measured.
inline double mean_of(const std::vector<double>& numbers)
{
  const std::vector<double> values = measured(numbers);
  return std::accumulate(values.begin(), values.end(), 0.) / static_cast<double>(values.size());
}

/// Of those that were measured; the larger one if two are in the middle.
inline double median_of(const std::vector<double>& numbers)
{
  std::vector<double> values = measured(numbers);
  if(values.empty())
    return not_measured;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_STATISTICS_H
