// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SPATIAL_BOX_TREE_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SPATIAL_BOX_TREE_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Progress.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Returns the squared distance of a place to a box, 0 inside. Branchless, unlike Eigen's
/// `squaredExteriorDistance()`, whose branches are unpredictable.
inline double squared_distance(const Eigen::AlignedBox3d& box, const Vector3& p)
{
  return ((box.min)() - p).cwiseMax(p - (box.max)()).cwiseMax(0).squaredNorm();
}

/// A balanced binary tree of bounding boxes over points. Other queries attach bounds or sums to its
/// nodes. It depends on the points only and never changes: copies share it.
class Box_tree
{
public:
  using Box = Eigen::AlignedBox3d;

  static constexpr std::size_t leaf_size = 8; // testing a few points costs as much as a node

  struct Node
  {
    std::size_t begin, end; ///< Range of its points in `order()`.
    std::size_t after;      ///< The first node after its subtree.
  };

  /// The empty tree.
  Box_tree() : data_(std::make_shared<const Data>()) {}

  /// A tree over points. O(n log n).
  explicit Box_tree(const std::vector<Vector3>& points,
                    Concurrency concurrency = Concurrency::sequential)
  {
    auto data = std::make_shared<Data>();
    std::vector<Entry> entries;
    entries.reserve(points.size());
    for(std::size_t i = 0; i < points.size(); ++i)
      entries.push_back({points[i], i});
    if(!points.empty()) {
      add_nodes(data->nodes, 0, points.size());
      sort(data->nodes, 0, entries, concurrency);
    }
    data->order.reserve(points.size());
    data->positions.reserve(points.size());
    for(const Entry& entry : entries) {
      data->order.push_back(entry.index);
      data->positions.push_back(entry.position);
    }
    data->boxes = boxes_of(data->nodes, [&](std::size_t k) { return data->positions[k]; });
    data_ = std::move(data);
  }

  /// Nodes in preorder: the root, its left subtree, its right subtree. Empty if there are no
  /// points.
  const std::vector<Node>& nodes() const { return data_->nodes; }
  bool is_leaf(std::size_t node) const { return is_leaf(nodes(), node); }
  /// Left and right child. \pre `node` is not a leaf
  static std::size_t left(std::size_t node) { return node + 1; }
  std::size_t right(std::size_t node) const { return nodes()[left(node)].after; }
  /// Indices of the points in the order of the leaves.
  const std::vector<std::size_t>& order() const { return data_->order; }
  /// Returns values of the points by index, given in the order of the leaves. O(n).
  template <typename Value>
  std::vector<Value> by_index(const std::vector<Value>& in_order) const
  {
    std::vector<Value> result(order().size());
    for(std::size_t k = 0; k < order().size(); ++k)
      result[order()[k]] = in_order[k];
    return result;
  }

  /// Positions of the points in the order of the leaves.
  const std::vector<Vector3>& positions() const { return data_->positions; }
  /// The bounding box of each node.
  const std::vector<Box>& boxes() const { return data_->boxes; }

  /// Returns the bounding box of some values, by index of the points, for each node. O(n).
  std::vector<Box> boxes_of(const std::vector<Vector3>& values) const
  {
    return boxes_of(nodes(), [&](std::size_t k) { return values[order()[k]]; });
  }

  /// Calls `visit(k, squared_distance)` for each point closer than `radius` to `center`, which is
  /// the `k`-th of `order()`; k ascends. O(log n + result) in practice.
  template <typename Visit>
  void visit_within(const Vector3& center, double radius, const Visit& visit) const
  {
    const double squared_radius = radius * radius;
    const std::vector<Box>& boxes = this->boxes();
    const std::vector<Vector3>& positions = this->positions();
    visit_leaves(
      [&](std::size_t node) { return squared_distance(boxes[node], center) < squared_radius; },
      [&](std::size_t begin, std::size_t end) {
        for(std::size_t k = begin; k < end; ++k) {
          const double squared = (positions[k] - center).squaredNorm();
          if(squared < squared_radius)
            visit(k, squared);
        }
      });
  }

  /// Whether a point is closer than `radius` to `center`. O(log n) in practice.
  bool has_any_within(const Vector3& center, double radius) const
  {
    const double squared_radius = radius * radius;
    bool found = false;
    visit_leaves(
      [&](std::size_t node) {
        return !found && squared_distance(boxes()[node], center) < squared_radius;
      },
      [&](std::size_t begin, std::size_t end) {
        for(std::size_t k = begin; k < end; ++k)
          found = found || (positions()[k] - center).squaredNorm() < squared_radius;
      });
    return found;
  }

  /// Calls `visit(begin, end)` for each leaf such that `enter(node)` is true for it and all its
  /// ancestors. Its points are those of `order()` from `begin` to before `end`, `leaf_size` at
  /// most.
  template <typename Enter, typename Visit>
  void visit_leaves(const Enter& enter, const Visit& visit) const
  {
    const std::vector<Node>& nodes = this->nodes();
    for(std::size_t n = 0; n < nodes.size();) {
      if(!enter(n)) {
        n = nodes[n].after;
        continue;
      }
      if(is_leaf(nodes, n))
        visit(nodes[n].begin, nodes[n].end);
      ++n;
    }
  }

private:
  struct Data
  {
    std::vector<Node> nodes;
    std::vector<std::size_t> order;
    std::vector<Vector3> positions; ///< In that order.
    std::vector<Box> boxes;
  };

  struct Entry
  {
    Vector3 position;
    std::size_t index;
  };

  static bool is_leaf(const std::vector<Node>& nodes, std::size_t node)
  {
    return nodes[node].after == node + 1;
  }

  /// Appends the tree over a range of points, split into halves of equal size.
  static void add_nodes(std::vector<Node>& nodes, std::size_t begin, std::size_t end)
  {
    const std::size_t node = nodes.size();
    nodes.push_back({begin, end, node + 1});
    if(end - begin <= leaf_size)
      return;
    const std::size_t middle = begin + (end - begin) / 2;
    add_nodes(nodes, begin, middle);
    add_nodes(nodes, middle, end);
    nodes[node].after = nodes.size();
  }

  /// Sorts the entries of a node into its halves across its longest axis, recursively and
  /// concurrently.
  static void sort(const std::vector<Node>& nodes, std::size_t node, std::vector<Entry>& entries,
                   Concurrency concurrency)
  {
    const auto at = [&](std::size_t k) { return entries.begin() + static_cast<std::ptrdiff_t>(k); };
    const std::size_t begin = nodes[node].begin, end = nodes[node].end;
    if(is_leaf(nodes, node)) { // nth_element() leaves an unspecified order
      std::sort(at(begin), at(end),
                [](const Entry& a, const Entry& b) { return a.index < b.index; });
      return;
    }
    constexpr std::size_t worth_a_task = 512; // points
    if(end - begin >= worth_a_task)
      Progress::poll();
    Box box;
    for(std::size_t k = begin; k < end; ++k)
      box.extend(entries[k].position);
    Eigen::Index axis = 0;
    box.sizes().maxCoeff(&axis);
    const std::size_t left = node + 1, right = nodes[left].after;
    std::nth_element(at(begin), at(nodes[right].begin), at(end),
                     [axis](const Entry& a, const Entry& b) {
                       const double x = a.position[axis], y = b.position[axis];
                       return x != y ? x < y : a.index < b.index;
                     });
    parallel_invoke(
      end - begin >= worth_a_task ? concurrency : Concurrency::sequential,
      [&] { sort(nodes, left, entries, concurrency); },
      [&] { sort(nodes, right, entries, concurrency); });
  }

  /// `value(k)` is that of the `k`-th point in the order of the leaves.
  template <typename Value>
  static std::vector<Box> boxes_of(const std::vector<Node>& nodes, const Value& value)
  {
    std::vector<Box> result(nodes.size());
    for(std::size_t n = nodes.size(); n-- > 0;)
      if(is_leaf(nodes, n))
        for(std::size_t k = nodes[n].begin; k < nodes[n].end; ++k)
          result[n].extend(value(k));
      else
        result[n].extend(result[n + 1]).extend(result[nodes[n + 1].after]);
    return result;
  }

  std::shared_ptr<const Data> data_;
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SPATIAL_BOX_TREE_H
