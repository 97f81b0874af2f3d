// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Of the headers alone, without the compiled library, both methods can be called.

#ifdef CGAL_POINT_SET_SKELETONIZATION_3_COMPILED
#error "This test is about the headers alone."
#endif

#include "../shapes.h"

#include <CGAL/extract_l1_medial_skeleton.h>
#include <CGAL/extract_published_l1_medial_skeleton.h>

#include <CGAL/Simple_cartesian.h>

#include <boost/graph/graph_traits.hpp>

#include <cstdlib>
#include <iostream>

using Kernel = CGAL::Simple_cartesian<double>;

int main()
{
  const auto points = shapes::to_points<Kernel>(shapes::sample(shapes::cylinder(), 400, 1));
  CGAL::Curve_skeleton_3<Kernel> skeleton, published;
  const bool is_done = CGAL::extract_l1_medial_skeleton(points, skeleton) &&
                       CGAL::extract_published_l1_medial_skeleton(
                         points, published, CGAL::parameters::number_of_iterations(3));
  const auto is_path = [](const auto& graph) {
    return num_vertices(graph) > 1 && num_edges(graph) + 1 == num_vertices(graph);
  };
  if(is_done && is_path(skeleton) && is_path(published))
    return EXIT_SUCCESS;
  std::cerr << "the skeleton of a cylinder is no tree\n";
  return EXIT_FAILURE;
}
