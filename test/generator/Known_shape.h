// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_KNOWN_SHAPE_H
#define POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_KNOWN_SHAPE_H

#include "Random.h"
#include "Solid.h"
#include "Triangle.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace shapes {

/// A straight piece of a curve skeleton. A radius is the distance to the surface at an end; on a
/// sheet, to its border.
struct Axis_segment
{
  Vector a, b;
  double radius_a, radius_b;
};

/// Where at least three pieces of the skeleton meet. Within the radius its course is ambiguous.
struct Junction
{
  Vector position;
  double radius;
};

/// A solid, possibly with sheets on it, and its curve skeleton. Pieces of the axis are connected
/// where their ends coincide.
struct Known_shape
{
  std::string family;
  unsigned seed = 0;
  Solid solid;
  std::vector<Triangle> sheets; ///< only a scanner sees them
  std::vector<Axis_segment> axis;
  std::vector<Junction> junctions;
  std::size_t components = 1, cycles = 0, ends = 0; ///< Of the skeleton as a graph.
};

/// Of the solid and the sheets.
inline Eigen::AlignedBox3d bounding_box(const Known_shape& shape)
{
  Eigen::AlignedBox3d box = shape.solid.bounding_box();
  for(const Triangle& triangle : shape.sheets)
    box.extend(triangle.bounding_box());
  return box;
}

/// Of the thinnest limb.
inline double least_radius(const Known_shape& shape)
{
  double radius = std::numeric_limits<double>::infinity();
  for(const Axis_segment& piece : shape.axis)
    radius = std::min({radius, piece.radius_a, piece.radius_b});
  return radius;
}

} // namespace shapes

#endif // POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_KNOWN_SHAPE_H
