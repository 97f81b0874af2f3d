// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Points that come with other things: pairs, and a Point_set_3 with properties.

#include "read_points.h"

#include <CGAL/Curve_skeleton_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/extract_l1_medial_skeleton.h>
#include <CGAL/property_map.h>

#include <iostream>
#include <utility>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Skeleton = CGAL::Curve_skeleton_3<Kernel>;
using Labelled_point = std::pair<Point, int>;

int main(int argc, char** argv)
{
  std::vector<Labelled_point> labelled;
  CGAL::Point_set_3<Point> point_set;
  for(const Point& p :
      read_points<Point>(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off"))) {
    labelled.emplace_back(p, p.z() > 0 ? 1 : 2);
    point_set.insert(p);
  }

  Skeleton skeleton;
  CGAL::extract_l1_medial_skeleton(
      labelled, skeleton,
      CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Labelled_point>()));
  // A vertex knows the places in the range of the points it stands for, so their labels as well.
  for(const auto v : CGAL::make_range(vertices(skeleton))) {
    std::size_t first = 0;
    for(const std::size_t i : skeleton[v].indices)
      first += labelled[i].second == 1 ? 1 : 0;
    std::cout << first << " of " << skeleton[v].indices.size() << " points have label 1\n";
  }

  Skeleton same;
  CGAL::extract_l1_medial_skeleton(point_set, same, point_set.parameters());
  std::cout << num_vertices(same) << " vertices from the Point_set_3\n";
}
