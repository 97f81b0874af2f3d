// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The first stage alone: a cloud as a hierarchy of Gaussian mixtures.

#include "read_points.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/fit_gaussian_mixture.h>

#include <iostream>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

int main(int argc, char** argv)
{
  const std::vector<Kernel::Point_3> points = read_points<Kernel::Point_3>(
      argc > 1 ? argv[1] : CGAL::data_file_path("points_3/kitten.xyz"));

  const auto mixture = CGAL::fit_gaussian_mixture(points);
  for(const auto& level : mixture.levels) {
    double weight = 0;
    for(const auto& component : level)
      weight += component.weight;
    std::cout << level.size() << " Gaussians stand for " << weight << " points\n";
  }
}
