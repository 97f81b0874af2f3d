// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_NEIGHBORHOODS_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_NEIGHBORHOODS_H

#include "Method.h"

#include <CGAL/Point_set_skeletonization_3/internal/published/Point_search.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/Neighbor.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace methods {

using CGAL::Point_set_skeletonization_3::internal::Neighbor;
using CGAL::Point_set_skeletonization_3::internal::Point_search;

/// For every point the points next to it.
using Neighbors = std::vector<std::vector<std::size_t>>;

/// CGAL's points or vectors as Eigen's.
template <typename Triple>
std::vector<Eigen::Vector3d> to_eigen(const std::vector<Triple>& triples)
{
  std::vector<Eigen::Vector3d> result;
  result.reserve(triples.size());
  for(const Triple& t : triples)
    result.emplace_back(t.x(), t.y(), t.z());
  return result;
}

/// For every point the `k` others nearest to it and those it is one of the `k` nearest of;
/// ascending.
inline Neighbors nearest_others(const Point_search& search,
                                const std::vector<Eigen::Vector3d>& points, std::size_t k)
{
  Neighbors result(points.size());
  std::vector<Neighbor> found;
  for(std::size_t i = 0; i < points.size(); ++i) {
    search.nearest(points[i], k + 1, found);
    for(const Neighbor& neighbor : found)
      if(neighbor.index != i) {
        result[i].push_back(neighbor.index);
        result[neighbor.index].push_back(i);
      }
  }
  for(std::vector<std::size_t>& list : result) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return result;
}

} // namespace methods

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_NEIGHBORHOODS_H
