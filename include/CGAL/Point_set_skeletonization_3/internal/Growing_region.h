// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_GROWING_REGION_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_GROWING_REGION_H

#include <CGAL/Point_set_skeletonization_3/internal/patch_adjacency.h>
#include <CGAL/Point_set_skeletonization_3/internal/samples.h>

#include <CGAL/assertions.h>

#include <boost/range/iterator_range.hpp>

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

/// Patches that cut the surface around them in two: a ring around a limb, whatever the shape of its
/// cross-section. (Baerentzen & Rotenberg 2021 call it a local separator and find it by growing a
/// region from a point of the surface; we grow it from the centre of the shape, and so closer to a
/// cross-section.)
struct Local_separator
{
  std::vector<std::size_t> patches;              ///< Ascending; empty if there is no separator.
  std::array<std::vector<std::size_t>, 2> sides; ///< Patches next to it on either side, ascending.
  double length = 0;                             ///< Sum of the spacings of its patches.
};

/// Edges between neighbouring patches, those from one patch after the other in memory.
class Patch_edges
{
public:
  struct Edge // small: most of the time of a region goes into reading them
  {
    std::uint32_t patch;
    float length;
  };

  /// All edges.
  explicit Patch_edges(const std::vector<Patch>& patches)
      : Patch_edges(patches, [](std::size_t, std::size_t) { return true; })
  {}

  /// The edges with `has(from, to)`.
  template <typename Predicate>
  Patch_edges(const std::vector<Patch>& patches, const Predicate& has)
      : first_(1, 0)
  {
    CGAL_precondition(patches.size() <= std::numeric_limits<std::uint32_t>::max());
    for(std::size_t i = 0; i < patches.size(); ++i) {
      for(std::size_t j : patches[i].neighbors)
        if(has(i, j))
          edges_.push_back({static_cast<std::uint32_t>(j),
                            static_cast<float>((patches[i].mean - patches[j].mean).norm())});
      first_.push_back(edges_.size());
    }
  }

  /// The edges from a patch, those to lower indices first.
  boost::iterator_range<const Edge*> operator[](std::size_t i) const
  {
    return {edges_.data() + first_[i], edges_.data() + first_[i + 1]};
  }

private:
  std::vector<std::size_t> first_; ///< Of every patch, and the number of edges.
  std::vector<Edge> edges_;
};

/// Patches that a ball around a medial sample holds, as far as they hang together, and their front:
/// the patches next to them. The ball grows until the front falls apart. One object grows one
/// region after the other and visits only what the region reaches.
class Growing_region
{
public:
  Growing_region(const std::vector<Patch>& patches, const Patch_edges& edges,
                 const std::vector<Sample>& samples)
      : patches_(patches)
      , edges_(edges)
      , samples_(samples)
      , label_(patches.size(), outside)
      , distance_(patches.size())
      , nearest_(patches.size())
  {}

  /// The separator through the region that grows from the sample of a patch; an empty one if the
  /// ball becomes larger than anything that a limb at this place can be, or holds half of the
  /// shape: there is no limb here.
  Local_separator separator(std::size_t seed)
  {
    // The ball of a round limb touches it all around; a tenth more holds its ring of patches.
    constexpr double growth = 1.1;
    // The flattest limbs that are seen: their width over their thickness.
    constexpr double flattest = 6;

    center_ = samples_[seed].position;
    const double radius = std::max(samples_[seed].radius, patches_[seed].spacing / 2);
    add_to_front(seed);
    absorb(0);
    Local_separator result;
    bool whole = false; // the front; it cannot fall apart while it stays the same
    for(double reach = growth * radius; reach < flattest * radius; reach *= growth) {
      const std::size_t size = region_.size();
      grow(reach);
      if(front_.empty() || region_.size() > patches_.size() / 2)
        break;
      if(whole && region_.size() == size)
        continue;
      const std::vector<Part> parts = connected_parts();
      whole = parts.empty();
      if(splits(parts)) {
        result = cut(parts);
        break;
      }
    }
    clear();
    return result;
  }

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

  enum Label : char { outside, region, front, part_of_front, between, on_separator };

  void add_to_front(std::size_t i)
  {
    label_[i] = front;
    distance_[i] = (patches_[i].mean - center_).norm();
    front_.push_back(i);
  }

  /// Moves the `k`-th patch of the front into the region.
  void absorb(std::size_t k)
  {
    const std::size_t i = front_[k];
    front_[k] = front_.back();
    front_.pop_back();
    label_[i] = region;
    region_.push_back(i);
    for(const auto& edge : edges_[i])
      if(label_[edge.patch] == outside)
        add_to_front(edge.patch);
  }

  void grow(double reach)
  {
    for(std::size_t k = 0; k < front_.size();)
      if(distance_[front_[k]] <= reach)
        absorb(k);
      else
        ++k;
  }

  void clear()
  {
    for(const std::vector<std::size_t>* visited : {&region_, &front_})
      for(std::size_t i : *visited)
        label_[i] = outside;
    region_.clear();
    front_.clear();
  }

  /// The front in parts that do not hang together, each ascending, the largest first; none if it is
  /// in one piece.
  std::vector<Part> connected_parts()
  {
    std::vector<Part> parts;
    std::vector<std::size_t>& found = found_;
    found.clear();
    for(std::size_t start : front_) {
      if(label_[start] != front)
        continue;
      std::size_t next = found.size();
      const std::size_t first = next;
      const auto add = [&](std::size_t i) {
        label_[i] = part_of_front;
        found.push_back(i);
      };
      for(add(start); next < found.size() && found.size() < front_.size(); ++next)
        for(const auto& edge : edges_[found[next]])
          if(label_[edge.patch] == front)
            add(edge.patch);
      if(found.size() - first < front_.size())
        parts.emplace_back(found.begin() + static_cast<std::ptrdiff_t>(first), found.end());
    }
    for(std::size_t i : front_)
      label_[i] = front;
    for(Part& part : parts)
      std::sort(part.begin(), part.end());
    std::sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) {
      return a.size() != b.size() ? a.size() > b.size() : a < b;
    });
    return parts;
  }

  /// Whether a limb goes on from the region in two directions. More than two make a junction, which
  /// is what the separators around it leave over; a small part of the front is a dent or a bump.
  static bool splits(const std::vector<Part>& parts)
  {
    constexpr double least_share = 0.2; // of the larger: limbs do not taper faster in one ball
    constexpr double junction_share = 0.3;
    const auto share = [&](std::size_t a, std::size_t b) {
      return static_cast<double>(parts[a].size()) / static_cast<double>(parts[b].size());
    };
    return parts.size() >= 2 && share(1, 0) >= least_share &&
           (parts.size() == 2 || share(2, 1) <= junction_share);
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
    const auto in_second_half = [&](const Patch_edges::Edge& edge) {
      return half(edge.patch) == 2;
    };
    for(const std::vector<std::size_t>* visited : {&region_, &front_})
      for(std::size_t i : *visited)
        if(label_[i] == between && half(i) == 1 &&
           std::any_of(edges_[i].begin(), edges_[i].end(), in_second_half))
          add(i);
    for(std::size_t i : parts[0])
      for(const auto& edge : edges_[i])
        if(in_second_half(edge))
          add(edge.patch);
    std::sort(result.patches.begin(), result.patches.end());
    for(std::size_t i : result.patches) {
      result.length += patches_[i].spacing;
      for(const auto& edge : edges_[i])
        if(half(edge.patch) != 0 && label_[edge.patch] != on_separator)
          result.sides[static_cast<std::size_t>(half(edge.patch) - 1)].push_back(edge.patch);
    }
    for(std::vector<std::size_t>& side : result.sides) {
      std::sort(side.begin(), side.end());
      side.erase(std::unique(side.begin(), side.end()), side.end());
    }
    for(const std::vector<std::size_t>* visited : {&region_, &front_})
      for(std::size_t i : *visited)
        nearest_[i] = Nearest();
    return result;
  }

  /// For every patch of the region and its front which of the first two parts is nearer along the
  /// surface; labels those that belong to neither.
  void find_nearest(const std::vector<Part>& parts)
  {
    for(const std::vector<std::size_t>* visited : {&region_, &front_})
      for(std::size_t i : *visited) {
        label_[i] = between;
        nearest_[i].distance = std::numeric_limits<float>::infinity();
      }
    // In the order of the number of steps, which is nearly that of the distance: what has to be
    // corrected costs less than a heap would.
    queue_.clear();
    const auto visit = [&](const Nearest& nearest, std::size_t i) {
      if(nearest < nearest_[i]) {
        nearest_[i] = nearest;
        queue_.emplace_back(nearest.distance, i);
      }
    };
    for(int k = 0; k < 2; ++k)
      for(std::size_t i : parts[static_cast<std::size_t>(k)]) {
        label_[i] = front;
        visit({0, k + 1}, i);
      }
    for(std::size_t next = 0; next < queue_.size(); ++next) {
      const auto [distance, i] = queue_[next];
      const Nearest nearest = nearest_[i];
      if(distance > nearest.distance)
        continue; // came there on a shorter way
      for(const auto& edge : edges_[i])
        visit({nearest.distance + edge.length, nearest.part}, edge.patch);
    }
  }

  const std::vector<Patch>& patches_;
  const Patch_edges& edges_;
  const std::vector<Sample>& samples_;
  Vector3 center_ = Vector3::Zero();
  std::vector<std::size_t> region_; ///< The seed first.
  std::vector<std::size_t> front_;

  // Of every patch; as at the beginning wherever no region is.
  std::vector<Label> label_;
  std::vector<double> distance_; ///< To the centre, of the front.
  std::vector<Nearest> nearest_; ///< Default outside.

  // Memory of `connected_parts()` and `find_nearest()`.
  std::vector<std::size_t> found_;
  std::vector<std::pair<float, std::size_t>> queue_;
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_GROWING_REGION_H
