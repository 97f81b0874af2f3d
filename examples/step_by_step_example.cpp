// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The three stages one by one, with what each leaves behind.

#include "read_points.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/L1_medial_skeletonization_3.h>

#include <algorithm>
#include <iostream>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Skeletonization = CGAL::L1_medial_skeletonization_3<Kernel>;

int main(int argc, char** argv)
{
  const std::vector<Kernel::Point_3> points = read_points<Kernel::Point_3>(
      argc > 1 ? argv[1] : CGAL::data_file_path("points_3/kitten.xyz"));
  Skeletonization skeletonization(points);

  skeletonization.fit_mixture();
  std::cout << points.size() << " points became a mixture of";
  for(const auto& level : skeletonization.mixture().levels)
    std::cout << ' ' << level.size();
  std::cout << " Gaussians\n";

  skeletonization.project();
  const auto samples = skeletonization.samples();
  const auto by_radius = [](const auto& a, const auto& b) { return a.radius < b.radius; };
  const auto widest = std::max_element(samples.samples.begin(), samples.samples.end(), by_radius);
  std::cout << samples.samples.size() << " samples, the widest ball has radius " << widest->radius
            << "; noise " << samples.noise.front() << '\n';

  skeletonization.link();
  Skeletonization::Skeleton skeleton;
  skeletonization.extract_skeleton(skeleton);
  std::cout << "a skeleton of " << num_vertices(skeleton) << " vertices and " << num_edges(skeleton)
            << " edges\n";
}
