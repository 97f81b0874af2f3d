// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// A plant in numbers: the length of its stem, and length and angle of each leaf. The plant is made
// up, so that what it was made with can be printed beside what was measured.

#include "made_up_plant.h"
#include "measured_plant.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/Curve_skeleton_3.h>

#include <cstddef>
#include <fstream>
#include <iostream>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

int main()
{
  const std::vector<Made_up_leaf> made{
      {0.25, 0, 50, 0.45}, {0.42, 180, 55, 0.5}, {0.58, 20, 45, 0.4}, {0.74, 200, 60, 0.35}};
  const std::vector<Kernel::Point_3> points = made_up_plant<Kernel::Point_3>(1, made);

  const Measured_plant<Kernel> plant(points);
  std::cout << "stem: " << plant.stem_length() << " m of 1\n";
  for(std::size_t i = 0; i < plant.leaves().size(); ++i) {
    const Measured_leaf<Kernel>& leaf = plant.leaves()[i];
    std::cout << "leaf at " << leaf.start.z() << " m: " << leaf.length << " m long, at "
              << leaf.angle << " degrees";
    if(plant.leaves().size() == made.size())
      std::cout << "; made: " << made[i].height << ", " << made[i].length << ", " << made[i].angle;
    std::cout << '\n';
  }

  CGAL::IO::write_curve_skeleton("plant_phenotyping_example.ply", plant.skeleton());
  std::ofstream file("plant_phenotyping_example.xyz");
  for(const Kernel::Point_3& p : points)
    file << p << '\n';
}
