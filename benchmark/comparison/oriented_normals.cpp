// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "oriented_normals.h"

#include <CGAL/mst_orient_normals.h>
#include <CGAL/pca_estimate_normals.h>
#include <CGAL/property_map.h>

#include <utility>

Method_input with_normals(const std::vector<Point>& points)
{
  using Oriented_point = std::pair<Point, Vector>;
  constexpr unsigned int neighbours = 18;
  const auto maps = CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Oriented_point>())
                        .normal_map(CGAL::Second_of_pair_property_map<Oriented_point>());
  std::vector<Oriented_point> rest;
  for(const Point& p : points)
    rest.emplace_back(p, Vector(CGAL::NULL_VECTOR));
  CGAL::pca_estimate_normals<CGAL::Sequential_tag>(rest, neighbours, maps);

  Method_input input;
  while(!rest.empty()) {
    const auto end = CGAL::mst_orient_normals(rest, neighbours, maps);
    for(auto oriented = rest.begin(); oriented != end; ++oriented) {
      input.points.push_back(oriented->first);
      input.normals.push_back(oriented->second);
    }
    rest.erase(rest.begin(), end);
  }
  return input;
}
