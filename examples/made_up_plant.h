// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_EXAMPLES_MADE_UP_PLANT_H
#define POINT_SET_SKELETONIZATION_3_EXAMPLES_MADE_UP_PLANT_H

#include <CGAL/Random.h>
#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

/// A leaf as it is made: a blade that leaves the stem at an angle and bends down by 60 degrees.
/// Lengths in metres, angles in degrees.
struct Made_up_leaf
{
  double height;    ///< where it leaves the stem
  double direction; ///< around the stem
  double angle;     ///< between the stem and the straight line to the middle of the leaf
  double length;
};

/// Points as a scanner might see them on a stem and its leaves, 200 000 on a square metre. A leaf
/// is a single sheet.
template <typename Point>
std::vector<Point> made_up_plant(double stem_height, const std::vector<Made_up_leaf>& leaves)
{
  constexpr double density = 200000, stem_radius = 0.012, width = 0.05;
  constexpr double bend = CGAL_PI / 3;
  CGAL::Random random(1);
  std::vector<Point> points;
  const auto number_on = [](double area) { return static_cast<std::size_t>(density * area); };

  for(std::size_t i = number_on(2 * CGAL_PI * stem_radius * stem_height); i > 0; --i) {
    const double a = random.get_double(0, 2 * CGAL_PI);
    points.emplace_back(stem_radius * std::cos(a), stem_radius * std::sin(a),
                        random.get_double(0, stem_height));
  }
  for(const Made_up_leaf& leaf : leaves) {
    const double radius = leaf.length / bend; // of the arc along its middle
    const double first = leaf.angle * CGAL_PI / 180 - bend / 4; // at the stem
    const double turned = leaf.direction * CGAL_PI / 180;
    for(std::size_t i = number_on(leaf.length * width); i > 0; --i) {
      const double share = random.get_double(), y = random.get_double(-width / 2, width / 2);
      const double half_width = width / 2 * std::sqrt(std::sin(CGAL_PI * (0.08 + 0.92 * share)));
      if(std::abs(y) > half_width) // the blade tapers off
        continue;
      const double x = stem_radius + radius * (std::cos(first) - std::cos(first + bend * share));
      const double z = radius * (std::sin(first + bend * share) - std::sin(first));
      points.emplace_back(std::cos(turned) * x - std::sin(turned) * y,
                          std::sin(turned) * x + std::cos(turned) * y, leaf.height + z);
    }
  }
  return points;
}

#endif // POINT_SET_SKELETONIZATION_3_EXAMPLES_MADE_UP_PLANT_H
