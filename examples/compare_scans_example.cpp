// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Two scans of a plant, a week apart: which leaf grew by how much, which sank, which is new. Leaves
// are told apart by where they leave the stem, which moves by less than their distance.

#include "made_up_plant.h"
#include "measured_plant.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/Curve_skeleton_3.h>

#include <iostream>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Leaf = Measured_leaf<Kernel>;

// The leaf that starts nearest to another, if that is near; else null.
const Leaf* same_leaf(const Leaf& leaf, const std::vector<Leaf>& others)
{
  constexpr double near = 0.05; // metres
  const Leaf* nearest = nullptr;
  double least = near * near;
  for(const Leaf& other : others)
    if(const double d = CGAL::squared_distance(leaf.start, other.start); d < least) {
      least = d;
      nearest = &other;
    }
  return nearest;
}

int main()
{
  const auto first = made_up_plant<Kernel::Point_3>(
      0.7, {{0.25, 0, 50, 0.45}, {0.42, 180, 55, 0.35}, {0.58, 20, 45, 0.3}});
  const auto second = made_up_plant<Kernel::Point_3>(
      0.9, {{0.25, 0, 65, 0.45}, {0.42, 180, 55, 0.45}, {0.58, 20, 45, 0.4}, {0.74, 200, 45, 0.3}});

  const Measured_plant<Kernel> before(first), after(second);
  std::cout << "stem: " << before.stem_length() << " m, then " << after.stem_length() << " m\n";
  for(const Leaf& leaf : after.leaves()) {
    std::cout << "leaf at " << leaf.start.z() << " m: ";
    if(const Leaf* earlier = same_leaf(leaf, before.leaves()))
      std::cout << earlier->length << " m, then " << leaf.length << " m; " << earlier->angle
                << " degrees, then " << leaf.angle << '\n';
    else
      std::cout << "new, " << leaf.length << " m at " << leaf.angle << " degrees\n";
  }
  for(const Leaf& leaf : before.leaves())
    if(!same_leaf(leaf, after.leaves()))
      std::cout << "leaf at " << leaf.start.z() << " m: gone\n";

  CGAL::IO::write_curve_skeleton("compare_scans_example_before.ply", before.skeleton());
  CGAL::IO::write_curve_skeleton("compare_scans_example_after.ply", after.skeleton());
}
