// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_POINT_TREE_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_POINT_TREE_H

#include "Segment_tree.h"

#include <CGAL/Fuzzy_sphere.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>

#include <cmath>
#include <iterator>
#include <limits>
#include <vector>

namespace metrics {

/// Finds points of a cloud near a place.
class Point_tree
{
public:
  /// From any range of points.
  template <typename PointRange>
  explicit Point_tree(const PointRange& points)
  {
    for(const auto& p : points)
      tree_.insert(to_point(p));
    if(!tree_.empty())
      tree_.build();
  }

  /// To the nearest point; infinite if there is none.
  double distance(const Point& p) const
  {
    if(tree_.empty())
      return std::numeric_limits<double>::infinity();
    const CGAL::Orthogonal_k_neighbor_search<Traits> search(tree_, p, 1);
    return std::sqrt(search.begin()->second);
  }

  /// The points within a distance.
  std::vector<Point> within(double distance, const Point& p) const
  {
    std::vector<Point> result;
    tree_.search(std::back_inserter(result), CGAL::Fuzzy_sphere<Traits>(p, distance));
    return result;
  }

private:
  using Traits = CGAL::Search_traits_3<Kernel>;
  using Tree = CGAL::Orthogonal_k_neighbor_search<Traits>::Tree;

  Tree tree_;
};

} // namespace metrics

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_POINT_TREE_H
