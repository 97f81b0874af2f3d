// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SPATIAL_NEAREST_POINTS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SPATIAL_NEAREST_POINTS_H

#include <CGAL/Point_set_skeletonization_3/internal/spatial/Box_tree.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/Packet_tree.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Packet query: the nearest point of a tree to each of eight places.
class Nearest_points_packet
{
public:
  template <typename Place>
  Nearest_points_packet(const Packet_tree& tree, const Place& place)
    : tree_(tree), places_(packet_of([&](std::size_t k) { return tree.place(place(k)); }))
  {}

  /// Position, in the order of the tree, of the point nearest to the `k`-th place.
  std::size_t nearest(std::size_t k) const
  {
    return static_cast<std::size_t>(nearest_[k]);
  }

  void look_at(std::size_t begin, std::size_t end)
  {
    for(std::size_t point = begin; point < end; ++point) {
      const Packet_vectors d = places_.to(tree_.positions()[point]);
      const Packet_values squared = d.squared_norm();
      nearest_ += is_positive(squared_ - squared) * (static_cast<float>(point) - nearest_);
      squared_ = squared_.min(squared);
    }
  }

  /// Whether a point of `node` may be nearer.
  bool may_matter(std::size_t node) const
  {
    return places_.is_any_closer(tree_.boxes()[node], squared_);
  }

private:
  const Packet_tree& tree_;
  Packet_vectors places_;
  Packet_values squared_ =
      Packet_values::Constant(std::numeric_limits<float>::max()); ///< Distances.
  Packet_values nearest_ = Packet_values::Zero(); ///< Integers.
};

/// Returns the index of the nearest point of a tree for each place, in single precision. Fast if
/// consecutive places are close. \pre the tree has 1 to 2^24 points
inline std::vector<std::size_t> nearest_points(const Box_tree& tree,
                                               const std::vector<Vector3>& places,
                                               Concurrency concurrency)
{
  const Packet_tree packet_tree(tree);
  std::vector<std::size_t> result(places.size());
  for_each_packet(concurrency, places.size(), [&](std::size_t first, std::size_t end) {
    Nearest_points_packet packet(
      packet_tree, [&](std::size_t k) { return places[(std::min)(first + k, end - 1)]; });
    packet_tree.visit_leaves(packet, [&](std::size_t b, std::size_t e) { packet.look_at(b, e); });
    for(std::size_t k = first; k < end; ++k)
      result[k] = tree.order()[packet.nearest(k - first)];
  });
  return result;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SPATIAL_NEAREST_POINTS_H
