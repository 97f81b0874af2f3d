// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_TEST_FUZZ_FUZZED_POINTS_H
#define POINT_SET_SKELETONIZATION_3_TEST_FUZZ_FUZZED_POINTS_H

#include "skeleton_invariants.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/Gaussian_mixture_builder_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/extract_l1_medial_skeleton.h>
#include <CGAL/extract_published_l1_medial_skeleton.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <vector>

namespace fuzzed {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;

/// Points from bytes: the first says of how many bytes a coordinate is, as small integers make many
/// points in special position, and doubles extreme ones.
inline std::vector<Point> points_of(const std::uint8_t* data, std::size_t size)
{
  std::vector<Point> points;
  if(size == 0)
    return points;
  const std::size_t width = data[0] % 2 == 0 ? 1 : 8;
  const auto coordinate = [&](std::size_t i) {
    double x = data[i];
    if(width == 8)
      std::memcpy(&x, data + i, 8);
    return x;
  };
  for(std::size_t i = 1; i + 3 * width <= size; i += 3 * width)
    points.emplace_back(coordinate(i), coordinate(i + width), coordinate(i + 2 * width));
  return points;
}

/// Both methods and the builder give a possible skeleton of any points, or name one that is not
/// finite.
inline void fuzz_points(const std::uint8_t* data, std::size_t size)
{
  const std::vector<Point> points = points_of(data, size);
  const auto require = [](const std::string& wrong) {
    if(!wrong.empty())
      std::abort();
  };
  try {
    CGAL::Curve_skeleton_3<Kernel> skeleton;
    CGAL::extract_l1_medial_skeleton(points, skeleton);
    require(wrong_with(skeleton, points));
    CGAL::Gaussian_mixture_builder_3<Kernel> builder(CGAL::bbox_3(points.begin(), points.end()));
    builder.insert(points);
    CGAL::extract_l1_medial_skeleton(builder, skeleton);
    CGAL::extract_published_l1_medial_skeleton(points, skeleton,
                                               CGAL::parameters::number_of_iterations(2));
  } catch(const std::invalid_argument&) {
  }
}

} // namespace fuzzed

#endif // POINT_SET_SKELETONIZATION_3_TEST_FUZZ_FUZZED_POINTS_H
