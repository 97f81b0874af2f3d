// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_TRIANGLE_H
#define POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_TRIANGLE_H

#include "Random.h"

#include <cmath>

namespace shapes {

/// A piece of a sheet, such as a leaf, that has two sides and no inside.
struct Triangle
{
  Vector a, b, c;

  Eigen::AlignedBox3d bounding_box() const { return Eigen::AlignedBox3d(a).extend(b).extend(c); }

  double area() const { return (b - a).cross(c - a).norm() / 2; }

  /// Uniform by area.
  Vector random_point(Random& random) const
  {
    const double beside_a = std::sqrt(random.uniform()), towards_c = random.uniform();
    return a + beside_a * ((b - a) + towards_c * (c - b));
  }

  void rotate(const Eigen::Matrix3d& rotation)
  {
    for(Vector* corner : {&a, &b, &c})
      *corner = rotation * *corner;
  }
};

} // namespace shapes

#endif // POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_TRIANGLE_H
