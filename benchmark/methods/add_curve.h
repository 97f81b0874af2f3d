// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_ADD_CURVE_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_ADD_CURVE_H

#include "Method.h"

#include <cstddef>
#include <utility>
#include <vector>

/// Adds a vertex per point to a skeleton, and the edges, which are pairs of positions in `points`.
inline void add_curve(Skeleton& skeleton, const std::vector<Point>& points,
                      const std::vector<std::pair<std::size_t, std::size_t>>& edges)
{
  const std::size_t first = num_vertices(skeleton);
  for(const Point& p : points)
    skeleton[add_vertex(skeleton)].point = p;
  for(const auto& [source, target] : edges)
    add_edge(first + source, first + target, skeleton);
}

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_ADD_CURVE_H
