// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Samples from elsewhere, linked to a skeleton: here those of a torus, of which the middle is
// known.

#include <CGAL/Curve_skeleton_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Medial_sample_3.h>
#include <CGAL/link_medial_samples.h>

#include <cmath>
#include <cstdlib>
#include <iostream>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;

int main()
{
  constexpr double pi = 3.14159265358979323846, ring_radius = 3, tube_radius = 1;
  constexpr int around_ring = 90, around_tube = 30;

  CGAL::Medial_samples_3<Kernel> samples;
  for(int i = 0; i < around_ring; ++i)
    for(int j = 0; j < around_tube; ++j) {
      const double a = 2 * pi * i / around_ring, b = 2 * pi * j / around_tube;
      const Vector outwards(std::cos(a), std::sin(a), 0);
      CGAL::Medial_sample_3<Kernel> sample;
      sample.point = Point(0, 0, 0) + ring_radius * outwards;
      sample.radius = tube_radius;
      sample.patch.mean =
          sample.point + tube_radius * (std::cos(b) * outwards + Vector(0, 0, std::sin(b)));
      sample.patch.weight = 1;
      samples.samples.push_back(sample);
    }

  CGAL::Curve_skeleton_3<Kernel> skeleton;
  CGAL::link_medial_samples(samples, skeleton);
  std::cout << num_vertices(skeleton) << " vertices and " << num_edges(skeleton)
            << " edges: a closed curve has as many of both\n";
  return num_vertices(skeleton) > 0 && num_vertices(skeleton) == num_edges(skeleton)
             ? EXIT_SUCCESS
             : EXIT_FAILURE;
}
