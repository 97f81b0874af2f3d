// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The three stages as functions, each of which takes what the one before left. What they leave is
// written to files; doc/make_figures.py draws it.

#include "read_points.h"

#include <CGAL/Curve_skeleton_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/Curve_skeleton_3.h>
#include <CGAL/Medial_sample_3.h>
#include <CGAL/compute_medial_samples.h>
#include <CGAL/fit_gaussian_mixture.h>
#include <CGAL/link_medial_samples.h>

#include <fstream>
#include <iostream>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

int main(int argc, char** argv)
{
  const std::vector<Kernel::Point_3> points = read_points<Kernel::Point_3>(
      argc > 1 ? argv[1] : CGAL::data_file_path("points_3/kitten.xyz"));

  const auto mixture = CGAL::fit_gaussian_mixture(points);
  std::ofstream stage_1("stage_1.txt"); // mean, covariance
  for(const auto& component : mixture.levels.front()) {
    stage_1 << component.mean;
    for(const double entry : component.covariance)
      stage_1 << ' ' << entry;
    stage_1 << '\n';
  }

  CGAL::Medial_samples_3<Kernel> samples;
  CGAL::compute_medial_samples(mixture, samples);
  std::ofstream surface("stage_2_surface.txt"); // before and after denoising
  for(const auto& p : samples.surface)
    surface << p.point << ' ' << p.denoised << '\n';
  std::ofstream stage_2("stage_2_samples.txt"); // patch, sample, radius
  for(const auto& sample : samples.samples)
    stage_2 << sample.patch.mean << ' ' << sample.point << ' ' << sample.radius << '\n';

  CGAL::Curve_skeleton_3<Kernel> skeleton;
  CGAL::link_medial_samples(samples, skeleton);
  CGAL::IO::write_curve_skeleton("stage_by_stage_example.ply", skeleton);
  std::cout << points.size() << " points, " << samples.samples.size() << " samples, "
            << num_vertices(skeleton) << " vertices\n";
}
