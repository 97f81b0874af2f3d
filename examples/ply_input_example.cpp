// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// A scan in a PLY file, all cores if TBB is there.

#include "read_points.h"

#include <CGAL/Curve_skeleton_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/Curve_skeleton_3.h>
#include <CGAL/extract_l1_medial_skeleton.h>
#include <CGAL/tags.h>

#include <iostream>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

int main(int argc, char** argv)
{
  const std::vector<Kernel::Point_3> points = read_points<Kernel::Point_3>(
      argc > 1 ? argv[1] : CGAL::data_file_path("points_3/hippo1.ply"));

  CGAL::Curve_skeleton_3<Kernel> skeleton;
  CGAL::extract_l1_medial_skeleton<CGAL::Parallel_if_available_tag>(points, skeleton);
  CGAL::IO::write_curve_skeleton("ply_input_example.obj", skeleton);
  std::cout << points.size() << " points became " << num_vertices(skeleton) << " vertices\n";
}
