// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_FAMILIES_LOOPS_H
#define POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_FAMILIES_LOOPS_H

#include "../Random.h"
#include "../drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

/// Families with cycles and without ends. Lengths are in units of about the size of a loop.
namespace shapes {
namespace families {

/// A point on the unit circle in the plane of x and y.
inline Vector on_circle(double turns)
{
  return Vector(std::cos(full_turn * turns), std::sin(full_turn * turns), 0);
}

/// Elliptic, not quite plane, thicker in places.
inline Known_shape ring(Random& random)
{
  const double width = random.uniform(0.7, 1), bend = random.uniform(0, 0.25);
  const double radius = random.uniform(0.16, 0.25), variation = random.uniform(0, 0.35);
  const double phase = random.uniform();
  const int swellings = random.integer(1, 3);
  const auto curve = [&](double t) {
    const Vector on_ellipse = on_circle(t).cwiseProduct(Vector(1, width, 0));
    return Bead{on_ellipse + bend * std::cos(2 * full_turn * t) * Vector::UnitZ(),
                radius * (1 + variation * std::sin(full_turn * (swellings * t + phase)))};
  };
  Known_shape shape;
  add_limb(shape, along_closed(curve, 64));
  set_counts(shape, 1, 1, 0);
  return shape;
}

/// About as thick as its hole is wide.
inline Known_shape fat_torus(Random& random)
{
  const double radius = random.uniform(0.42, 0.52), width = random.uniform(0.92, 1);
  const auto curve = [&](double t) {
    return Bead{on_circle(t).cwiseProduct(Vector(1, width, 0)), radius};
  };
  Known_shape shape;
  add_limb(shape, along_closed(curve, 64));
  set_counts(shape, 1, 1, 0);
  return shape;
}

/// The smallest distance between two points of a closed curve that are farther apart along it.
inline double distance_between_strands(const std::vector<Vector>& curve)
{
  const std::size_t size = curve.size();
  double smallest = std::numeric_limits<double>::infinity();
  for(std::size_t i = 0; i < size; ++i) {
    double walked = 0;
    bool is_far = false;
    for(std::size_t step = 1; step <= size / 2; ++step) {
      const Vector& p = curve[(i + step) % size];
      walked += (p - curve[(i + step - 1) % size]).norm();
      const double distance = (p - curve[i]).norm();
      is_far = is_far || walked > full_turn / 4 * 1.2 * distance; // more than half of a circle
      if(is_far)
        smallest = std::min(smallest, distance);
    }
  }
  return smallest;
}

/// On a torus, around its axis `first` times and around its tube `second` times.
inline Known_shape knot(Random& random)
{
  constexpr std::array<std::pair<int, int>, 3> windings = {{{2, 3}, {3, 2}, {2, 5}}};
  const auto chosen = windings[static_cast<std::size_t>(random.in_turn(0, 2))];
  const double tube = random.uniform(0.4, 0.5), height = random.uniform(1, 1.4);
  const auto centre = [&](double t) {
    const Vector out = on_circle(chosen.first * t), round = on_circle(chosen.second * t);
    return Vector((1 + tube * round.x()) * out + height * tube * round.y() * Vector::UnitZ());
  };
  constexpr int pieces = 160;
  std::vector<Vector> curve;
  for(int i = 0; i < pieces; ++i)
    curve.push_back(centre(static_cast<double>(i) / pieces));
  const double gap_in_radii = random.uniform(1.1, 1.8);
  const double radius = distance_between_strands(curve) / (2 + gap_in_radii);
  Known_shape shape;
  add_limb(shape, along_closed([&](double t) { return Bead{centre(t), radius}; }, pieces));
  set_counts(shape, 1, 1, 0);
  return shape;
}

/// Arcs between two poles, around the line that joins them.
inline Known_shape theta(Random& random)
{
  const int number_of_arcs = random.in_turn(3, 5);
  const double length = random.uniform(0.9, 1.4), phase = random.uniform();
  const Bead south = {Vector(-length, 0, 0), random.uniform(0.18, 0.24)};
  const Bead north = {Vector(length, 0, 0), random.uniform(0.18, 0.24)};
  Known_shape shape;
  for(int i = 0; i < number_of_arcs; ++i) {
    const double height = random.uniform(0.9, 1.2), radius = random.uniform(0.13, 0.2);
    const double turns = phase + (i + random.uniform(-0.1, 0.1)) / number_of_arcs;
    const Vector circle = on_circle(turns), out(0, circle.x(), circle.y());
    const auto curve = [&](double t) {
      const Vector on_arc = on_circle(0.5 - t / 2);
      return Bead{length * on_arc.x() * Vector::UnitX() + height * on_arc.y() * out, radius};
    };
    add_limb(shape, along_between(south.centre, curve, north.centre, 32));
  }
  set_counts(shape, 1, static_cast<std::size_t>(number_of_arcs - 1), 0);
  return shape;
}

/// Rings in a row, joined by bars, each turned about the row.
inline Known_shape chain_of_rings(Random& random)
{
  const int number_of_rings = random.in_turn(3, 4);
  const double radius = random.uniform(0.36, 0.42), bar = random.uniform(1, 1.2);
  Known_shape shape;
  Vector begin = Vector::Zero();
  for(int i = 0; i < number_of_rings; ++i) {
    const double length = random.uniform(0.95, 1.1), height = random.uniform(0.9, 1.1);
    const Vector circle = on_circle(random.uniform()), up(0, circle.x(), circle.y());
    const Vector end = begin + 2 * length * Vector::UnitX();
    for(double side : {-1.0, 1.0}) {
      const auto curve = [&](double t) {
        const Vector on_arc = on_circle(0.5 - t / 2);
        const Vector along_row = length * (1 + on_arc.x()) * Vector::UnitX();
        return Bead{begin + along_row + side * height * on_arc.y() * up, radius};
      };
      add_limb(shape, along_between(begin, curve, end, 24));
    }
    begin = end + bar * Vector::UnitX();
    if(i + 1 < number_of_rings)
      add_limb(shape, {{end, radius}, {begin, radius}});
  }
  set_counts(shape, 1, static_cast<std::size_t>(number_of_rings), 0);
  return shape;
}

/// Corners joined by straight edges, at every corner a ball of its own size.
inline void add_edges(Known_shape& shape, const Limb& corners,
                      const std::vector<std::pair<std::size_t, std::size_t>>& edges)
{
  for(const auto& edge : edges)
    add_limb(shape, {corners[edge.first], corners[edge.second]});
}

/// The edges of a prism over a regular polygon; of a box if that has four corners.
inline Known_shape prism(Random& random)
{
  const int sides = random.in_turn(3, 5);
  const std::size_t n = static_cast<std::size_t>(sides);
  const double circumradius = random.uniform(0.85, 1.1), height = random.uniform(1.1, 1.5);
  Limb corners;
  for(int level = 0; level < 2; ++level)
    for(int i = 0; i < sides; ++i) {
      const Vector corner = circumradius * on_circle(static_cast<double>(i) / sides);
      corners.push_back({corner + level * height * Vector::UnitZ(), random.uniform(0.145, 0.18)});
    }
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  for(std::size_t i = 0; i < n; ++i) {
    edges.emplace_back(i, i + n);
    edges.emplace_back(i, (i + 1) % n);
    edges.emplace_back(n + i, n + (i + 1) % n);
  }
  Known_shape shape;
  add_edges(shape, corners, edges);
  set_counts(shape, 1, n + 1, 0);
  return shape;
}

/// The edges of a rectangular grid, like a window's.
inline Known_shape grid(Random& random)
{
  const int columns = random.integer(2, 3), rows = random.integer(1, 3);
  const double width = random.uniform(0.85, 1.05), height = random.uniform(0.85, 1.05);
  const double radius = random.uniform(0.17, 0.2);
  const auto index = [&](int x, int y) { return static_cast<std::size_t>(y * (columns + 1) + x); };
  Limb corners;
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  for(int y = 0; y <= rows; ++y)
    for(int x = 0; x <= columns; ++x) {
      corners.push_back({Vector(x * width, y * height, 0), radius * random.uniform(0.95, 1.05)});
      if(x > 0)
        edges.emplace_back(index(x - 1, y), index(x, y));
      if(y > 0)
        edges.emplace_back(index(x, y - 1), index(x, y));
    }
  Known_shape shape;
  add_edges(shape, corners, edges);
  set_counts(shape, 1, static_cast<std::size_t>(columns * rows), 0);
  return shape;
}

inline Known_shape frame(Random& random)
{
  return random.in_turn(0, 3) == 3 ? grid(random) : prism(random);
}

} // namespace families
} // namespace shapes

#endif // POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_FAMILIES_LOOPS_H
