// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_SPURS_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_SPURS_H

#include <CGAL/squared_distance_3.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/range/iterator_range.hpp>

#include <cmath>
#include <cstddef>

namespace metrics {
namespace internal {

/// The end of a branch, once it was followed.
template <typename Vertex>
struct Branch_end
{
  Vertex vertex;
  double length; ///< of the branch
};

/// Follows the branch that starts at `end`, a vertex with one edge, to a vertex that has not two.
template <typename Skeleton, typename Vertex>
Branch_end<Vertex> follow_branch(Vertex end, const Skeleton& skeleton)
{
  Vertex previous = end, current = end;
  double length = 0;
  do {
    const auto out = boost::make_iterator_range(out_edges(current, skeleton));
    Vertex next = target(out.front(), skeleton);
    if(next == previous)
      next = target(out.back(), skeleton);
    length += std::sqrt(CGAL::squared_distance(skeleton[current].point, skeleton[next].point));
    previous = current;
    current = next;
  } while(out_degree(current, skeleton) == 2);
  return {current, length};
}

} // namespace internal

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
    const auto junction = internal::follow_branch(end, skeleton);
    if(out_degree(junction.vertex, skeleton) > 2 &&
       junction.length < skeleton[junction.vertex].radius)
      ++spurs;
  }
  return spurs;
}

} // namespace metrics

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_SPURS_H
