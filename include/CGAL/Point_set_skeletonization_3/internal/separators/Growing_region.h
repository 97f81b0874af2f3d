// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SEPARATORS_GROWING_REGION_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SEPARATORS_GROWING_REGION_H


#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/medial/Sample.h>
#include <CGAL/Point_set_skeletonization_3/internal/separators/Front_gaps.h>
#include <CGAL/Point_set_skeletonization_3/internal/separators/Local_separator.h>
#include <CGAL/Point_set_skeletonization_3/internal/separators/Separator_options.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch_graph.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// A list of patches of fixed capacity, filled without branches: whether a neighbour is new is
/// unpredictable, and branch mispredictions would take most of the time.
class Patch_list
{
public:
  /// \pre `size()` never exceeds `capacity`
  explicit Patch_list(std::size_t capacity) : patches_(capacity + 1) {}

  /// Appends `patch` if `condition`.
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
  void replace(std::size_t k, std::size_t patch)
  {
    patches_[k] = static_cast<std::uint32_t>(patch);
  }
  /// Keeps the first `size` patches. \pre `size <= this->size()`
  void shorten(std::size_t size) { size_ = size; }

private:
  std::vector<std::uint32_t> patches_;
  std::size_t size_ = 0;
};

/// The patches inside a ball around a medial sample that are connected to its patch, and their
/// front: the adjacent patches outside. The ball grows until the front splits. One object grows one
/// region after another; the time of each depends on the patches that it reaches only.
class Growing_region
{
public:
  /// Refers to all arguments. O(n).
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
      , gaps_(graph, patches.size())
      , label_(patches.size(), outside)
      , nearest_(patches.size())
  {
    for(const Patch& patch : patches) {
      means_.push_back(patch.mean);
      areas_.push_back(static_cast<float>(patch.area));
      total_area_ += patch.area;
    }
    for(const Sample& sample : samples)
      positions_.push_back(sample.position);
  }

  /// The result of growing a region.
  struct Result
  {
    /// Empty if there is no limb here: the ball exceeds the flattest possible limb, or the region
    /// half of the shape.
    Local_separator separator;
    /// Patches off the separator whose regions would end alike.
    std::vector<std::size_t> same;
  };

  /// Grows a region from the sample of patch `seed` and returns the separator through it.
  Result grow_from(std::size_t seed)
  {
    // The ball of a round limb touches it all around; with 10 % more it contains the ring of
    // patches.
    constexpr double growth = 1.1;

    center_ = samples_[seed].position;
    const double radius = (std::max)(samples_[seed].radius, patches_[seed].spacing / 2);
    add_to_region(seed);
    area_ = static_cast<double>(areas_[seed]);
    add_neighbors_to_front(seed);
    Result result;
    std::size_t size = 0; // of the region when its front was tested last
    bool is_in_one_piece = true; // all fronts so far were connected, except for small parts
    bool is_bounded = true;      // the region has a front and at most half of the shape
    const double limit = is_on_sheet(seed) ? std::numeric_limits<double>::infinity()
                                           : options_.flattest * radius;
    for(double reach = growth * radius; reach < limit; reach *= growth) {
      grow(reach);
      is_bounded = !front_.empty() && area_ <= total_area_ / 2;
      if(!is_bounded)
        break;
      if(region_.size() == size)
        continue;
      size = region_.size();
      const std::vector<Front_part> parts = parts_without_gaps();
      is_in_one_piece = is_in_one_piece && parts.empty();
      if(splits(parts)) {
        result.separator = cut(parts);
        break;
      }
    }
    // On a sheet, perhaps thinner than its patches are wide, fewer seeds do; on a limb each ring
    // counts.
    const bool is_sheet = is_bounded && is_in_one_piece;
    const double same =
      (std::max)(options_.same_place * radius, is_sheet ? same_patch * patches_[seed].spacing : 0);
    for(std::size_t i : region_)
      if(label_[i] != on_separator && (positions_[i] - center_).squaredNorm() < same * same)
        result.same.push_back(i);
    clear();
    return result;
  }

  /// Returns the separator through a ring of connected patches: the region grows from them, layer
  /// by layer, until its front splits. Empty if that takes more layers than a ring is uneven.
  Local_separator grow_from_ring(const std::vector<std::size_t>& ring)
  {
    constexpr int layers = 3;
    for(std::size_t i : ring)
      add_to_region(i);
    for(std::size_t i : ring)
      add_neighbors_to_front(i);
    Local_separator result;
    for(int layer = 0; layer < layers; ++layer) {
      const std::vector<Front_part> parts = connected_parts();
      if(splits(parts)) {
        result = cut(parts);
        break;
      }
      const std::size_t first = region_.size();
      for(std::size_t i : front_)
        add_to_region(i);
      front_.shorten(0);
      for(std::size_t k = first; k < region_.size(); ++k)
        add_neighbors_to_front(region_[k]);
    }
    clear();
    return result;
  }

  /// Returns the separator halfway between two borders of some patches, whose sides are in the
  /// order of the borders; patches on the borders are among them or beside them.
  Local_separator halfway(const std::vector<std::size_t>& patches,
                          const std::array<std::vector<std::size_t>, 2>& borders)
  {
    for(std::size_t i : patches)
      add_to_region(i);
    const Local_separator result = cut({{borders[0], 0}, {borders[1], 0}});
    clear();
    return result;
  }

  /// Half of the diagonal of a patch, in spacings.
  static constexpr double same_patch = 0.7;

private:
  /// The nearer of two parts of the front, 1 or 2, and its distance along the surface. The default
  /// is less than any other.
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

  /// `to` if `condition`, else `label`; branchless with every compiler.
  static Label changed_if(bool condition, Label label, Label to)
  {
    return static_cast<Label>(label ^ ((label ^ to) & -static_cast<int>(condition)));
  }

  /// Whether a patch is part of a sheet: there is no thickness that its width could be compared
  /// with.
  bool is_on_sheet(std::size_t i) const
  {
    return samples_[i].radius == 0 && coplanarity(patches_[i], patches_[i]) >= options_.overlap;
  }

  void add_to_region(std::size_t i)
  {
    region_.push_back_if(true, i);
    label_[i] = region;
  }

  /// Adds the new neighbours of a patch to the front.
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

  /// Moves the patches inside the ball of radius `reach` from the front to the region, and their
  /// new neighbours to the front.
  void grow(double reach)
  {
    std::size_t kept = 0;
    for(std::size_t next = 0; next < front_.size();) { // one layer of the breadth-first search
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
        area_ += static_cast<double>(areas_[region_[held]]);
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

  /// Empties region and front.
  void clear()
  {
    visit_all([&](std::size_t i) { label_[i] = outside; });
    region_.shorten(0);
    front_.shorten(0);
  }

  /// The same as `connected_parts()`, gaps closed.
  std::vector<Front_part> parts_without_gaps()
  {
    const std::vector<Front_part> parts = connected_parts();
    if(parts.empty())
      return parts;
    const auto is_inside = [this](std::size_t i) { return label_[i] == region; };
    return if_divided(gaps_.close(parts, front_, is_inside), options_.least_share);
  }

  /// The connected components of the front, the largest first; none if the others together are
  /// smaller than `least_share` of the largest. Linear in the front and its edges.
  std::vector<Front_part> connected_parts()
  {
    std::vector<Front_part> parts;
    double enough = 0;
    for(std::size_t i : front_)
      enough += static_cast<double>(areas_[i]);
    enough /= 1 + options_.least_share;
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
      double area = 0;
      for(std::size_t next = first; next < found_.size() && splits; ++next) {
        for(const auto& edge : graph_[found_[next]])
          add(edge.patch);
        area += static_cast<double>(areas_[found_[next]]);
        splits = area <= enough;
      }
      if(!splits)
        break;
      parts.push_back({{found_.begin() + first, found_.end()}, area});
    }
    for(std::size_t i : front_)
      label_[i] = front;
    return splits ? if_divided(std::move(parts), options_.least_share) : std::vector<Front_part>();
  }

  /// Whether the limb continues from the region in exactly two directions.
  bool splits(const std::vector<Front_part>& parts) const
  {
    const auto share = [&](std::size_t a, std::size_t b) {
      return parts[a].area / parts[b].area;
    };
    return parts.size() >= 2 && share(1, 0) >= options_.least_share &&
           (parts.size() == 2 || share(2, 1) <= options_.least_share);
  }

  /// The separator halfway between the first two parts: patches of one half adjacent to the other.
  Local_separator cut(const std::vector<Front_part>& parts)
  {
    find_nearest(parts);
    const auto half = [&](std::size_t i) { return nearest_[i].part; };
    Local_separator result;
    const auto add = [&](std::size_t i) { // patches of the parts are not on the separator
      if(label_[i] != between)
        return;
      label_[i] = on_separator;
      result.patches.push_back(i);
    };
    // Patches of the first half adjacent to the second, and of the second half to the first part.
    const auto in_second_half = [&](const Patch_graph::Edge& edge) {
      return half(edge.patch) == 2;
    };
    visit_all([&](std::size_t i) {
      if(label_[i] == between && half(i) == 1 &&
         std::any_of(graph_[i].begin(), graph_[i].end(), in_second_half))
        add(i);
    });
    for(std::size_t i : parts[0].patches)
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

  /// Finds the nearer of the first two parts, along the surface, for each patch of the region and
  /// its front. Labels patches of neither part as `between`.
  void find_nearest(const std::vector<Front_part>& parts)
  {
    visit_all([&](std::size_t i) {
      label_[i] = between;
      nearest_[i].distance = std::numeric_limits<float>::infinity();
    });
    // By number of edges, which is nearly the order of distance: corrections cost less than a heap.
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
      for(std::size_t i : parts[static_cast<std::size_t>(k)].patches) {
        label_[i] = front;
        visit(0, k + 1, static_cast<std::uint32_t>(i));
      }
    for(std::size_t next = 0; next < queue_.size(); ++next) {
      const auto [distance, i] = queue_[next];
      const int part = known[i].part;
      if(distance > known[i].distance)
        continue; // a shorter path was found
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
  double area_ = 0;   ///< Of the region.
  Patch_list front_;
  std::vector<double> squared_distance_; ///< From the centre to the front.
  Patch_list found_; ///< Scratch memory of `connected_parts()`.
  Front_gaps gaps_;

  // Copies of what is read most often, contiguous for the cache.
  std::vector<Vector3> means_, positions_;
  std::vector<float> areas_;
  double total_area_ = 0;

  // For each patch; default outside the region.
  std::vector<Label> label_;
  std::vector<Nearest> nearest_; ///< Default outside `cut()`.

  std::vector<std::pair<float, std::uint32_t>> queue_; ///< Scratch memory of `find_nearest()`.
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SEPARATORS_GROWING_REGION_H
