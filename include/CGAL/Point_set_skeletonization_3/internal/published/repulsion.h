// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PUBLISHED_REPULSION_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PUBLISHED_REPULSION_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/published/Kernel_packet.h>
#include <CGAL/Point_set_skeletonization_3/internal/published/kernel_growth.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/Packet_tree.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Returns F2 of Eq. 4 for each sample of `tree`, with the weights of Eq. 6 and 8 for eta(r) = -r
/// (Huang et al. 2009): repulsion from the others. Samples at exactly the same place, and so the
/// sample itself, give no direction and are ignored. `kernels` and `around` are in the order of the
/// tree. O(n^2) if the kernels are as wide as the shape.
inline std::vector<Vector3> repulsion(const Packet_tree& tree, const Kernels& kernels,
                                      const std::vector<Surroundings>& around,
                                      Concurrency concurrency)
{
  constexpr float least = (std::numeric_limits<float>::min)(); // no division by zero
  std::vector<Vector3> result(kernels.size());
  for_each_packet(concurrency, kernels.size(), [&](std::size_t first, std::size_t end) {
    Packet_values weight = Packet_values::Zero();
    Packet_vectors sum{weight, weight, weight};
    const Kernel_packet packet(tree, kernels, first, end);
    packet.for_each_within(
      tree, packet.squared_radius,
      [&](std::size_t j, const Packet_vectors& d, const Packet_values& squared) {
        const auto density = static_cast<float>(around[j].density);
        const Packet_values beta =
          density * packet.theta(squared) * is_positive(squared) / squared.max(least).sqrt();
        weight += beta;
        sum.x -= beta * d.x;
        sum.y -= beta * d.y;
        sum.z -= beta * d.z;
      });
    for(std::size_t i = first; i < end; ++i) {
      const std::size_t k = i - first;
      const Vector3 total(sum.x[k], sum.y[k], sum.z[k]);
      result[i] = weight[k] > 0 ? Vector3(total / weight[k]) : Vector3::Zero();
    }
  });
  return result;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PUBLISHED_REPULSION_H
