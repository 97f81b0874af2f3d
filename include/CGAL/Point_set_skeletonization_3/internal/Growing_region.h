// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_GROWING_REGION_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_GROWING_REGION_H

#include <CGAL/Point_set_skeletonization_3/internal/Connectivity.h>
#include <CGAL/Point_set_skeletonization_3/internal/patch_adjacency.h>
#include <CGAL/Point_set_skeletonization_3/internal/samples.h>

#include <boost/range/iterator_range.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <queue>
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

/// The neighbours of every patch one after the other in memory, with their distances.
class Patch_edges
{
public:
  struct Edge
  {
    std::size_t patch;
    double length;
  };

  explicit Patch_edges(const std::vector<Patch>& patches)
      : first_(1, 0)
  {
    for(const Patch& patch : patches) {
      for(std::size_t j : patch.neighbors)
        edges_.push_back({j, (patch.mean - patches[j].mean).norm()});
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
    for(reach_ = growth * radius; reach_ < flattest * radius; reach_ *= growth) {
      const std::size_t size = region_.size();
      grow();
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
    double distance = 0;
    int part = 0;
    bool operator<(const Nearest& other) const
    {
      return distance < other.distance || (distance == other.distance && part < other.part);
    }
  };

  // Labels of patches; those of the front are numbered by part while it is looked at in parts.
  static constexpr std::size_t outside = std::numeric_limits<std::size_t>::max();
  static constexpr std::size_t region = outside - 1;
  static constexpr std::size_t front = outside - 2;
  static bool is_part(std::size_t label) { return label < front; }

  double distance_to_center(std::size_t i) const { return (patches_[i].mean - center_).norm(); }

  void add_to_front(std::size_t i)
  {
    label_[i] = front;
    distance_[i] = distance_to_center(i);
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

  void grow()
  {
    for(std::size_t k = 0; k < front_.size();)
      if(distance_[front_[k]] <= reach_)
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
  /// in one piece. Parts that the patches beyond connect, within not much more than the ball, are
  /// one: the region went around a hole of the data.
  std::vector<Part> connected_parts()
  {
    const std::vector<std::size_t> sizes = label_front();
    std::vector<Part> parts;
    if(sizes.size() > 1) {
      Connectivity joined(sizes.size());
      if(!join_beyond(sizes, joined)) {
        parts.resize(sizes.size());
        for(std::size_t i : front_)
          parts[joined.root(label_[i])].push_back(i);
      }
    }
    for(std::size_t k = 0; k < labelled_.size(); ++k)
      label_[labelled_[k]] = k < front_.size() ? front : outside;
    labelled_.clear();

    parts.erase(std::remove(parts.begin(), parts.end(), Part()), parts.end());
    for(Part& part : parts)
      std::sort(part.begin(), part.end());
    std::sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) {
      return a.size() != b.size() ? a.size() > b.size() : a < b;
    });
    return parts;
  }

  void label(std::size_t i, std::size_t part)
  {
    label_[i] = part;
    labelled_.push_back(i);
  }

  /// Labels what hangs together in the front itself; returns the number of patches of every part.
  std::vector<std::size_t> label_front()
  {
    std::vector<std::size_t> sizes;
    for(std::size_t start : front_) {
      if(label_[start] != front)
        continue;
      const std::size_t part = sizes.size(), before = labelled_.size();
      label(start, part);
      for(std::size_t next = before; next < labelled_.size() && labelled_.size() < front_.size();
          ++next)
        for(const auto& edge : edges_[labelled_[next]])
          if(label_[edge.patch] == front)
            label(edge.patch, part);
      sizes.push_back(labelled_.size() - before);
    }
    return sizes;
  }

  /// Joins the parts that the patches beyond the front connect; true if that makes them all one.
  /// Every part but the largest looks for others, until it is one with the largest.
  bool join_beyond(const std::vector<std::size_t>& sizes, Connectivity& joined)
  {
    // The way around a hole of the data as wide as the limb is in a ball of 1.4 times its radius,
    // the way around a hole of the shape is not.
    constexpr double detour = 1.5;
    constexpr double few_patches = 4;
    const double shell =
        std::max(detour * reach_, reach_ + few_patches * patches_[region_.front()].spacing);

    const auto largest =
        static_cast<std::size_t>(std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
    std::size_t parts = sizes.size();
    for(std::size_t next = 0; next < labelled_.size() && parts > 1; ++next) {
      const std::size_t part = label_[labelled_[next]];
      if(joined.root(part) == joined.root(largest))
        continue;
      for(const auto& edge : edges_[labelled_[next]]) {
        const std::size_t j = edge.patch, other = label_[j];
        if(other == outside && distance_to_center(j) <= shell)
          label(j, part);
        else if(is_part(other) && other != part && joined.join(part, other))
          --parts;
      }
    }
    return parts == 1;
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
    const auto beyond = [&](std::size_t i) {
      return std::binary_search(parts[0].begin(), parts[0].end(), i) ||
             std::binary_search(parts[1].begin(), parts[1].end(), i);
    };
    // Of the first half what touches the second; of the second what touches the first part.
    Local_separator result;
    const auto in_second_half = [&](const Patch_edges::Edge& edge) {
      return half(edge.patch) == 2;
    };
    for(const std::vector<std::size_t>* visited : {&region_, &front_})
      for(std::size_t i : *visited)
        if(half(i) == 1 && std::any_of(edges_[i].begin(), edges_[i].end(), in_second_half) &&
           !beyond(i))
          result.patches.push_back(i);
    for(std::size_t i : parts[0])
      for(const auto& edge : edges_[i])
        if(in_second_half(edge) && !beyond(edge.patch))
          result.patches.push_back(edge.patch);
    const auto sort_once = [](std::vector<std::size_t>& set) {
      std::sort(set.begin(), set.end());
      set.erase(std::unique(set.begin(), set.end()), set.end());
    };
    sort_once(result.patches);
    for(std::size_t i : result.patches) {
      result.length += patches_[i].spacing;
      for(std::size_t j : patches_[i].neighbors)
        if(half(j) != 0 && !std::binary_search(result.patches.begin(), result.patches.end(), j))
          result.sides[static_cast<std::size_t>(half(j) - 1)].push_back(j);
    }
    for(std::vector<std::size_t>& side : result.sides)
      sort_once(side);
    for(const std::vector<std::size_t>* visited : {&region_, &front_})
      for(std::size_t i : *visited)
        nearest_[i] = Nearest();
    return result;
  }

  /// For every patch of the region and its front which of the first two parts is nearer along the
  /// surface.
  void find_nearest(const std::vector<Part>& parts)
  {
    using Step = std::pair<double, std::size_t>;
    const auto later = [](const Step& a, const Step& b) { return a.first > b.first; };
    std::priority_queue<Step, std::vector<Step>, decltype(later)> queue(later);
    const auto visit = [&](const Nearest& nearest, std::size_t i) {
      if(nearest < nearest_[i]) {
        nearest_[i] = nearest;
        queue.emplace(nearest.distance, i);
      }
    };
    for(const std::vector<std::size_t>* visited : {&region_, &front_})
      for(std::size_t i : *visited)
        nearest_[i].distance = std::numeric_limits<double>::infinity();
    for(int k = 0; k < 2; ++k)
      for(std::size_t i : parts[static_cast<std::size_t>(k)])
        visit({0, k + 1}, i);
    while(!queue.empty()) {
      const Step step = queue.top();
      queue.pop();
      const Nearest nearest = nearest_[step.second];
      if(step.first > nearest.distance)
        continue; // came there on a shorter way
      for(const auto& edge : edges_[step.second])
        visit({nearest.distance + edge.length, nearest.part}, edge.patch);
    }
  }

  const std::vector<Patch>& patches_;
  const Patch_edges& edges_;
  const std::vector<Sample>& samples_;
  Vector3 center_ = Vector3::Zero();
  double reach_ = 0;
  std::vector<std::size_t> region_; ///< The seed first.
  std::vector<std::size_t> front_;
  std::vector<std::size_t> labelled_; ///< Patches that the parts reach, the front first.

  // Of every patch; as at the beginning wherever no region is.
  std::vector<std::size_t> label_;
  std::vector<double> distance_; ///< To the centre, of the front.
  std::vector<Nearest> nearest_; ///< Default outside.
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_GROWING_REGION_H
