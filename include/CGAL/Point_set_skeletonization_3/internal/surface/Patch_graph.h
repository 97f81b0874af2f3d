// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_PATCH_GRAPH_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_PATCH_GRAPH_H


#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch.h>

#include <CGAL/assertions.h>

#include <boost/range/iterator_range.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Two adjacent patches, `a < b`.
struct Patch_pair
{
  std::uint32_t a, b;
};

/// Returns the pairs of adjacent patches, each once, in lexicographic order. O(pairs).
inline std::vector<Patch_pair> adjacent_pairs(const Patches& patches)
{
  CGAL_precondition(patches.size() <= (std::numeric_limits<std::uint32_t>::max)());
  std::size_t size = 0;
  for(const Patch& patch : patches)
    size += patch.neighbors.size();
  std::vector<Patch_pair> result;
  result.reserve(size / 2);
  for(std::size_t i = 0; i < patches.size(); ++i) {
    const std::vector<std::size_t>& neighbors = patches[i].neighbors; // ascending
    for(auto j = std::upper_bound(neighbors.begin(), neighbors.end(), i); j != neighbors.end(); ++j)
      result.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(*j)});
  }
  return result;
}

/// The adjacency graph of patches in compressed rows: the edges of one patch after the other.
class Patch_graph
{
public:
  struct Edge // small: growing regions mostly reads edges
  {
    std::uint32_t patch;
    float length;
  };

  /// An edge for each of the `adjacent_pairs()`.
  Patch_graph(const Patches& patches, const std::vector<Patch_pair>& pairs)
    : Patch_graph(patches, pairs, [](std::size_t) { return true; })
  {}

  /// An edge for each pair with `has(k)`, k its index. O(patches + pairs).
  template <typename Predicate>
  Patch_graph(const Patches& patches, const std::vector<Patch_pair>& pairs,
              const Predicate& has)
    : first_(patches.size() + 2, 0)
  {
    std::vector<std::size_t> kept;
    kept.reserve(pairs.size());
    for(std::size_t k = 0; k < pairs.size(); ++k)
      if(has(k)) {
        kept.push_back(k);
        ++first_[pairs[k].a + 2];
        ++first_[pairs[k].b + 2];
      }
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    edges_.resize(first_.back());
    for(std::size_t k : kept) { // counting sort; afterwards first_[i] is the first of patch i
      const Patch_pair& pair = pairs[k];
      const auto length = static_cast<float>((patches[pair.a].mean - patches[pair.b].mean).norm());
      edges_[first_[pair.a + 1]++] = {pair.b, length};
      edges_[first_[pair.b + 1]++] = {pair.a, length};
    }
  }

  /// The edges from a patch, ascending.
  boost::iterator_range<const Edge*> operator[](std::size_t i) const
  {
    return {edges_.data() + first_[i], edges_.data() + first_[i + 1]};
  }

private:
  std::vector<std::size_t> first_; ///< Index of the first edge of each patch.
  std::vector<Edge> edges_;
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_PATCH_GRAPH_H
