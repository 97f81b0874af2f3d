// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SPATIAL_PACKET_TREE_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SPATIAL_PACKET_TREE_H

#include <CGAL/Point_set_skeletonization_3/internal/spatial/Box_tree.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

// Packet traversal (Wald et al. 2001, for rays): eight nearby places descend a tree together, as
// they visit nearly the same nodes. In single precision a packet fills two registers of four
// values. Without branches there are no branch mispredictions, which take most of the time of a
// single search.

/// Number of places of a packet.
constexpr std::size_t packet_size = 8;

/// A value for each place of a packet.
using Packet_values = Eigen::Array<float, packet_size, 1>;

/// A vector for each place of a packet.
struct Packet_vectors
{
  Packet_values x, y, z;

  /// The vectors from the places to a point.
  Packet_vectors to(const Eigen::Vector3f& p) const { return {p.x() - x, p.y() - y, p.z() - z}; }

  auto dot(const Eigen::Vector3f& v) const { return x * v.x() + y * v.y() + z * v.z(); }
  auto dot(const Packet_vectors& v) const { return x * v.x + y * v.y + z * v.z; }
  auto squared_norm() const { return x * x + y * y + z * z; }

  /// Whether a place is closer to a box than its given squared distance.
  bool is_any_closer(const Eigen::AlignedBox3f& box, const Packet_values& squared_distance) const
  {
    const Eigen::Vector3f &lower = (box.min)(), &upper = (box.max)();
    const Packet_vectors to_box{(lower.x() - x).max(x - upper.x()).max(0),
                                (lower.y() - y).max(y - upper.y()).max(0),
                                (lower.z() - z).max(z - upper.z()).max(0)};
    return (to_box.squared_norm() - squared_distance).minCoeff() < 0;
  }
};

/// Returns the packet of the vectors `vector(k)`, k < packet_size.
template <typename Vector>
Packet_vectors packet_of(const Vector& vector)
{
  Packet_vectors result;
  for(std::size_t k = 0; k < packet_size; ++k) {
    const Eigen::Vector3f v = vector(k);
    const auto lane = static_cast<Eigen::Index>(k);
    result.x[lane] = v.x();
    result.y[lane] = v.y();
    result.z[lane] = v.z();
  }
  return result;
}

/// Returns 1 for each positive value, else 0. The result refers to the values.
template <typename Values>
auto is_positive(const Values& values)
{
  return (values * (std::numeric_limits<float>::max)()).max(0).min(1);
}

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
