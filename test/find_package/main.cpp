// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Another project that found the installed package.

#include <CGAL/Curve_skeleton_3.h>
#include <CGAL/IO/Curve_skeleton_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/extract_l1_medial_skeleton.h>
#include <CGAL/skeleton_branches.h>

#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;

int main()
{
  const std::vector<Kernel::Point_3> points{{1, 2, 3}};
  CGAL::Curve_skeleton_3<Kernel> skeleton;
  if(!CGAL::extract_l1_medial_skeleton(points, skeleton) || num_vertices(skeleton) != 1 ||
     CGAL::skeleton_branches(skeleton).size() != 1)
    return 1;
  CGAL::IO::write_curve_skeleton("one_vertex.ply", skeleton);
}
