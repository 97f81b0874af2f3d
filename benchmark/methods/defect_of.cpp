// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "defect_of.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <utility>

std::string defect_of(const Skeleton& skeleton)
{
  if(num_vertices(skeleton) == 0)
    return "no vertices";
  for(const auto v : CGAL::make_range(vertices(skeleton))) {
    const auto& [point, radius, indices] = skeleton[v];
    if(!std::isfinite(point.x()) || !std::isfinite(point.y()) || !std::isfinite(point.z()))
      return "not finite";
    if(!std::isfinite(radius) || radius < 0)
      return "a radius is negative or not finite";
  }
  std::set<std::pair<std::size_t, std::size_t>> known;
  for(const auto e : CGAL::make_range(edges(skeleton))) {
    const auto [a, b] = std::minmax({source(e, skeleton), target(e, skeleton)});
    if(a == b)
      return "an edge from a vertex to itself";
    if(!known.emplace(a, b).second)
      return "two edges between the same vertices";
  }
  return "";
}
