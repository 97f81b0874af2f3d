// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// A callback that reports progress, and one that cancels.

#include "read_points.h"

#include <CGAL/Curve_skeleton_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/extract_l1_medial_skeleton.h>

#include <cstdlib>
#include <iostream>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

int main(int argc, char** argv)
{
  const std::vector<Kernel::Point_3> points = read_points<Kernel::Point_3>(
      argc > 1 ? argv[1] : CGAL::data_file_path("points_3/kitten.xyz"));
  CGAL::Curve_skeleton_3<Kernel> skeleton;

  double tenth = 0;
  const auto report = [&tenth](double progress) {
    if(progress >= tenth) {
      std::cout << static_cast<int>(100 * progress) << " %\n";
      tenth = progress + 0.1;
    }
    return true; // go on
  };
  CGAL::extract_l1_medial_skeleton(points, skeleton, CGAL::parameters::callback(report));
  const auto size = num_vertices(skeleton);

  const auto stop_half_way = [](double progress) { return progress < 0.5; };
  const bool finished =
      CGAL::extract_l1_medial_skeleton(points, skeleton, CGAL::parameters::callback(stop_half_way));
  std::cout << (finished ? "finished" : "cancelled, the skeleton is as it was") << '\n';
  return !finished && num_vertices(skeleton) == size ? EXIT_SUCCESS : EXIT_FAILURE;
}
