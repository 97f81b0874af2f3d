// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_TEST_SKELETON_INVARIANTS_H
#define POINT_SET_SKELETONIZATION_3_TEST_SKELETON_INVARIANTS_H

#include <boost/graph/graph_traits.hpp>
#include <boost/range/iterator_range.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

/// What is wrong with a skeleton of `points`, whatever they are; empty if nothing is. Right is: all
/// numbers are finite; the graph is simple; every vertex is in the bounding box of the points;
/// radii are not negative nor greater than its diagonal; no point belongs to two vertices.
template <typename Skeleton, typename Points>
std::string wrong_with(const Skeleton& skeleton, const Points& points)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::array<double, 3> lower{{infinity, infinity, infinity}},
      upper{{-infinity, -infinity, -infinity}};
  for(const auto& p : points)
    for(int k = 0; k < 3; ++k) {
      double& least = lower[static_cast<std::size_t>(k)];
      double& greatest = upper[static_cast<std::size_t>(k)];
      least = std::min(least, static_cast<double>(p[k]));
      greatest = std::max(greatest, static_cast<double>(p[k]));
    }
  const double half_diagonal = std::hypot(upper[0] / 2 - lower[0] / 2, upper[1] / 2 - lower[1] / 2,
                                          upper[2] / 2 - lower[2] / 2);
  std::vector<char> taken(points.size(), 0);
  for(const auto v : boost::make_iterator_range(vertices(skeleton))) {
    const auto& vertex = skeleton[v];
    const std::string name = "vertex " + std::to_string(v) + ' ';
    for(int k = 0; k < 3; ++k) {
      const auto axis = static_cast<std::size_t>(k);
      const double x = vertex.point[k];
      if(!std::isfinite(x))
        return name + "is not finite";
      if(x < lower[axis] || x > upper[axis])
        return name + "is outside of the box";
    }
    if(!(vertex.radius >= 0))
      return name + "has a negative radius or none";
    if(!std::isfinite(vertex.radius) || vertex.radius / 2 > half_diagonal * (1 + 1e-9))
      return name + "has a radius longer than the diagonal";
    for(const std::size_t i : vertex.indices)
      if(i >= taken.size() || std::exchange(taken[i], char(1)))
        return name + "has a point that is not there, or another vertex's";
  }
  std::set<std::pair<std::size_t, std::size_t>> known;
  for(const auto e : boost::make_iterator_range(edges(skeleton))) {
    const std::size_t s = source(e, skeleton), t = target(e, skeleton);
    if(s == t || !known.emplace(std::min(s, t), std::max(s, t)).second)
      return "edge " + std::to_string(s) + ' ' + std::to_string(t) + " is a loop, or there twice";
  }
  return std::string();
}

#endif // POINT_SET_SKELETONIZATION_3_TEST_SKELETON_INVARIANTS_H
