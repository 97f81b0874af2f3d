// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_FAMILIES_WIRES_H
#define POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_FAMILIES_WIRES_H

#include "../Random.h"
#include "../drawing.h"
#include "loops.h"

#include <cstddef>
#include <vector>

/// Frames of wire, which is so thin that a scan of it is a line of points, and of tubes.
namespace shapes {
namespace families {

/// A cage: rings above each other, with limbs from ring to ring, all of one radius.
inline Known_shape cage(Random& random, double least_radius, double most_radius)
{
  const int rings = random.in_turn(2, 3), columns = random.integer(3, 5);
  const double radius = random.uniform(least_radius, most_radius),
               height = random.uniform(0.5, 0.7);
  std::vector<Limb> corners;
  for(int level = 0; level < rings; ++level) {
    const double width = random.uniform(0.6, 1), phase = random.uniform(-0.05, 0.05);
    corners.emplace_back();
    for(int i = 0; i < columns; ++i)
      corners.back().push_back({width * on_circle(phase + static_cast<double>(i) / columns) +
                                    level * height * Vector::UnitZ(),
                                radius});
  }
  Known_shape shape;
  for(std::size_t level = 0; level < corners.size(); ++level)
    for(std::size_t i = 0; i < corners[level].size(); ++i) {
      const Limb& ring = corners[level];
      const Bead& next = ring[(i + 1) % ring.size()];
      const Vector outwards = 0.15 * (ring[i].centre + next.centre).cwiseProduct(Vector(1, 1, 0));
      add_limb(shape, bent_limb(ring[i], next, outwards));
      if(level > 0)
        add_limb(shape, bent_limb(corners[level - 1][i], ring[i], 0.08 * random.direction()));
    }
  const std::size_t n = static_cast<std::size_t>(columns);
  set_counts(shape, 1, n * static_cast<std::size_t>(rings - 1) + 1, 0);
  return shape;
}

/// A cage of wire.
inline Known_shape wire_frame(Random& random)
{
  return cage(random, 0.004, 0.007);
}

/// A cage of tubes: of 1000 to 4000 points, their radius is about the distance of these.
inline Known_shape tube_frame(Random& random)
{
  return cage(random, 0.05, 0.08);
}

} // namespace families
} // namespace shapes

#endif // POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_FAMILIES_WIRES_H
