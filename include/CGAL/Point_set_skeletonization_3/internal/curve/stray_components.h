// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_STRAY_COMPONENTS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_STRAY_COMPONENTS_H


#include <CGAL/Point_set_skeletonization_3/internal/core/Union_find.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Skeleton_graph.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Marks the vertices of components with less than `stray_share` of the points of the largest one;
/// `weight[v]` is the number of points of vertex v. O(n).
inline std::vector<bool> stray_vertices(const Skeleton_graph& graph,
                                        const std::vector<double>& weight, double stray_share)
{
  Union_find parts(graph.vertices.size());
  for(const Skeleton_graph::Edge& e : graph.edges)
    parts.join(e.first, e.second);
  std::vector<double> total(graph.vertices.size(), 0);
  for(std::size_t v = 0; v < weight.size(); ++v)
    total[parts.find(v)] += weight[v];
  const double largest = total.empty() ? 0 : *std::max_element(total.begin(), total.end());
  std::vector<bool> stray(graph.vertices.size());
  for(std::size_t v = 0; v < stray.size(); ++v)
    stray[v] = total[parts.find(v)] < stray_share * largest;
  return stray;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_STRAY_COMPONENTS_H
