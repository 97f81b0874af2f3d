// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PUBLISHED_DENSITIES_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PUBLISHED_DENSITIES_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/published/Kernel_packet.h>
#include <CGAL/Point_set_skeletonization_3/internal/published/gaussian_functions.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/Box_tree.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/Packet_tree.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Points, each of which stands for a number of others.
struct Counted_points
{
  std::vector<Vector3> places;
  std::vector<std::size_t> counts;
};

/// Returns the means of the largest groups of a tree whose boxes have at most this diagonal; points
/// of wider leaves stand for themselves. O(n).
inline Counted_points grouped(const Box_tree& tree, double diagonal)
{
  Counted_points result;
  const auto add = [&](std::size_t begin, std::size_t end) {
    Vector3 sum = Vector3::Zero();
    for(std::size_t k = begin; k < end; ++k)
      sum += tree.positions()[k];
    result.places.push_back(sum / static_cast<double>(end - begin));
    result.counts.push_back(end - begin);
  };
  for(std::size_t n = 0; n < tree.nodes().size();) {
    const Box_tree::Node& node = tree.nodes()[n];
    const bool is_group = tree.boxes()[n].diagonal().norm() <= diagonal;
    if(is_group)
      add(node.begin, node.end);
    else if(tree.is_leaf(n))
      for(std::size_t k = node.begin; k < node.end; ++k)
        add(k, k + 1);
    n = is_group ? node.after : n + 1;
  }
  return result;
}

/// Returns the density at each point for one kernel radius, v of Eq. 7: 1 + sum of theta over the
/// other points. Points within a quarter of the radius, one and a half standard deviations of
/// theta, count as one: that widens the kernel by some 4 %. Permuted points give the same densities
/// permuted, bit by bit. O(n log n), however many points a kernel has.
inline std::vector<double> densities(const std::vector<Vector3>& points, double kernel_radius,
                                     Concurrency concurrency)
{
  const std::vector<std::size_t> order = lexicographic_order(points);
  std::vector<Vector3> sorted;
  for(std::size_t i : order)
    sorted.push_back(points[i]);
  const Box_tree tree(sorted, concurrency);
  const Counted_points groups = grouped(tree, kernel_radius / 4);
  const Box_tree group_tree(groups.places, concurrency);
  const Packet_tree packet_tree(group_tree);
  const Kernels kernels{tree.positions(), std::vector<double>(points.size(), kernel_radius)};
  std::vector<double> result(points.size());
  for_each_packet(concurrency, points.size(), [&](std::size_t first, std::size_t end) {
    Packet_values density = Packet_values::Zero();
    const Kernel_packet packet(packet_tree, kernels, first, end);
    packet.for_each_within(
      packet_tree, packet.squared_radius * (negligible / 16),
      [&](std::size_t k, const Packet_vectors&, const Packet_values& squared) {
        const auto count = static_cast<float>(groups.counts[group_tree.order()[k]]);
        density += count * packet.theta(squared, negligible);
      });
    for(std::size_t k = first; k < end; ++k)
      result[order[tree.order()[k]]] = (std::max)(1.f, density[k - first]);
  });
  return result;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PUBLISHED_DENSITIES_H
