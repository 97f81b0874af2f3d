// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Named parameters: a single component, and those of the published method.

#include "read_points.h"

#include <CGAL/Curve_skeleton_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Point_set_skeletonization_3/parameters.h>
#include <CGAL/Point_set_skeletonization_3/published_parameters.h>
#include <CGAL/extract_l1_medial_skeleton.h>
#include <CGAL/extract_published_l1_medial_skeleton.h>

#include <iostream>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Skeleton = CGAL::Curve_skeleton_3<Kernel>;
namespace params = CGAL::parameters;

int main(int argc, char** argv)
{
  const std::vector<Kernel::Point_3> points = read_points<Kernel::Point_3>(
      argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off"));

  const auto report = [](double progress) {
    if(progress == 1)
      std::cout << "done: ";
    return true;
  };
  // The parameter of this package takes the others as its second argument.
  Skeleton skeleton;
  CGAL::extract_l1_medial_skeleton(points, skeleton,
                                   params::single_component(true, params::callback(report)));
  std::cout << num_vertices(skeleton) << " vertices\n";

  Skeleton published;
  CGAL::extract_published_l1_medial_skeleton(
      points, published,
      params::callback(report).random_seed(42).number_of_iterations(20));
  std::cout << num_vertices(published) << " vertices as published\n";

  // All parameters of the paper have a name; some sets of them, too.
  namespace symbols = params::published;
  CGAL::extract_published_l1_medial_skeleton(
      points, published, symbols::mu(0.3, symbols::d_max(0.05, params::random_seed(42))));
  std::cout << num_vertices(published) << " vertices with other parameters\n";
  CGAL::extract_published_l1_medial_skeleton(points, published, symbols::tuned(true));
  std::cout << num_vertices(published) << " vertices tuned\n";
}
