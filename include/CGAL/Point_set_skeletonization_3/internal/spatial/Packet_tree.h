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

// Packets of queries (Wald et al. 2001 trace rays so): what is asked at places next to each other is
// asked at eight of them at once, as they look at much the same points. In single precision the values
// of a packet fill two registers of four, and without a branch there is nothing that a processor could
// guess wrong, which is where most of the time of a search goes.

/// Places of a packet.
constexpr std::size_t packet_size = 8;

/// A value for every place of a packet.
using Packet_values = Eigen::Array<float, packet_size, 1>;

/// A vector for every place of a packet.
struct Packet_vectors
{
  Packet_values x, y, z;

  /// The way from every place to a point.
  Packet_vectors to(const Eigen::Vector3f& p) const { return {p.x() - x, p.y() - y, p.z() - z}; }

  auto dot(const Eigen::Vector3f& v) const { return x * v.x() + y * v.y() + z * v.z(); }
  auto dot(const Packet_vectors& v) const { return x * v.x + y * v.y + z * v.z; }
  auto squared_norm() const { return x * x + y * y + z * z; }

  /// Whether one of the places is closer to a box than its distance, which is given squared.
  bool is_any_closer(const Eigen::AlignedBox3f& box, const Packet_values& squared_distance) const
  {
    const Eigen::Vector3f &lower = (box.min)(), &upper = (box.max)();
    const Packet_vectors to_box{(lower.x() - x).max(x - upper.x()).max(0),
                                (lower.y() - y).max(y - upper.y()).max(0),
                                (lower.z() - z).max(z - upper.z()).max(0)};
    return (to_box.squared_norm() - squared_distance).minCoeff() < 0;
  }
};

/// `vector(k)` at the `k`-th place of a packet.
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

/// 1 for every value that is positive, else 0. Refers to the values.
template <typename Values>
auto is_positive(const Values& values)
{
  return (values * std::numeric_limits<float>::max()).max(0).min(1);
}

/// Calls `body(first, end)` for the packets `first <= k < end` of `size` places, possibly concurrently;
/// `end - first` is `packet_size` but for the last.
template <typename Body>
void for_each_packet(Concurrency concurrency, std::size_t size, const Body& body)
{
  parallel_for(concurrency, (size + packet_size - 1) / packet_size, [&](std::size_t packet) {
    body(packet * packet_size, std::min(size, (packet + 1) * packet_size));
  });
}

/// A box tree in single precision, for the queries of packets.
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

  /// The points, in the order of the leaves.
  const std::vector<Eigen::Vector3f>& positions() const { return positions_; }
  /// The bounding box of every node.
  const std::vector<Eigen::AlignedBox3f>& boxes() const { return boxes_; }

  /// Calls `look_at(begin, end)` for the points of every leaf for which `packet.may_matter(node)` is true
  /// for it and all nodes above.
  template <typename Packet, typename Look_at>
  void visit_leaves(const Packet& packet, const Look_at& look_at) const
  {
    tree_.visit_leaves([&packet](std::size_t node) { return packet.may_matter(node); }, look_at);
  }

private:
  Box_tree tree_;
  Vector3 origin_ = Vector3::Zero(); ///< The middle: single precision is about the points' extent.
  std::vector<Eigen::Vector3f> positions_;
  std::vector<Eigen::AlignedBox3f> boxes_;
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SPATIAL_PACKET_TREE_H
