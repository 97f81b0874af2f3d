// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_QUANTILE_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_QUANTILE_H

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Returns the value with a share of `values` below it. O(n).
/// \pre `!values.empty()` and `0 <= share < 1`
inline double quantile(std::vector<double> values, double share)
{
  const auto k = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size()));
  std::nth_element(values.begin(), values.begin() + k, values.end());
  return values[static_cast<std::size_t>(k)];
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_QUANTILE_H
