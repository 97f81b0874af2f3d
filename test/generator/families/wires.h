// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_FAMILIES_WIRES_H
#define POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_FAMILIES_WIRES_H

#include "../Random.h"
#include "../drawing.h"
#include "loops.h"

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

/// Frames of wire, which is so thin that a scan of it is a line of points, and of thin tubes.
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

/// Thin tubes along the edges of cells of width 1, `cells` many in each direction.
inline Known_shape lattice_of(const std::array<int, 3>& cells, double radius)
{
  Limb corners;
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  std::array<std::size_t, 3> step{1, 0, 0}; // from corner to corner
  for(std::size_t axis = 1; axis < 3; ++axis)
    step[axis] = step[axis - 1] * static_cast<std::size_t>(cells[axis - 1] + 1);
  for(int z = 0; z <= cells[2]; ++z)
    for(int y = 0; y <= cells[1]; ++y)
      for(int x = 0; x <= cells[0]; ++x) {
        const std::array<int, 3> place{x, y, z};
        for(std::size_t axis = 0; axis < 3; ++axis)
          if(place[axis] > 0)
            edges.emplace_back(corners.size() - step[axis], corners.size());
        corners.push_back({Vector(x, y, z), radius});
      }
  Known_shape shape;
  add_edges(shape, corners, edges);
  set_counts(shape, 1, edges.size() + 1 - corners.size(), 0);
  return shape;
}

/// A bar with thin teeth, in a plane.
inline Known_shape comb(int teeth, double radius)
{
  const double pitch = 5 * radius, length = 20 * radius;
  Known_shape shape;
  Limb bar;
  for(int i = 0; i < teeth; ++i) {
    const Vector foot = i * pitch * Vector::UnitX();
    bar.push_back({foot, 1.7 * radius});
    add_limb(shape, {{foot, radius}, {foot + length * Vector::UnitZ(), radius}});
  }
  add_limb(shape, bar);
  set_counts(shape, 1, 0, static_cast<std::size_t>(teeth));
  return shape;
}

/// Thin tubes, many in a plane: a net, a lattice in space or a comb.
inline Known_shape lattice(Random& random)
{
  const double radius = random.uniform(0.06, 0.1);
  switch(random.in_turn(0, 2)) {
  case 0:
    return lattice_of({random.integer(4, 6), 0, random.integer(3, 5)}, radius);
  case 1:
    return lattice_of({2, random.integer(1, 2), random.integer(2, 4)}, radius);
  default:
    return comb(random.integer(10, 20), radius);
  }
}

} // namespace families
} // namespace shapes

#endif // POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_FAMILIES_WIRES_H
