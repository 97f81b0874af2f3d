// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_SKELETON_EDGES_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_SKELETON_EDGES_H

#include "Segment_tree.h"

#include <boost/graph/graph_traits.hpp>
#include <boost/range/iterator_range.hpp>

#include <utility>
#include <vector>

namespace metrics {

template <typename Skeleton>
using Vertex_pair = std::pair<typename boost::graph_traits<Skeleton>::vertex_descriptor,
                              typename boost::graph_traits<Skeleton>::vertex_descriptor>;

/// The two vertices of every edge; after them every vertex without edges, as both ends of a point.
template <typename Skeleton>
std::vector<Vertex_pair<Skeleton>> edge_ends(const Skeleton& skeleton)
{
  std::vector<Vertex_pair<Skeleton>> ends;
  for(const auto e : boost::make_iterator_range(edges(skeleton)))
    ends.emplace_back(source(e, skeleton), target(e, skeleton));
  for(const auto v : boost::make_iterator_range(vertices(skeleton)))
    if(out_degree(v, skeleton) == 0)
      ends.emplace_back(v, v);
  return ends;
}

/// The same as segments.
template <typename Skeleton>
std::vector<Segment> edge_segments(const Skeleton& skeleton)
{
  std::vector<Segment> segments;
  for(const auto& [a, b] : edge_ends(skeleton))
    segments.emplace_back(to_point(skeleton[a].point), to_point(skeleton[b].point));
  return segments;
}

} // namespace metrics

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_SKELETON_EDGES_H
