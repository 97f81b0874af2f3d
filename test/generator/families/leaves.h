// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_FAMILIES_LEAVES_H
#define POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_FAMILIES_LEAVES_H

#include "../Random.h"
#include "../drawing.h"
#include "trees.h"

#include <cmath>
#include <cstddef>
#include <vector>

/// Plants whose leaves are sheets.
namespace shapes {
namespace families {

/// A leaf around its midrib, whose radii are half of the width.
inline void add_leaf(Known_shape& shape, const Limb& midrib, const Vector& sideways)
{
  for(std::size_t i = 1; i < midrib.size(); ++i) {
    const Bead &a = midrib[i - 1], &b = midrib[i];
    const Vector at_a = a.radius * sideways, at_b = b.radius * sideways;
    shape.sheets.push_back({a.centre - at_a, a.centre + at_a, b.centre + at_b});
    shape.sheets.push_back({a.centre - at_a, b.centre + at_b, b.centre - at_b});
  }
  add_axis(shape, midrib);
}

/// A stalk and the midrib that goes on where it ends.
struct Stalked_leaf
{
  Limb stalk, midrib;
  Vector sideways;
};

/// Out of the stem at `begin` and away from it, up first, then hanging.
inline Stalked_leaf stalked_leaf(const Bead& begin, const Vector& away, Random& random)
{
  constexpr int pieces = 12;
  const double rise = random.uniform(0.4, 0.9), reach = random.uniform(0.15, 0.25);
  const double length = random.uniform(0.3, 0.45), half_width = length * random.uniform(0.14, 0.24);
  const double hanging = random.uniform(0.2, 0.8), tilt = random.uniform(-0.4, 0.4);
  const Bead end = {begin.centre +
                        reach * (std::cos(rise) * away + std::sin(rise) * Vector::UnitZ()),
                    0.8 * begin.radius};
  const auto curve = [&](double t) {
    const double width = half_width * std::sin(full_turn / 2 * t);
    return Bead{end.centre + length * (t * away + (0.5 - hanging * t) * t * Vector::UnitZ()),
                std::max(end.radius, width)};
  };
  const Vector level = away.cross(Vector::UnitZ());
  return {bent_limb(begin, end, -0.03 * Vector::UnitZ()),
          along_between(end.centre, curve, curve(1).centre, pieces),
          std::cos(tilt) * level + std::sin(tilt) * Vector::UnitZ()};
}

/// A stem with four to nine leaves around it; the skeleton of a leaf is its midrib.
inline Known_shape leafy_plant(Random& random)
{
  constexpr double golden_turn = 0.381966; // from leaf to leaf, so that none is above another
  const int leaves = random.in_turn(4, 9);
  const double radius = random.uniform(0.014, 0.022), phase = random.uniform();
  Limb stem; // a bead where each leaf leaves it
  std::vector<Stalked_leaf> all;
  std::vector<Limb> limbs;
  do {
    stem = {{Vector::Zero(), radius}};
    all.clear();
    limbs.clear();
    for(int i = 0; i < leaves; ++i) {
      const double height = i == 0 ? random.uniform(0.3, 0.4) : random.uniform(0.12, 0.2);
      const Vector lean = 0.1 * height * random.direction();
      const Vector node = stem.back().centre + lean + height * Vector::UnitZ();
      stem.push_back({node, 0.93 * stem.back().radius});
      const double angle = full_turn * (phase + golden_turn * i + random.uniform(-0.05, 0.05));
      const Vector away(std::cos(angle), std::sin(angle), 0);
      all.push_back(stalked_leaf({node, 0.5 * radius}, away, random));
      limbs.push_back(all.back().stalk);
      limbs.push_back(all.back().midrib);
    }
    stem.push_back(
        {stem.back().centre + random.uniform(0.1, 0.15) * Vector::UnitZ(), 0.5 * radius});
  } while(!are_apart(limbs));
  Known_shape shape;
  add_limb(shape, stem);
  for(const Stalked_leaf& leaf : all) {
    add_limb(shape, leaf.stalk);
    add_leaf(shape, leaf.midrib, leaf.sideways);
  }
  set_counts(shape, 1, 0, static_cast<std::size_t>(leaves) + 2);
  return shape;
}

} // namespace families
} // namespace shapes

#endif // POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_FAMILIES_LEAVES_H
