// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SPATIAL_PACKET_TREE_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SPATIAL_PACKET_TREE_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/Box_tree.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/Float_packet.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

// Packet traversal (Wald et al. 2001, for rays): eight nearby places descend a tree together, as
// they visit nearly the same nodes. In single precision a packet fills two registers of four
// values. Without branches there are no branch mispredictions, which take most of the time of a
// single search.

/// Calls `body(first, end)` for the packets `first <= k < end` of `size` places, possibly
/// concurrently; `end - first` is `packet_size`, for the last one perhaps less.
template <typename Body>
void for_each_packet(Concurrency concurrency, std::size_t size, const Body& body)
{
  parallel_for(concurrency, (size + packet_size - 1) / packet_size, [&](std::size_t packet) {
    body(packet * packet_size, (std::min)(size, (packet + 1) * packet_size));
  });
}

/// A copy of a box tree in single precision, for packet queries. O(n).
class Packet_tree
{
public:
  explicit Packet_tree(const Box_tree& tree) : tree_(tree)
  {
    if(tree.nodes().empty())
      return;
    origin_ = tree.boxes().front().center();
    boxes_.reserve(tree.boxes().size());
    positions_.reserve(tree.positions().size());
    for(const Box_tree::Box& box : tree.boxes())
      boxes_.emplace_back(place((box.min)()), place((box.max)()));
    for(const Vector3& p : tree.positions())
      positions_.push_back(place(p));
  }

  /// A place in the coordinates of this tree.
  Eigen::Vector3f place(const Vector3& p) const { return (p - origin_).cast<float>(); }

  /// Positions of the points in the order of the leaves.
  const std::vector<Eigen::Vector3f>& positions() const { return positions_; }
  /// The bounding box of each node.
  const std::vector<Eigen::AlignedBox3f>& boxes() const { return boxes_; }

  /// Calls `look_at(begin, end)` for the points of each leaf such that `packet.may_matter(node)` is
  /// true for it and all its ancestors.
  template <typename Packet, typename Look_at>
  void visit_leaves(const Packet& packet, const Look_at& look_at) const
  {
    tree_.visit_leaves([&packet](std::size_t node) { return packet.may_matter(node); }, look_at);
  }

private:
  Box_tree tree_;
  Vector3 origin_ = Vector3::Zero(); ///< Centre of the points, for precision.
  std::vector<Eigen::Vector3f> positions_;
  std::vector<Eigen::AlignedBox3f> boxes_;
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SPATIAL_PACKET_TREE_H
