// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// A mesh as input: points drawn from its surface, which need not be closed.

#include "read_points.h"
#include "sample_surface.h"

#include <CGAL/Curve_skeleton_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/Curve_skeleton_3.h>
#include <CGAL/extract_l1_medial_skeleton.h>

#include <iostream>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

int main(int argc, char** argv)
{
  const auto mesh = read_points_and_faces<Kernel::Point_3>(
      argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant-with-holes.off"));
  const auto points = sample_surface(mesh, 20000, 0);

  CGAL::Curve_skeleton_3<Kernel> skeleton;
  CGAL::extract_l1_medial_skeleton(points, skeleton);
  CGAL::IO::write_curve_skeleton("off_input_example.polylines.txt", skeleton);
  std::cout << mesh.faces.size() << " faces became " << num_edges(skeleton) << " edges\n";
}
