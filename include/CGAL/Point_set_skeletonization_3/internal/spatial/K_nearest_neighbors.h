// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SPATIAL_K_NEAREST_NEIGHBORS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SPATIAL_K_NEAREST_NEIGHBORS_H

#include <CGAL/Point_set_skeletonization_3/internal/spatial/Box_tree.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/Neighbor.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Per_thread.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/Packet_tree.h>

#include <boost/range/iterator_range.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Number of neighbours that give normal and adjacency of a patch. About six surround a patch; a
/// few more include diagonal ones.
constexpr std::size_t surface_neighbors = 10;

/// The k-nearest-neighbour graph of points: `k()` neighbours of each, nearest first. The first is
/// the point itself, unless others coincide with it.
class K_nearest_neighbors
{
public:
  K_nearest_neighbors() = default;

  /// Neighbours to be filled in.
  K_nearest_neighbors(std::size_t points, std::size_t k) : k_(k), neighbors_(points * k) {}

  /// Number of points.
  std::size_t size() const { return k_ > 0 ? neighbors_.size() / k_ : 0; }

  /// Number of neighbours of each point.
  std::size_t k() const { return k_; }

  boost::iterator_range<const Neighbor*> operator[](std::size_t point) const
  {
    return {neighbors_.data() + point * k_, neighbors_.data() + (point + 1) * k_};
  }

  boost::iterator_range<Neighbor*> operator[](std::size_t point)
  {
    return {neighbors_.data() + point * k_, neighbors_.data() + (point + 1) * k_};
  }

private:
  std::size_t k_ = 0;
  std::vector<Neighbor> neighbors_; ///< Of one point after the other.
};

/// Packet query: the nearest neighbours of eight points of a tree.
class K_nearest_packet
{
public:
  K_nearest_packet(const Box_tree& tree, const Packet_tree& packet_tree, std::size_t k)
    : tree_(tree), packet_tree_(packet_tree), smallest_(k)
  {}

  /// Finds the neighbours of the points `place(k)` in the order of the tree, k < packet_size.
  template <typename Place>
  void look_around(const Place& place)
  {
    points_ = packet_of([&](std::size_t k) { return packet_tree_.positions()[place(k)]; });
    std::fill(smallest_.begin(), smallest_.end(),
              Packet_values::Constant(std::numeric_limits<float>::max()));
    seen_.clear();
    distances_.clear();
    // Points next to the first in the tree give a first bound.
    const std::size_t wide = packet_size + smallest_.size();
    const std::size_t first = place(0) - (std::min)(place(0), wide);
    const std::size_t end = (std::min)(place(0) + wide, packet_tree_.positions().size());
    look_at(first, end);
    packet_tree_.visit_leaves(*this, [&](std::size_t b, std::size_t e) {
      look_at(b, (std::min)(e, first));
      look_at(std::max(b, end), e);
    });
  }

  /// Whether a point of `node` may be among the nearest.
  bool may_matter(std::size_t node) const
  {
    return points_.is_any_closer(packet_tree_.boxes()[node], smallest_.back());
  }

  /// Writes the neighbours of the `k`-th point, which is at `position`, to `result`.
  void neighbors(std::size_t k, const Vector3& position, Neighbor* result)
  {
    const float farthest = smallest_.back()[k];
    near_.resize(seen_.size() + 1);
    std::size_t size = 0;
    for(std::size_t i = 0; i < seen_.size(); ++i) { // branchless
      near_[size] = seen_[i];
      size += distances_[i][k] <= farthest;
    }
    nearest_.resize(size);
    for(std::size_t i = 0; i < size; ++i)
      nearest_[i] = {(tree_.positions()[near_[i]] - position).squaredNorm(),
                     tree_.order()[near_[i]]};
    std::sort(nearest_.begin(), nearest_.end());
    std::copy_n(nearest_.begin(), smallest_.size(), result);
  }

private:
  void look_at(std::size_t begin, std::size_t end)
  {
    for(std::size_t other = begin; other < end; ++other) {
      const Packet_vectors d = points_.to(packet_tree_.positions()[other]);
      Packet_values squared = d.squared_norm();
      seen_.push_back(other);
      distances_.push_back(squared);
      for(Packet_values& smaller : smallest_) { // insertion into a sorted list
        const Packet_values greater = smaller.max(squared);
        smaller = smaller.min(squared);
        squared = greater;
      }
    }
  }

  const Box_tree& tree_;
  const Packet_tree& packet_tree_;
  Packet_vectors points_;
  std::vector<Packet_values> smallest_; ///< The k least squared distances, ascending.
  std::vector<std::size_t> seen_, near_;
  std::vector<Packet_values> distances_; ///< Squared distances to the points seen.
  std::vector<Neighbor> nearest_;     ///< Candidates of one point.
};

/// Writes the nearest neighbours of some points of a tree, `places` in its order, to `result`. Fast
/// if consecutive places are close.
inline void find_neighbors(const Box_tree& tree, const std::vector<std::size_t>& places,
                           K_nearest_neighbors& result, Concurrency concurrency)
{
  const Packet_tree packet_tree(tree);
  Per_thread<K_nearest_packet> packets(
    concurrency, [&] { return K_nearest_packet(tree, packet_tree, result.k()); });
  for_each_packet(concurrency, places.size(), [&](std::size_t first, std::size_t end) {
    K_nearest_packet& packet = packets.local();
    packet.look_around([&](std::size_t i) { return places[(std::min)(first + i, end - 1)]; });
    for(std::size_t i = first; i < end; ++i)
      packet.neighbors(i - first, tree.positions()[places[i]],
                       result[tree.order()[places[i]]].begin());
  });
}

/// Returns the `k` nearest neighbours of each point of a tree, all if there are fewer: found in
/// single precision, ordered in double. O(n log n) in practice.
inline K_nearest_neighbors k_nearest_neighbors(const Box_tree& tree, std::size_t k,
                                               Concurrency concurrency)
{
  const std::size_t size = tree.order().size();
  K_nearest_neighbors result(size, (std::min)(k, size));
  std::vector<std::size_t> places(size);
  std::iota(places.begin(), places.end(), std::size_t(0));
  find_neighbors(tree, places, result, concurrency);
  return result;
}

/// Returns the nearest neighbours of the remaining points after some were dropped, from those
/// `before`: `index_of[i]` is the new index of point i, or at least the size of `tree` if it was
/// dropped. Searches only for points that lost a neighbour.
inline K_nearest_neighbors renumbered(const K_nearest_neighbors& before,
                                      const std::vector<std::size_t>& index_of,
                                      const Box_tree& tree, Concurrency concurrency)
{
  const std::size_t size = tree.order().size();
  K_nearest_neighbors result(size, (std::min)(before.k(), size));
  std::vector<bool> known(size, false);
  for(std::size_t i = 0; i < index_of.size(); ++i) {
    const auto dropped = [&](const Neighbor& neighbor) { return index_of[neighbor.index] >= size; };
    if(index_of[i] >= size || std::any_of(before[i].begin(), before[i].end(), dropped))
      continue;
    const auto nearest = result[index_of[i]];
    std::transform(before[i].begin(), before[i].end(), nearest.begin(),
                   [&](const Neighbor& neighbor) {
                     return Neighbor{neighbor.squared_distance, index_of[neighbor.index]};
                   });
    std::sort(nearest.begin(), nearest.end());
    known[index_of[i]] = true;
  }
  std::vector<std::size_t> unknown;
  for(std::size_t place = 0; place < size; ++place)
    if(!known[tree.order()[place]])
      unknown.push_back(place);
  find_neighbors(tree, unknown, result, concurrency);
  return result;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SPATIAL_K_NEAREST_NEIGHBORS_H
