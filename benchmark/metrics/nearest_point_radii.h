// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_NEAREST_POINT_RADII_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_NEAREST_POINT_RADII_H

#include <CGAL/Kernel_traits.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/range/iterator_range.hpp>

#include <cmath>
#include <vector>

namespace metrics {

/// Gives every vertex of a skeleton, which bundles a `.point` and a `.radius`, its distance to the
/// nearest of the points: for skeletons of methods that know no radius.
/// \pre there is a point
template <typename Skeleton, typename Point_3>
void set_nearest_point_radii(Skeleton& skeleton, const std::vector<Point_3>& points)
{
  using Traits = CGAL::Search_traits_3<typename CGAL::Kernel_traits<Point_3>::Kernel>;
  using Search = CGAL::Orthogonal_k_neighbor_search<Traits>;
  const typename Search::Tree tree(points.begin(), points.end());
  for(const auto v : boost::make_iterator_range(vertices(skeleton))) {
    const Search search(tree, skeleton[v].point, 1);
    skeleton[v].radius = std::sqrt(search.begin()->second);
  }
}

} // namespace metrics

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_NEAREST_POINT_RADII_H
