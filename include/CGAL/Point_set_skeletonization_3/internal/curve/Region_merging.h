// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_REGION_MERGING_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_REGION_MERGING_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Union_find.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Two adjacent patches in different regions of a surface.
struct Border_link
{
  std::size_t a, b; ///< Regions.
  std::size_t patch_a, patch_b;
  double overlap;   ///< Of their medial balls, in [0, 1].
  bool is_measured; ///< Whether both patches have a ball of their own, so that it is no guess.

  /// Greater overlap comes first.
  bool operator<(const Border_link& other) const
  {
    return std::tie(other.overlap, patch_a, patch_b) <
           std::tie(overlap, other.patch_a, other.patch_b);
  }
};

/// The overlap of each patch along a border with whichever on the other side overlaps most.
class Best_overlaps
{
public:
  /// Of no patch.
  Best_overlaps() = default;

  /// Of the patches of a link.
  explicit Best_overlaps(const Border_link& link)
    : best_{{link.patch_a, link.overlap}, {link.patch_b, link.overlap}}
  {
    std::sort(best_.begin(), best_.end());
  }

  bool empty() const { return best_.empty(); }

  /// Adds those along another part of the border. O(patches of both).
  void add(const Best_overlaps& other)
  {
    std::vector<Best> all;
    all.reserve(best_.size() + other.best_.size());
    std::merge(best_.begin(), best_.end(), other.best_.begin(), other.best_.end(),
               std::back_inserter(all));
    best_.clear();
    for(const Best& next : all) // of equal patches the greatest overlap is last
      if(!best_.empty() && best_.back().first == next.first)
        best_.back().second = next.second;
      else
        best_.push_back(next);
  }

  /// The greatest. O(patches). \pre there is one
  double greatest() const
  {
    double result = 0;
    for(const Best& best : best_)
      result = (std::max)(result, best.second);
    return result;
  }

  /// The mean and its standard error, since borders of thin limbs have few patches; at most 1.
  /// O(patches). \pre there is one
  double mean_and_error() const
  {
    const double number = static_cast<double>(best_.size());
    double sum = 0, squares = 0;
    for(const Best& best : best_) {
      sum += best.second;
      squares += best.second * best.second;
    }
    const double mean = sum / number, variance = (std::max)(0.0, squares / number - mean * mean);
    return (std::min)(1.0, mean + std::sqrt(variance / number));
  }

private:
  using Best = std::pair<std::size_t, double>; ///< A patch and its greatest overlap.

  std::vector<Best> best_; ///< By patch.
};

/// The border of two regions.
class Border
{
public:
  /// The border of a single link.
  explicit Border(const Border_link& link)
    : all_(link), measured_(link.is_measured ? Best_overlaps(link) : Best_overlaps())
  {}

  /// Adds another part of the border. O(patches of both).
  void add(const Border& other)
  {
    all_.add(other.all_);
    measured_.add(other.measured_);
    links_ += other.links_;
  }

  /// How much the regions may overlap along it by what is measured, in [0, 1]. O(patches).
  double measured_overlap() const { return measured_.empty() ? 0 : measured_.mean_and_error(); }

  /// The same, guesses included: around a joint of limbs hardly wider than their spacing one pair of
  /// fifty may be measured, and wrong. If none is measured, the best guess. O(patches).
  double guessed_overlap() const
  {
    return measured_.empty() ? all_.greatest() : all_.mean_and_error();
  }

  /// The number of links: it grows whenever a part is added.
  std::size_t links() const { return links_; }

private:
  Best_overlaps all_, measured_;
  std::size_t links_ = 1;
};

/// Merges regions across borders along which they overlap, those first that overlap most, until
/// none overlaps enough: agglomerative merging of a region adjacency graph by the mean strength of
/// borders, as in image segmentation (Arbelaez, Boundary extraction in natural images using
/// ultrametric contour maps, 2006). Borders that do not overlap enough by what is measured come
/// last; there guesses count as well.
///
/// The border as a whole decides, not its strongest link: where two limbs touch, normals are
/// unreliable, and a few of many pairs across the contact always look like one limb.
class Region_merging
{
public:
  /// Refers to `sets`, whose numbers are regions. O(links log links).
  /// \param least_overlap of a border that regions are merged across, in [0, 1]
  Region_merging(Union_find& sets, std::size_t number_of_regions,
                 const std::vector<Border_link>& links, double least_overlap)
    : sets_(sets), neighbors_(number_of_regions), is_merged_(number_of_regions, false),
      least_overlap_(least_overlap)
  {
    for(const Border_link& link : links)
      add(sets.find(link.a), sets.find(link.b), Border(link));
    for(std::size_t a = 0; a < number_of_regions; ++a)
      for(const auto& [b, border] : neighbors_[a])
        if(a < b)
          wait(a, b, borders_[border]);
  }

  /// Joins the sets. To be called once. O(links log² links) in practice.
  void run()
  {
    while(!queue_.empty()) {
      const auto [is_certain, overlap, a, b, links] = queue_.top();
      queue_.pop();
      if(!is_merged_[a] && !is_merged_[b] && borders_[neighbors_[a].at(b)].links() == links)
        neighbors_[a].size() < neighbors_[b].size() ? merge(a, b) : merge(b, a);
    }
  }

private:
  /// Whether it is measured that a border overlaps enough, its overlap and regions, and its links
  /// when that was computed.
  using Waiting = std::tuple<bool, double, std::size_t, std::size_t, std::size_t>;

  void add(std::size_t a, std::size_t b, const Border& part)
  {
    if(a == b)
      return;
    const auto [found, is_new] = neighbors_[a].emplace(b, borders_.size());
    if(is_new) {
      neighbors_[b].emplace(a, borders_.size());
      borders_.push_back(part);
    } else
      borders_[found->second].add(part);
  }

  void wait(std::size_t a, std::size_t b, const Border& border)
  {
    const double measured = border.measured_overlap();
    const bool is_certain = measured >= least_overlap_;
    const double overlap = is_certain ? measured : border.guessed_overlap();
    if(overlap >= least_overlap_)
      queue_.emplace(is_certain, overlap, a, b, border.links());
  }

  /// Region `a` becomes part of its neighbour `b`.
  void merge(std::size_t a, std::size_t b)
  {
    sets_.join(a, b);
    is_merged_[a] = true;
    for(const auto& [other, border] : neighbors_[a]) {
      neighbors_[other].erase(a);
      if(other == b)
        continue;
      const auto [found, is_new] = neighbors_[b].emplace(other, border);
      if(is_new)
        neighbors_[other].emplace(b, border);
      else
        borders_[found->second].add(borders_[border]);
      wait(b, other, borders_[found->second]);
    }
    neighbors_[a].clear();
  }

  Union_find& sets_;
  std::vector<std::map<std::size_t, std::size_t>> neighbors_; ///< Region to index of the border.
  std::vector<Border> borders_;
  std::vector<bool> is_merged_; ///< Whether a region has become part of another.
  double least_overlap_;
  std::priority_queue<Waiting> queue_; ///< What is certain first, then the greatest overlap.
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_REGION_MERGING_H
