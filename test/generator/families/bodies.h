// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_FAMILIES_BODIES_H
#define POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_FAMILIES_BODIES_H

#include "../Random.h"
#include "../drawing.h"
#include "loops.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

/// Families of a body, fat or flat, with limbs that are much thinner.
namespace shapes {
namespace families {

/// An animal: a body with four to six legs, a head and a tail.
inline Known_shape body_with_limbs(Random& random)
{
  const int legs = random.in_turn(4, 6);
  std::vector<double> leg_radii;
  for(int i = 0; i < legs; ++i)
    leg_radii.push_back(random.uniform(0.23, 0.36));
  const double thickest = *std::max_element(leg_radii.begin(), leg_radii.end());
  const double fat = random.uniform(0.45, 0.52), spacing = 3.2 * thickest;
  Limb body; // a bead where each pair of legs leaves it
  for(int i = 0; i < (legs + 1) / 2; ++i)
    body.push_back({Vector(spacing * i, 0, 0), fat * random.uniform(0.9, 1.05)});
  Known_shape shape;
  add_limb(shape, body);
  for(int i = 0; i < legs; ++i) {
    const Bead& hip = body[static_cast<std::size_t>(i / 2)];
    const double radius = leg_radii[static_cast<std::size_t>(i)];
    const double spread = random.uniform(0.7, 0.95), side = i % 2 == 0 ? -1 : 1;
    const Vector down(0, side * std::sin(spread), -std::cos(spread));
    const double length = fat * random.uniform(3.6, 4);
    add_limb(shape, {{hip.centre, radius}, {hip.centre + length * down, 0.95 * radius}});
  }
  const double neck_rise = random.uniform(0.4, 0.9), tail_rise = random.uniform(0, 0.6);
  const double neck = random.uniform(0.21, 0.24), head = random.uniform(0.3, 0.36);
  const Vector forwards(std::cos(neck_rise), 0, std::sin(neck_rise));
  const Vector throat = body.back().centre + (fat + 0.8) * forwards;
  add_limb(shape, {{body.back().centre, neck}, {throat, neck}, {throat + 0.45 * forwards, head}});
  const Vector backwards(-std::cos(tail_rise), 0, std::sin(tail_rise));
  const double tail = fat * random.uniform(3.6, 4);
  const Bead tail_tip = {body.front().centre + tail * backwards, 0.21};
  add_limb(shape, bent_limb({body.front().centre, 0.24}, tail_tip, Vector(0, 0, -0.1)));
  set_counts(shape, 1, 0, static_cast<std::size_t>(legs) + 2);
  return shape;
}

/// A flat palm with four fingers, a thumb and a wrist.
inline Known_shape hand(Random& random)
{
  const double thickness = random.uniform(0.15, 0.18), finger = random.uniform(0.113, 0.125);
  const double spacing = finger * random.uniform(3.1, 3.5);
  const double half_width = 1.5 * spacing + 1.1 * finger, half_length = random.uniform(0.5, 0.6);
  const double spread = random.uniform(0.02, 0.1);
  const Bead palm = {Vector::Zero(), thickness};
  Known_shape shape;
  shape.solid.add(Rounded_box(palm.centre, Eigen::Matrix3d::Identity(),
                              Vector(half_width, half_length, thickness), 0.9 * thickness));
  const auto add_finger = [&](const Vector& knuckle, const Vector& tip, double radius) {
    add_axis(shape, {palm, {knuckle, thickness}});
    add_limb(shape, {{knuckle, radius}, {tip, 0.95 * radius}});
  };
  for(int i = 0; i < 4; ++i) {
    const double place = i - 1.5, tilt = place * spread;
    const Vector knuckle(place * spacing, half_length - thickness, 0);
    const double length = thickness + random.uniform(0.65, 0.85);
    const Vector along(std::sin(tilt), std::cos(tilt), 0);
    add_finger(knuckle, knuckle + length * along, finger);
  }
  const double thumb = finger * random.uniform(1, 1.2), tilt = random.uniform(0, 0.4);
  const Vector knuckle(half_width - thickness, -0.4 * half_length, 0);
  const double length = thickness + random.uniform(0.65, 0.85);
  add_finger(knuckle, knuckle + length * Vector(std::cos(tilt), std::sin(tilt), 0), thumb);
  const Vector arm = -(half_length + random.uniform(0.6, 0.9)) * Vector::UnitY();
  add_limb(shape, {palm, {arm, 1.1 * thickness}});
  shape.junctions.push_back({palm.centre, half_width}); // the whole palm
  set_counts(shape, 1, 0, 6);
  return shape;
}

/// Handles like a suitcase's, above and below a bar.
inline Known_shape plate_with_handles(Random& random)
{
  const int handles = random.in_turn(1, 3);
  const double thickness = random.uniform(0.2, 0.24), width = thickness * random.uniform(1.2, 1.8);
  const double free_length = width + 2.6 * thickness, span = random.uniform(0.85, 1), gap = 0.65;
  const double length = 2 * free_length + handles * span + (handles - 1) * gap;
  Known_shape shape;
  shape.solid.add(Rounded_box(Vector(length / 2, 0, 0), Eigen::Matrix3d::Identity(),
                              Vector(length / 2, width, thickness), 0.9 * thickness));
  Limb midline = {{Vector(width, 0, 0), thickness}};
  for(int i = 0; i < handles; ++i) {
    const double radius = random.uniform(0.18, 0.2), height = random.uniform(0.75, 0.95);
    const double side = random.integer(0, 1) == 0 ? -1 : 1;
    const Vector begin(free_length + i * (span + gap), 0, 0), end = begin + span * Vector::UnitX();
    const auto curve = [&](double t) {
      const Vector on_arc = on_circle(0.5 - t / 2);
      const Vector foot = begin + span / 2 * (1 + on_arc.x()) * Vector::UnitX();
      return Bead{foot + side * (thickness + height) * on_arc.y() * Vector::UnitZ(), radius};
    };
    add_limb(shape, along_between(begin, curve, end, 32));
    midline.push_back({begin, thickness});
    midline.push_back({end, thickness});
  }
  midline.push_back({Vector(length - width, 0, 0), thickness});
  add_axis(shape, midline);
  set_counts(shape, 1, static_cast<std::size_t>(handles), 2);
  return shape;
}

/// Two linked rings, or a ring beside a Y.
inline Known_shape two_parts(Random& random)
{
  const double radius = random.uniform(0.16, 0.2), other_radius = random.uniform(0.16, 0.2);
  const double shift = random.uniform(0.9, 1.1);
  Known_shape shape;
  add_limb(shape, along_closed([&](double t) { return Bead{on_circle(t), radius}; }, 64));
  if(random.in_turn(0, 1) == 0) {
    const auto upright = [&](double t) {
      const Vector p = on_circle(t);
      return Bead{Vector(shift + p.x(), 0, p.y()), other_radius};
    };
    add_limb(shape, along_closed(upright, 64));
    set_counts(shape, 2, 2, 0);
    return shape;
  }
  const Vector centre(0, 0, 2.5 * (radius + other_radius));
  const double phase = random.uniform();
  for(int i = 0; i < 3; ++i) {
    const double length = random.uniform(0.8, 1.1),
                 turns = phase + (i + random.uniform(-0.15, 0.15)) / 3;
    add_limb(shape, {{centre, other_radius}, {centre + length * on_circle(turns), other_radius}});
  }
  set_counts(shape, 2, 1, 3);
  return shape;
}

} // namespace families
} // namespace shapes

#endif // POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_FAMILIES_BODIES_H
