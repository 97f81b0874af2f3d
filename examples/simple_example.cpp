// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// From points to a skeleton.

#include "read_points.h"

#include <CGAL/Curve_skeleton_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/Curve_skeleton_3.h>
#include <CGAL/extract_l1_medial_skeleton.h>

#include <iostream>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

int main(int argc, char** argv)
{
  const std::vector<Kernel::Point_3> points = read_points<Kernel::Point_3>(
      argc > 1 ? argv[1] : CGAL::data_file_path("points_3/kitten.xyz"));

  CGAL::Curve_skeleton_3<Kernel> skeleton;
  CGAL::extract_l1_medial_skeleton(points, skeleton);

  for(const auto v : CGAL::make_range(vertices(skeleton)))
    std::cout << skeleton[v].point << ", radius " << skeleton[v].radius << ", stands for "
              << skeleton[v].indices.size() << " points\n";
  CGAL::IO::write_curve_skeleton("simple_example.ply", skeleton);
}
