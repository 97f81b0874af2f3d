// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_EXAMPLES_CLOUD_VIEW_H
#define POINT_SET_SKELETONIZATION_3_EXAMPLES_CLOUD_VIEW_H

#include "Skeletonized_cloud.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

/// The bounding box of a cloud and its skeleton; all zero if there is neither.
struct Cloud_box
{
  std::array<double, 3> lower{}, upper{};

  double size(std::size_t k) const { return upper[k] - lower[k]; }
  double centre(std::size_t k) const { return lower[k] + size(k) / 2; }
  double diagonal() const { return std::hypot(size(0), size(1), size(2)); }
};

inline Cloud_box box_of(const Skeletonized_cloud& cloud)
{
  if(cloud.points.empty() && cloud.skeleton.graph.vertices.empty())
    return {};
  Cloud_box box;
  box.lower.fill(std::numeric_limits<double>::infinity());
  box.upper.fill(-std::numeric_limits<double>::infinity());
  const auto add = [&box](const std::array<double, 3>& p) {
    for(std::size_t k = 0; k < 3; ++k) {
      box.lower[k] = std::min(box.lower[k], p[k]);
      box.upper[k] = std::max(box.upper[k], p[k]);
    }
  };
  for(const auto& p : cloud.points)
    add({p.x(), p.y(), p.z()});
  for(const auto& v : cloud.skeleton.graph.vertices)
    add(v.point);
  return box;
}

/// Chooses at most `most` of `size` things, one at random of each stretch of equal length: without
/// the stripes that every k-th of a scan's rows would show. The same choice every time.
inline std::vector<std::size_t> thinned(std::size_t size, std::size_t most)
{
  std::vector<std::size_t> result;
  const std::size_t count = std::min(size, most);
  const auto first = [&](std::size_t stretch) {
    return static_cast<std::size_t>(static_cast<double>(size) / static_cast<double>(count) *
                                    static_cast<double>(stretch));
  };
  std::uint32_t random = 1;
  for(std::size_t stretch = 0; stretch < count; ++stretch) {
    random = 1664525u * random + 1013904223u; // a linear congruential generator
    const std::size_t begin = first(stretch), end = std::min(size, first(stretch + 1));
    result.push_back(begin + (random >> 8) % std::max<std::size_t>(1, end - begin));
  }
  return result;
}

/// What a skeleton has, in numbers.
struct Skeleton_facts
{
  std::size_t components = 0, tips = 0, junctions = 0, cycles = 0;
  double length = 0;
};

inline std::vector<std::size_t> degrees_of(const Skeletonized_cloud& cloud)
{
  std::vector<std::size_t> result(cloud.skeleton.graph.vertices.size(), 0);
  for(const auto& [v, w] : cloud.skeleton.graph.edges) {
    ++result[v];
    ++result[w];
  }
  return result;
}

inline Skeleton_facts facts_of(const Skeletonized_cloud& cloud)
{
  Skeleton_facts facts;
  for(std::size_t degree : degrees_of(cloud)) {
    facts.tips += degree == 1;
    facts.junctions += degree >= 3;
  }
  for(const auto& branch : cloud.skeleton.branches) {
    facts.cycles += branch.closes_cycle;
    facts.length += branch.length;
  }
  // Without the edges that close cycles it is a forest.
  facts.components =
      cloud.skeleton.graph.vertices.size() + facts.cycles - cloud.skeleton.graph.edges.size();
  return facts;
}

#endif // POINT_SET_SKELETONIZATION_3_EXAMPLES_CLOUD_VIEW_H
