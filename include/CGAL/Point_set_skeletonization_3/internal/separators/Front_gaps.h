// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SEPARATORS_FRONT_GAPS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SEPARATORS_FRONT_GAPS_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Union_find.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch_graph.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// A connected component of the front of a region.
struct Front_part
{
  std::vector<std::size_t> patches;
  double area = 0; ///< Patches may be of different size.
};

/// Returns the parts of a front, the largest first; none if the others together are smaller than
/// `least_share` of the largest. O(n log n).
inline std::vector<Front_part> if_divided(std::vector<Front_part> parts, double least_share)
{
  std::stable_sort(parts.begin(), parts.end(), [](const Front_part& a, const Front_part& b) {
    return a.area > b.area;
  });
  double others = 0;
  for(std::size_t k = 1; k < parts.size(); ++k)
    others += parts[k].area;
  if(!parts.empty() && others < least_share * parts[0].area)
    parts.clear();
  return parts;
}

/// Tells gaps of a front from the two sides of a limb.
///
/// A front surrounds its region, but of two patches that follow each other on it, many are not
/// adjacent: of regions on an irregular flat sheet whose patches have seven neighbours, nearly all
/// had a front in several parts, as if there were a limb. In a gap there is a short way from one
/// patch to the other on both sides of the front. Where a region surrounds a limb, there is none
/// outside but around a hole of the shape, and if that is short, the one inside is not.
class Front_gaps
{
public:
  /// Refers to the graph, of `n` patches. O(n).
  Front_gaps(const Patch_graph& graph, std::size_t n)
    : graph_(graph), part_(n, 0), source_(n, none), is_seen_(n, false)
  {}

  /// Returns the parts of a front with those joined that have only a gap between them.
  /// O(k log k) for k patches of the front.
  /// \param front the patches of all parts, in the order in which the region met them: ways
  ///        outside begin at the first one that is beside them, and so do not all begin at one part
  /// \param is_inside whether a patch is in the region
  template <typename Front, typename IsInside>
  std::vector<Front_part> close(const std::vector<Front_part>& parts, const Front& front,
                                const IsInside& is_inside)
  {
    for(std::size_t k = 0; k < parts.size(); ++k)
      for(std::size_t i : parts[k].patches)
        part_[i] = static_cast<std::uint32_t>(k);
    find_short_outside(front, is_inside);
    Union_find whole(parts.size());
    for(std::size_t k = 0; k < pairs_.size(); ++k) {
      const auto [a, b] = pairs_[k];
      if(k == 0 || a != pairs_[k - 1].first)
        spread_inside(a, is_inside);
      if(whole.find(part_[a]) != whole.find(part_[b]) && is_beside_seen(b))
        whole.join(part_[a], part_[b]);
    }
    forget_seen();
    return united(parts, whole);
  }

private:
  static constexpr std::uint32_t none = (std::numeric_limits<std::uint32_t>::max)();

  // Patches on a way beside a gap; outside two layers, which are up to four. With fewer, many gaps
  // of irregular patches stay open; with more, ways lead around the holes of thick handles.
  static constexpr int layers_outside = 2;
  static constexpr int most_inside = 3;

  /// Finds pairs of patches of different parts with a short way outside.
  template <typename Front, typename IsInside>
  void find_short_outside(const Front& front, const IsInside& is_inside)
  {
    pairs_.clear();
    for(std::uint32_t i : front)
      reach(i, i);
    std::size_t next = 0;
    for(int layer = 0; layer <= layers_outside; ++layer)
      for(const std::size_t end = reached_.size(); next < end; ++next) {
        const std::uint32_t i = reached_[next], a = source_[i];
        for(const auto& edge : graph_[i]) {
          const std::uint32_t b = source_[edge.patch];
          if(b == none) {
            if(layer < layers_outside && !is_inside(edge.patch))
              reach(edge.patch, a);
          } else if(part_[a] < part_[b])
            pairs_.emplace_back(a, b);
          else if(part_[b] < part_[a])
            pairs_.emplace_back(b, a);
        }
      }
    for(std::uint32_t i : reached_)
      source_[i] = none;
    reached_.clear();
    std::sort(pairs_.begin(), pairs_.end());
    pairs_.erase(std::unique(pairs_.begin(), pairs_.end()), pairs_.end());
  }

  /// Adds a patch that is reached from one of the front.
  void reach(std::uint32_t i, std::uint32_t source)
  {
    source_[i] = source;
    reached_.push_back(i);
  }

  /// Marks the patches inside, a short way from one of the front, as seen, and no others.
  template <typename IsInside> void spread_inside(std::uint32_t a, const IsInside& is_inside)
  {
    forget_seen();
    const auto see_beside = [&](std::uint32_t i) {
      for(const auto& edge : graph_[i])
        if(!is_seen_[edge.patch] && is_inside(edge.patch)) {
          is_seen_[edge.patch] = true;
          seen_.push_back(edge.patch);
        }
    };
    see_beside(a);
    std::size_t next = 0;
    for(int length = 1; length < most_inside; ++length)
      for(const std::size_t end = seen_.size(); next < end; ++next)
        see_beside(seen_[next]);
  }

  void forget_seen()
  {
    for(std::uint32_t i : seen_)
      is_seen_[i] = false;
    seen_.clear();
  }

  bool is_beside_seen(std::uint32_t b) const
  {
    return std::any_of(graph_[b].begin(), graph_[b].end(),
                       [&](const auto& edge) { return is_seen_[edge.patch]; });
  }

  /// The united parts.
  static std::vector<Front_part> united(const std::vector<Front_part>& parts, Union_find& whole)
  {
    std::vector<Front_part> result(parts.size());
    for(std::size_t k = 0; k < parts.size(); ++k) {
      Front_part& part = result[whole.find(k)];
      part.area += parts[k].area;
      part.patches.insert(part.patches.end(), parts[k].patches.begin(), parts[k].patches.end());
    }
    const auto is_empty = [](const Front_part& part) { return part.patches.empty(); };
    result.erase(std::remove_if(result.begin(), result.end(), is_empty), result.end());
    return result;
  }

  const Patch_graph& graph_;

  // For each patch.
  std::vector<std::uint32_t> part_;   ///< Of those on the front.
  std::vector<std::uint32_t> source_; ///< On the front, from which it was reached, or `none`.
  std::vector<bool> is_seen_;

  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs_;
  std::vector<std::uint32_t> reached_, seen_;
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SEPARATORS_FRONT_GAPS_H
