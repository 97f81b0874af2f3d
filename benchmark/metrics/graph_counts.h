// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_GRAPH_COUNTS_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_GRAPH_COUNTS_H

#include <CGAL/number_utils.h>
#include <CGAL/squared_distance_3.h>

#include <boost/graph/connected_components.hpp>
#include <boost/graph/graph_traits.hpp>
#include <boost/range/iterator_range.hpp>

#include <cmath>
#include <cstddef>
#include <vector>

/// The topology of a skeleton in numbers.
struct Graph_counts
{
  std::size_t components = 0;
  std::size_t cycles = 0;    ///< independent ones: edges - vertices + components
  std::size_t ends = 0;      ///< vertices with one edge
  std::size_t junctions = 0; ///< vertices with three edges or more
  double length = 0;         ///< of all edges, in the unit of the points
};

/// Counts for a BGL graph whose vertices are numbered and bundle a `.point`.
template <typename Skeleton>
Graph_counts count_graph(const Skeleton& skeleton)
{
  Graph_counts counts;
  std::vector<std::size_t> component(num_vertices(skeleton));
  if(!component.empty())
    counts.components =
        static_cast<std::size_t>(boost::connected_components(skeleton, component.data()));
  counts.cycles = num_edges(skeleton) + counts.components - num_vertices(skeleton);
  for(const auto v : boost::make_iterator_range(vertices(skeleton))) {
    const auto degree = out_degree(v, skeleton);
    counts.ends += degree == 1 ? 1 : 0;
    counts.junctions += degree >= 3 ? 1 : 0;
  }
  for(const auto e : boost::make_iterator_range(edges(skeleton)))
    counts.length += std::sqrt(CGAL::to_double(CGAL::squared_distance(
        skeleton[source(e, skeleton)].point, skeleton[target(e, skeleton)].point)));
  return counts;
}

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_GRAPH_COUNTS_H
