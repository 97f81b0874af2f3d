// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SEPARATORS_GROWING_REGION_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SEPARATORS_GROWING_REGION_H


#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/medial/Sample.h>
#include <CGAL/Point_set_skeletonization_3/internal/separators/Local_separator.h>
#include <CGAL/Point_set_skeletonization_3/internal/separators/Separator_options.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch.h>
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

/// A list of patches that grows without a branch: which neighbours of a patch are new is anybody's
/// guess, and wrong guesses of the processor would cost more than all the rest.
class Patch_list
{
public:
  /// \pre not longer than `capacity`
  explicit Patch_list(std::size_t capacity) : patches_(capacity + 1) {}

  void push_back_if(bool condition, std::size_t patch)
  {
    patches_[size_] = static_cast<std::uint32_t>(patch);
    size_ += condition;
  }

  std::size_t operator[](std::size_t k) const { return patches_[k]; }
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  const std::uint32_t* begin() const { return patches_.data(); }
  const std::uint32_t* end() const { return patches_.data() + size_; }
  void replace(std::size_t k, std::size_t patch) { patches_[k] = static_cast<std::uint32_t>(patch); }
  /// \pre it is at least as long
  void shorten(std::size_t size) { size_ = size; }

private:
  std::vector<std::uint32_t> patches_;
  std::size_t size_ = 0;
};

/// Patches that a ball around a medial sample holds, as far as they hang together, and their front:
/// the patches next to them. The ball grows until the front falls apart. One object grows one
/// region after the other and visits only what the region reaches.
class Growing_region
{
public:
  Growing_region(const Patches& patches, const Patch_graph& graph,
                 const Samples& samples, const Separator_options& options)
      : options_(options)
      , patches_(patches)
      , graph_(graph)
      , samples_(samples)
      , region_(patches.size())
      , front_(patches.size())
      , squared_distance_(patches.size() + 1)
      , found_(patches.size())
      , label_(patches.size(), outside)
      , nearest_(patches.size())
  {
    for(const Patch& patch : patches)
      means_.push_back(patch.mean);
    for(const Sample& sample : samples)
      positions_.push_back(sample.position);
  }

  /// What a region ended with.
  struct Result
  {
    /// Empty if the ball became larger than anything that a limb at this place can be, or held half
    /// of the shape: there is no limb here.
    Local_separator separator;
    /// Patches off the separator whose regions would end in much the same way.
    std::vector<std::size_t> same;
  };

  /// The separator through the region that grows from the sample of a patch.
  Result grow_from(std::size_t seed)
  {
    // The ball of a round limb touches it all around; a tenth more holds its ring of patches.
    constexpr double growth = 1.1;

    center_ = samples_[seed].position;
    const double radius = std::max(samples_[seed].radius, patches_[seed].spacing / 2);
    region_.push_back_if(true, seed);
    label_[seed] = region;
    add_neighbors_to_front(seed);
    Result result;
    std::size_t size = 0; // of the region when its front was last looked at
    bool is_in_one_piece = true; // its front, as far as it was looked at, but for little
    bool is_bounded = true;      // it holds less than half of the shape
    for(double reach = growth * radius; reach < options_.flattest * radius; reach *= growth) {
      grow(reach);
      is_bounded = !front_.empty() && region_.size() <= patches_.size() / 2;
      if(!is_bounded)
        break;
      if(region_.size() == size)
        continue;
      size = region_.size();
      const std::vector<Part> parts = connected_parts();
      is_in_one_piece = is_in_one_piece && parts.empty();
      if(splits(parts)) {
        result.separator = cut(parts);
        break;
      }
    }
    // A sheet may be thinner than its patches are wide. Where a limb is, every ring may count.
    const bool is_sheet = is_bounded && is_in_one_piece;
    const double same =
      std::max(options_.same_place * radius, is_sheet ? same_patch * patches_[seed].spacing : 0);
    for(std::size_t i : region_)
      if(label_[i] != on_separator && (positions_[i] - center_).squaredNorm() < same * same)
        result.same.push_back(i);
    clear();
    return result;
  }

  /// Half of the diagonal of a patch, in spacings.
  static constexpr double same_patch = 0.7;

private:
  using Part = std::vector<std::size_t>;

  /// The nearer of two parts along the surface, 1 or 2, and its distance; nothing is nearer than
  /// the default.
  struct Nearest
  {
    float distance = 0;
    int part = 0;
    bool operator<(const Nearest& other) const
    {
      return distance < other.distance || (distance == other.distance && part < other.part);
    }
  };

  enum Label : char { outside, region, front, part_of_front, between, on_separator, beside };

  /// `to` if `condition`, else `label`; without a branch, as above, whatever a compiler thinks best.
  static Label changed_if(bool condition, Label label, Label to)
  {
    return static_cast<Label>(label ^ ((label ^ to) & -static_cast<int>(condition)));
  }

  void add_neighbors_to_front(std::size_t i)
  {
    const std::size_t first = front_.size();
    for(const auto& edge : graph_[i]) {
      Label& label = label_[edge.patch];
      const bool is_new = label == outside;
      front_.push_back_if(is_new, edge.patch);
      label = changed_if(is_new, label, front);
    }
    for(std::size_t k = first; k < front_.size(); ++k)
      squared_distance_[k] = (means_[front_[k]] - center_).squaredNorm();
  }

  /// Moves what the ball holds from the front into the region, and what is next to that into the
  /// front.
  void grow(double reach)
  {
    std::size_t kept = 0;
    for(std::size_t next = 0; next < front_.size();) { // what was added last
      std::size_t held = region_.size();
      for(const std::size_t end = front_.size(); next < end; ++next) {
        const std::size_t i = front_[next];
        const double squared_distance = squared_distance_[next];
        const bool holds = squared_distance <= reach * reach;
        region_.push_back_if(holds, i);
        front_.replace(kept, i);
        squared_distance_[kept] = squared_distance;
        kept += !holds;
      }
      for(; held < region_.size(); ++held) {
        label_[region_[held]] = region;
        add_neighbors_to_front(region_[held]);
      }
    }
    front_.shorten(kept);
  }

  /// Calls `visit(i)` for every patch of the region and then of the front.
  template <typename Visit>
  void visit_all(const Visit& visit) const
  {
    for(std::size_t i : region_)
      visit(i);
    for(std::size_t i : front_)
      visit(i);
  }

  void clear()
  {
    visit_all([&](std::size_t i) { label_[i] = outside; });
    region_.shorten(0);
    front_.shorten(0);
  }

  /// The front in parts that do not hang together, the largest first; none if what is beside the
  /// largest is too little for a limb.
  std::vector<Part> connected_parts()
  {
    std::vector<Part> parts;
    const double enough = static_cast<double>(front_.size()) / (1 + options_.least_share);
    bool splits = true;
    found_.shorten(0);
    const auto add = [&](std::size_t i) {
      const bool is_new = label_[i] == front;
      found_.push_back_if(is_new, i);
      label_[i] = changed_if(is_new, label_[i], part_of_front);
    };
    for(std::size_t start : front_) {
      if(label_[start] != front)
        continue;
      const std::size_t first = found_.size();
      add(start);
      for(std::size_t next = first; next < found_.size() && splits; ++next) {
        for(const auto& edge : graph_[found_[next]])
          add(edge.patch);
        splits = static_cast<double>(found_.size() - first) <= enough;
      }
      if(!splits)
        break;
      parts.emplace_back(found_.begin() + first, found_.end());
    }
    for(std::size_t i : front_)
      label_[i] = front;
    if(!splits)
      return {};
    std::stable_sort(parts.begin(), parts.end(),
                     [](const Part& a, const Part& b) { return a.size() > b.size(); });
    return parts;
  }

  /// Whether a limb goes on from the region in two directions, and no more.
  bool splits(const std::vector<Part>& parts) const
  {
    const auto share = [&](std::size_t a, std::size_t b) {
      return static_cast<double>(parts[a].size()) / static_cast<double>(parts[b].size());
    };
    return parts.size() >= 2 && share(1, 0) >= options_.least_share &&
           (parts.size() == 2 || share(2, 1) <= options_.junction_share);
  }

  /// The patches halfway between the first two parts: those of the one half next to the other.
  Local_separator cut(const std::vector<Part>& parts)
  {
    find_nearest(parts);
    const auto half = [&](std::size_t i) { return nearest_[i].part; };
    Local_separator result;
    const auto add = [&](std::size_t i) { // not of the parts themselves
      if(label_[i] != between)
        return;
      label_[i] = on_separator;
      result.patches.push_back(i);
    };
    // Of the first half what touches the second; of the second what touches the first part.
    const auto in_second_half = [&](const Patch_graph::Edge& edge) {
      return half(edge.patch) == 2;
    };
    visit_all([&](std::size_t i) {
      if(label_[i] == between && half(i) == 1 &&
         std::any_of(graph_[i].begin(), graph_[i].end(), in_second_half))
        add(i);
    });
    for(std::size_t i : parts[0])
      for(const auto& edge : graph_[i])
        if(in_second_half(edge))
          add(edge.patch);
    std::sort(result.patches.begin(), result.patches.end());
    for(std::size_t i : result.patches) {
      result.length += patches_[i].spacing;
      for(const auto& edge : graph_[i])
        if(half(edge.patch) != 0 && label_[edge.patch] < on_separator) {
          label_[edge.patch] = beside;
          result.sides[static_cast<std::size_t>(half(edge.patch) - 1)].push_back(edge.patch);
        }
    }
    for(std::vector<std::size_t>& side : result.sides)
      std::sort(side.begin(), side.end());
    visit_all([&](std::size_t i) { nearest_[i] = Nearest(); });
    return result;
  }

  /// For every patch of the region and its front which of the first two parts is nearer along the
  /// surface; labels those that belong to neither.
  void find_nearest(const std::vector<Part>& parts)
  {
    visit_all([&](std::size_t i) {
      label_[i] = between;
      nearest_[i].distance = std::numeric_limits<float>::infinity();
    });
    // In the order of the number of steps, which is nearly that of the distance: what has to be
    // corrected costs less than a heap would.
    queue_.clear();
    Nearest* const known = nearest_.data();
    const auto visit = [this, known](float distance, int part, std::uint32_t i) {
      const Nearest nearest{distance, part};
      if(nearest < known[i]) {
        known[i] = nearest;
        queue_.emplace_back(distance, i);
      }
    };
    for(int k = 0; k < 2; ++k)
      for(std::size_t i : parts[static_cast<std::size_t>(k)]) {
        label_[i] = front;
        visit(0, k + 1, static_cast<std::uint32_t>(i));
      }
    for(std::size_t next = 0; next < queue_.size(); ++next) {
      const auto [distance, i] = queue_[next];
      const int part = known[i].part;
      if(distance > known[i].distance)
        continue; // reached on a shorter path
      for(const auto& edge : graph_[i])
        visit(distance + edge.length, part, edge.patch);
    }
  }

  const Separator_options& options_;
  const Patches& patches_;
  const Patch_graph& graph_;
  const Samples& samples_;
  Vector3 center_ = Vector3::Zero();
  Patch_list region_; ///< The seed first.
  Patch_list front_;
  std::vector<double> squared_distance_; ///< To the centre, of the front.
  Patch_list found_; ///< In `connected_parts()`.

  // Of every patch and its sample, as they are read most often: those in a row are in the cache.
  std::vector<Vector3> means_, positions_;

  // Of every patch; as at the beginning wherever no region is.
  std::vector<Label> label_;
  std::vector<Nearest> nearest_; ///< Default outside.

  std::vector<std::pair<float, std::uint32_t>> queue_; ///< Of `find_nearest()`.
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SEPARATORS_GROWING_REGION_H
