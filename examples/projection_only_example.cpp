// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The second stage alone: from a mixture to samples on the medial curves, without linking them.

#include "read_points.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Medial_sample_3.h>
#include <CGAL/fit_gaussian_mixture.h>
#include <CGAL/project_to_l1_medians.h>

#include <fstream>
#include <iostream>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

int main(int argc, char** argv)
{
  const std::vector<Kernel::Point_3> points = read_points<Kernel::Point_3>(
      argc > 1 ? argv[1] : CGAL::data_file_path("points_3/kitten.xyz"));

  std::vector<CGAL::Medial_sample_3<Kernel>> samples;
  CGAL::project_to_l1_medians(CGAL::fit_gaussian_mixture(points), samples);

  std::ofstream file("projection_only_example.xyz");
  for(const auto& sample : samples)
    file << sample.point << '\n';
  std::cout << samples.size() << " samples written to projection_only_example.xyz\n";
}
