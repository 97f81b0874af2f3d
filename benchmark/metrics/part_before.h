// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_PART_BEFORE_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_PART_BEFORE_H

#include <CGAL/Iterator_range.h>

#include <boost/graph/graph_traits.hpp>

#include <vector>

namespace metrics {

/// The part of a skeleton whose first coordinates are less than `border`. An edge across it leaves an
/// end.
template <typename Skeleton>
Skeleton part_before(double border, const Skeleton& skeleton)
{
  Skeleton result;
  std::vector<typename boost::graph_traits<Skeleton>::vertex_descriptor> copies(
    num_vertices(skeleton));
  const auto is_kept = [&](auto v) { return skeleton[v].point.x() < border; };
  for(const auto v : CGAL::make_range(vertices(skeleton)))
    if(is_kept(v))
      copies[v] = add_vertex(skeleton[v], result);
  for(const auto e : CGAL::make_range(edges(skeleton))) {
    const auto a = source(e, skeleton), b = target(e, skeleton);
    if(is_kept(a) && is_kept(b))
      add_edge(copies[a], copies[b], skeleton[e], result);
    else if(is_kept(a) != is_kept(b)) {
      const auto outside = add_vertex(skeleton[is_kept(a) ? b : a], result);
      add_edge(copies[is_kept(a) ? a : b], outside, skeleton[e], result);
    }
  }
  return result;
}

} // namespace metrics

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_PART_BEFORE_H
