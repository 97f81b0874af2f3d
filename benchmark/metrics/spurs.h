// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_SPURS_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_SPURS_H

#include <CGAL/squared_distance_3.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/range/iterator_range.hpp>

#include <cmath>
#include <cstddef>

namespace metrics {

/// Number of spurs: branches from an end to a junction that are shorter than the radius at the
/// junction, and so do not leave its ball.
///
/// \param skeleton a BGL graph whose vertices bundle a `.point` and a `.radius`
template <typename Skeleton>
std::size_t count_spurs(const Skeleton& skeleton)
{
  std::size_t spurs = 0;
  for(const auto end : boost::make_iterator_range(vertices(skeleton))) {
    if(out_degree(end, skeleton) != 1)
      continue;
    auto previous = end, current = end;
    double length = 0;
    do {
      const auto neighbors = boost::make_iterator_range(adjacent_vertices(current, skeleton));
      auto next = *neighbors.begin();
      if(current != end && next == previous)
        next = *std::next(neighbors.begin());
      length += std::sqrt(CGAL::squared_distance(skeleton[current].point, skeleton[next].point));
      previous = current;
      current = next;
    } while(out_degree(current, skeleton) == 2);
    if(out_degree(current, skeleton) > 2 && length < skeleton[current].radius)
      ++spurs;
  }
  return spurs;
}

} // namespace metrics

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_SPURS_H
