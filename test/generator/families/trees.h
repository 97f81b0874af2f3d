// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_FAMILIES_TREES_H
#define POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_FAMILIES_TREES_H

#include "../Random.h"
#include "../drawing.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

/// Families of limbs without cycles.
namespace shapes {
namespace families {

/// A single bent limb whose thickness varies.
inline Known_shape worm(Random& random)
{
  const double radius = random.uniform(0.1, 0.18), variation = random.uniform(0, 0.3);
  const double swing = random.uniform(0.1, 0.35), lift = random.uniform(0, 0.3);
  const double phase = random.uniform();
  const auto curve = [&](double t) {
    const double angle = full_turn * (t + phase);
    return Bead{Vector(2.4 * t, swing * std::sin(angle), lift * std::cos(1.3 * angle)),
                radius * (1 + variation * std::sin(1.7 * angle))};
  };
  Known_shape shape;
  add_limb(shape, along(curve, 48));
  set_counts(shape, 1, 0, 2);
  return shape;
}

/// A spring, possibly narrower at one end.
inline Known_shape helix(Random& random)
{
  const double turns = random.uniform(1.5, 3), radius = random.uniform(0.15, 0.2);
  const double pitch = radius * random.uniform(3.6, 5), narrowing = random.uniform(0, 0.3);
  const auto curve = [&](double t) {
    const double angle = full_turn * turns * t, size = 1 - narrowing * t;
    return Bead{Vector(size * std::cos(angle), size * std::sin(angle), pitch * turns * t),
                radius * (1 - 0.2 * t)};
  };
  Known_shape shape;
  add_limb(shape, along(curve, static_cast<int>(40 * turns)));
  set_counts(shape, 1, 0, 2);
  return shape;
}

/// Directions that fork off `direction` at about `angle`, spread around it.
inline std::vector<Vector> fork(const Vector& direction, int size, double angle, Random& random)
{
  const Vector u = direction.unitOrthogonal(), v = direction.cross(u);
  const double phase = random.uniform();
  std::vector<Vector> result;
  for(int i = 0; i < size; ++i) {
    const double round = full_turn * (phase + (i + random.uniform(-0.08, 0.08)) / size);
    const double tilt = angle + random.uniform(-0.1, 0.1);
    result.push_back(std::cos(tilt) * direction +
                     std::sin(tilt) * (std::cos(round) * u + std::sin(round) * v));
  }
  return result;
}

/// The limbs of a plant above a fork; the last generation ends freely.
inline void grow(std::vector<Limb>& limbs, const Bead& begin, const Vector& direction,
                 double length, int generations, Random& random)
{
  constexpr double taper = 0.85;
  const Bead end = {begin.centre + length * direction, taper * begin.radius};
  const Vector bend = 0.05 * length * random.direction();
  limbs.push_back(bent_limb(begin, end, bend));
  if(generations == 0)
    return;
  for(const Vector& child : fork(direction, random.integer(2, 3), 0.85, random)) {
    const double child_length = random.uniform(1.1, 1.4);
    grow(limbs, end, child, child_length, generations - 1, random);
  }
}

/// Whether limbs that do not meet are apart by at least the radius of the thinner.
inline bool are_apart(const std::vector<Limb>& limbs)
{
  const auto meet = [](const Limb& a, const Limb& b) {
    return a.front().centre == b.front().centre || a.front().centre == b.back().centre ||
           a.back().centre == b.front().centre || a.back().centre == b.back().centre;
  };
  for(std::size_t i = 0; i < limbs.size(); ++i)
    for(std::size_t j = 0; j < i; ++j)
      if(!meet(limbs[i], limbs[j]))
        for(const Bead& a : limbs[i])
          for(const Bead& b : limbs[j])
            if((a.centre - b.centre).norm() <
               a.radius + b.radius + 1.2 * std::min(a.radius, b.radius))
              return false;
  return true;
}

/// Whether no other limb goes on where this one ends.
inline bool is_free(const Limb& limb, const std::vector<Limb>& limbs)
{
  return std::none_of(limbs.begin(), limbs.end(), [&](const Limb& other) {
    return other.front().centre == limb.back().centre;
  });
}

/// A stem that forks into branches and those into twigs.
inline Known_shape plant(Random& random)
{
  std::vector<Limb> limbs;
  do {
    limbs.clear();
    const Bead root = {Vector::Zero(), random.uniform(0.3, 0.36)};
    const double height = random.uniform(1.2, 1.6);
    grow(limbs, root, Vector::UnitZ(), height, random.in_turn(1, 2), random);
  } while(!are_apart(limbs));
  Known_shape shape;
  for(const Limb& limb : limbs)
    add_limb(shape, limb);
  const auto tips = std::count_if(limbs.begin(), limbs.end(),
                                  [&](const Limb& limb) { return is_free(limb, limbs); });
  set_counts(shape, 1, 0, static_cast<std::size_t>(tips) + 1);
  return shape;
}

/// A fork: prongs on a crossbar with a handle; the gaps are about as wide as a prong's radius.
inline Known_shape parallel_prongs(Random& random)
{
  const int prongs = random.in_turn(2, 5);
  const double radius = random.uniform(0.105, 0.13), spacing = radius * random.uniform(3.1, 3.8);
  const double length = random.uniform(0.9, 1.3), handle = random.uniform(0.9, 1.4);
  const double half_width = 0.5 * spacing * (prongs - 1);
  std::vector<double> places = {0}; // on the bar
  Known_shape shape;
  for(int i = 0; i < prongs; ++i) {
    const double x = 2 * i + 1 == prongs ? 0 : spacing * i - half_width;
    places.push_back(x);
    const Vector foot(x, 0, 0), tip(x, length * random.uniform(0.9, 1.1), 0);
    add_limb(shape, {{foot, radius}, {tip, 0.95 * radius}});
  }
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  for(std::size_t i = 1; i < places.size(); ++i)
    add_limb(shape, {{Vector(places[i - 1], 0, 0), radius}, {Vector(places[i], 0, 0), radius}});
  add_limb(shape, {{Vector::Zero(), radius}, {Vector(0, -handle, 0), 1.2 * radius}});
  set_counts(shape, 1, 0, static_cast<std::size_t>(prongs) + 1);
  return shape;
}

} // namespace families
} // namespace shapes

#endif // POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_FAMILIES_TREES_H
