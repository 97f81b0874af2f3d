// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The method as it was published, with a seed and a number of iterations, beside the default.

#include "read_points.h"

#include <CGAL/Curve_skeleton_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Point_set_skeletonization_3/parameters.h>
#include <CGAL/extract_l1_medial_skeleton.h>

#include <iostream>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Skeleton = CGAL::Curve_skeleton_3<Kernel>;
namespace params = CGAL::parameters;

int main(int argc, char** argv)
{
  const std::vector<Kernel::Point_3> points = read_points<Kernel::Point_3>(
      argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off"));

  Skeleton skeleton;
  CGAL::extract_l1_medial_skeleton(points, skeleton);
  std::cout << "default: " << num_vertices(skeleton) << " vertices\n";

  // A parameter of this package takes the others as its second argument.
  Skeleton published;
  CGAL::extract_l1_medial_skeleton(points, published,
                                   params::as_published(
                                       true, params::random_seed(42).number_of_iterations(20)));
  std::cout << "as published: " << num_vertices(published) << " vertices\n";
}
