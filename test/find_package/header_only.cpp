// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Another project that found the installed headers.

#include <CGAL/Curve_skeleton_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/skeleton_branches.h>

int main()
{
  CGAL::Curve_skeleton_3<CGAL::Simple_cartesian<double>> skeleton;
  add_edge(add_vertex(skeleton), add_vertex(skeleton), skeleton);
  return CGAL::skeleton_branches(skeleton).size() == 1 ? 0 : 1;
}
