// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PUBLISHED_KERNEL_PACKET_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PUBLISHED_KERNEL_PACKET_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/Packet_tree.h>

#include <boost/config.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Returns theta_h(r) = exp(-16 r^2 / h^2), a weight with support radius h.
inline double theta(double squared_distance, double h)
{
  return std::exp(-16 * squared_distance / (h * h));
}

/// The exponent of weights that are negligible beside others: 10^-3.
constexpr float negligible = 7;

/// Returns exp(-x) for 0 <= x < `end`, which is at most 16, and 0 beyond: as (1 - y + y^2 / 2)^256
/// with y = x / 256, with a relative error of x^3 / 3.6e5, in a third of the time of Eigen's.
BOOST_FORCEINLINE Packet_values decay(const Packet_values& x, float end)
{
  const Packet_values y = x.min(end) * (1.f / 256);
  Packet_values result = 1 - y * (1 - y * 0.5f);
  for(int doubling = 0; doubling < 8; ++doubling)
    result *= result;
  return result * is_positive(end - x);
}

/// Places with the support radii h of their kernels, > 0; neighbours should be close in the order.
struct Kernels
{
  std::vector<Vector3> places;
  std::vector<double> radii;

  std::size_t size() const { return places.size(); }
};

/// Eight of them.
struct Kernel_packet
{
  /// The kernels `first` to before `end`, eight at most; the last one fills up the packet.
  Kernel_packet(const Packet_tree& tree, const Kernels& kernels, std::size_t first, std::size_t end)
  {
    const auto kernel = [&](std::size_t k) { return (std::min)(first + k, end - 1); };
    places = packet_of([&](std::size_t k) { return tree.place(kernels.places[kernel(k)]); });
    for(std::size_t k = 0; k < packet_size; ++k) {
      const auto h = static_cast<float>(kernels.radii[kernel(k)]);
      squared_radius.set(k, h * h);
    }
    factor = 16 / squared_radius;
  }

  /// Calls `visit(k, d, squared)` for the points of `tree` closer than `squared_distance` to any of
  /// the places, and of some others: the `k`-th of its order is at `d` from the places.
  template <typename Visit>
  void for_each_within(const Packet_tree& tree, const Packet_values& squared_distance,
                       const Visit& visit) const
  {
    tree.visit_leaves(Within{tree, places, squared_distance},
                      [&](std::size_t begin, std::size_t end) {
                        for(std::size_t k = begin; k < end; ++k) {
                          const Packet_vectors d = places.to(tree.positions()[k]);
                          visit(k, d, d.squared_norm());
                        }
                      });
  }

  /// Returns theta for squared distances from the places, 0 below exp(-`end`): with 16 that is
  /// beyond the support radius.
  Packet_values theta(const Packet_values& squared, float end = 16) const
  {
    return decay(factor * squared, end);
  }

  Packet_vectors places; ///< In the coordinates of the tree.
  Packet_values squared_radius;

private:
  struct Within
  {
    const Packet_tree& tree;
    const Packet_vectors& places;
    const Packet_values& squared_distance;

    bool may_matter(std::size_t node) const
    {
      return places.is_any_closer(tree.boxes()[node], squared_distance);
    }
  };

  Packet_values factor; ///< Of a squared distance to the exponent of theta.
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PUBLISHED_KERNEL_PACKET_H
