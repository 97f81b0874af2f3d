// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Writes a skeleton made by hand in every format: `made_up_skeleton FILE...`. It has a trunk, a
// ring on top of it, a twig and a vertex alone, at UTM coordinates that need all digits of a
// double.

#include <CGAL/Curve_skeleton_3.h>
#include <CGAL/IO/Curve_skeleton_3.h>
#include <CGAL/Simple_cartesian.h>

#include <cstddef>
#include <exception>
#include <iostream>
#include <utility>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;

int main(int argc, char** argv)
{
  CGAL::Curve_skeleton_3<Kernel> skeleton;
  const std::vector<std::vector<double>> points{{0, 0, 0}, {0, 0, 1},  {0, 0, 2}, {1, 0, 3},
                                                {0, 0, 4}, {-1, 0, 3}, {0, 2, 1}, {9, 9, 9}};
  for(std::size_t i = 0; i < points.size(); ++i) {
    const auto v = add_vertex(skeleton);
    skeleton[v].point = Kernel::Point_3(500000 + points[i][0] / 3, 5300000 + points[i][1] / 7,
                                        400 + points[i][2] / 3);
    skeleton[v].radius = 0.1 + 0.1 * static_cast<double>(i);
  }
  for(const auto& [v, w] : std::vector<std::pair<std::size_t, std::size_t>>{
          {0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 2}, {1, 6}})
    add_edge(v, w, skeleton);
  try {
    for(int i = 1; i < argc; ++i)
      CGAL::IO::write_curve_skeleton(argv[i], skeleton);
  } catch(const std::exception& error) {
    std::cerr << error.what() << std::endl;
    return 1;
  }
}
