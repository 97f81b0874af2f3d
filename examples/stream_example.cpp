// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Scans that are larger than memory together: their points are read one after the other.

#include "for_each_point.h"

#include <CGAL/Bulk_bbox_3.h>
#include <CGAL/Curve_skeleton_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Gaussian_mixture_builder_3.h>
#include <CGAL/IO/Curve_skeleton_3.h>
#include <CGAL/extract_l1_medial_skeleton.h>

#include <cstddef>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Builder = CGAL::Gaussian_mixture_builder_3<Kernel>;

int main(int argc, char** argv)
{
  std::vector<std::string> files(argv + 1, argv + argc);
  if(files.empty())
    files.push_back(CGAL::data_file_path("points_3/kitten.xyz"));

  const CGAL::Bulk_bbox_3<Kernel> box = bulk_of_files<Point>(files);

  // A builder per file, for instance in a thread or on a machine of its own.
  Builder all(box);
  for(const std::string& file : files) {
    Builder builder(box);
    for_each_point<Point>(file, [&builder](const Point& p) { builder.insert(p); });
    all.merge(builder);
  }

  CGAL::Curve_skeleton_3<Kernel> skeleton;
  const std::size_t points = all.number_of_points();
  CGAL::extract_l1_medial_skeleton(std::move(all), skeleton); // its memory is used again
  std::cout << points << " points have a skeleton of " << num_vertices(skeleton) << " vertices\n";
  CGAL::IO::write_curve_skeleton("stream_example.ply", skeleton);
}
