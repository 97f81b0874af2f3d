// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_STRAY_COMPONENTS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_STRAY_COMPONENTS_H

#include <CGAL/Point_set_skeletonization_3/internal/curve/Measured_components.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Skeleton_graph.h>

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
  const Measured_components components(graph, weight);
  std::vector<bool> stray;
  for(std::size_t v = 0; v < weight.size(); ++v)
    stray.push_back(components.of(v).points < stray_share * components.largest().points);
  return stray;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_STRAY_COMPONENTS_H
