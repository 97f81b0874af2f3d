// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SPATIAL_BOX_TREE_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SPATIAL_BOX_TREE_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel_for.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// An axis-parallel box; empty at first.
struct Box
{
  Vector3 lower = Vector3::Constant(std::numeric_limits<double>::infinity());
  Vector3 upper = Vector3::Constant(-std::numeric_limits<double>::infinity());

  void add(const Vector3& p)
  {
    lower = lower.cwiseMin(p);
    upper = upper.cwiseMax(p);
  }

  void add(const Box& other)
  {
    lower = lower.cwiseMin(other.lower);
    upper = upper.cwiseMax(other.upper);
  }

  double squared_distance(const Vector3& p) const
  {
    return (lower - p).cwiseMax(p - upper).cwiseMax(0).squaredNorm();
  }
};

/// A balanced binary tree over points, for sums over all points that get coarser with distance and for
/// what can be bounded in a box. It depends on the points only.
class Box_tree
{
public:
  static constexpr std::size_t leaf_size = 8; // a handful costs as much as a node

  struct Node
  {
    std::size_t begin, end; ///< Of its points in `order()`.
    std::size_t after;      ///< The first node after it that is not below it.
  };

  Box_tree() = default;

  /// `position(i)` gives the `i`-th of `size` points. Halves are sorted concurrently under
  /// `Parallel_tag`.
  template <typename Position, typename ConcurrencyTag = Sequential_tag>
  Box_tree(std::size_t size, const Position& position, ConcurrencyTag = ConcurrencyTag())
  {
    std::vector<Entry> entries;
    entries.reserve(size);
    for(std::size_t i = 0; i < size; ++i)
      entries.push_back({position(i), i});
    if(size > 0) {
      add_nodes(0, size);
      sort<ConcurrencyTag>(entries, 0);
    }
    order_.reserve(size);
    positions_.reserve(size);
    for(const Entry& entry : entries) {
      order_.push_back(entry.index);
      positions_.push_back(entry.position);
    }
    boxes_ = boxes_of(position);
  }

  /// In preorder: the root, its left subtree, its right subtree. Empty if there are no points.
  const std::vector<Node>& nodes() const { return nodes_; }
  bool is_leaf(std::size_t node) const { return nodes_[node].after == node + 1; }
  /// \pre it is no leaf
  std::size_t left(std::size_t node) const { return node + 1; }
  std::size_t right(std::size_t node) const { return nodes_[left(node)].after; }
  /// The points, sorted into the leaves.
  const std::vector<std::size_t>& order() const { return order_; }
  /// Values of the points, given in that order, by their indices.
  template <typename Value>
  std::vector<Value> by_index(const std::vector<Value>& in_order) const
  {
    std::vector<Value> result(order_.size());
    for(std::size_t k = 0; k < order_.size(); ++k)
      result[order_[k]] = in_order[k];
    return result;
  }

  /// Their positions, in that order.
  const std::vector<Vector3>& positions() const { return positions_; }
  /// The bounding box of every node.
  const std::vector<Box>& boxes() const { return boxes_; }

  /// The box around `value(i)` of the points of every node.
  template <typename Value>
  std::vector<Box> boxes_of(const Value& value) const
  {
    std::vector<Box> result(nodes_.size());
    for(std::size_t n = nodes_.size(); n-- > 0;) {
      const Node& node = nodes_[n];
      if(is_leaf(n))
        for(std::size_t k = node.begin; k < node.end; ++k)
          result[n].add(value(order_[k]));
      else {
        result[n].add(result[left(n)]);
        result[n].add(result[right(n)]);
      }
    }
    return result;
  }

  /// Calls `visit(k, squared_distance)` for every point closer than `radius` to `center`; it is the
  /// `k`-th of `order()`, in ascending order.
  template <typename Visit>
  void visit_within(const Vector3& center, double radius, const Visit& visit) const
  {
    const double squared_radius = radius * radius;
    visit_leaves(
      [&](std::size_t node) { return boxes_[node].squared_distance(center) < squared_radius; },
      [&](std::size_t begin, std::size_t end) {
        for(std::size_t k = begin; k < end; ++k) {
          const double squared_distance = (positions_[k] - center).squaredNorm();
          if(squared_distance < squared_radius)
            visit(k, squared_distance);
        }
      });
  }

  /// Calls `visit(begin, end)` for every leaf for which `enter(node)` is true for it and all nodes
  /// above. Its points are those of `order()` from `begin` to before `end`, `leaf_size` at most.
  template <typename Enter, typename Visit>
  void visit_leaves(const Enter& enter, const Visit& visit) const
  {
    for(std::size_t n = 0; n < nodes_.size();) {
      if(!enter(n)) {
        n = nodes_[n].after;
        continue;
      }
      if(is_leaf(n))
        visit(nodes_[n].begin, nodes_[n].end);
      ++n;
    }
  }

private:
  struct Entry
  {
    Vector3 position;
    std::size_t index;
  };

  /// Appends the tree over a range of points: halves of equal size.
  void add_nodes(std::size_t begin, std::size_t end)
  {
    const std::size_t node = nodes_.size();
    nodes_.push_back({begin, end, node + 1});
    if(end - begin <= leaf_size)
      return;
    const std::size_t middle = begin + (end - begin) / 2;
    add_nodes(begin, middle);
    add_nodes(middle, end);
    nodes_[node].after = nodes_.size();
  }

  /// Sorts the entries of a node into its halves, across its longest axis.
  template <typename ConcurrencyTag>
  void sort(std::vector<Entry>& entries, std::size_t node) const
  {
    const auto at = [&](std::size_t k) { return entries.begin() + static_cast<std::ptrdiff_t>(k); };
    const std::size_t begin = nodes_[node].begin, end = nodes_[node].end;
    if(is_leaf(node)) { // an order of its own, whatever nth_element() leaves
      std::sort(at(begin), at(end),
                [](const Entry& a, const Entry& b) { return a.index < b.index; });
      return;
    }
    Box box;
    for(std::size_t k = begin; k < end; ++k)
      box.add(entries[k].position);
    Eigen::Index axis = 0;
    (box.upper - box.lower).maxCoeff(&axis);
    std::nth_element(at(begin), at(nodes_[right(node)].begin), at(end),
                     [axis](const Entry& a, const Entry& b) {
                       const double x = a.position[axis], y = b.position[axis];
                       return x != y ? x < y : a.index < b.index;
                     });
    constexpr std::size_t worth_a_task = 512; // points
    const auto sort_left = [&] { sort<ConcurrencyTag>(entries, left(node)); };
    const auto sort_right = [&] { sort<ConcurrencyTag>(entries, right(node)); };
    if(end - begin >= worth_a_task)
      parallel_invoke<ConcurrencyTag>(sort_left, sort_right);
    else
      parallel_invoke<Sequential_tag>(sort_left, sort_right);
  }

  std::vector<Node> nodes_;
  std::vector<std::size_t> order_;
  std::vector<Box> boxes_;
  std::vector<Vector3> positions_; ///< In the order of the leaves.
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SPATIAL_BOX_TREE_H
