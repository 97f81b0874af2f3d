// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_FAMILIES_H
#define POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_FAMILIES_H

#include "Known_shape.h"
#include "Random.h"
#include "drawing.h"
#include "families/Family.h"
#include "families/bodies.h"
#include "families/letters.h"
#include "families/loops.h"
#include "families/trees.h"

#include <stdexcept>
#include <string>
#include <vector>

namespace shapes {

namespace families {

inline const Families& all()
{
  static const Families families = {
      {"body_with_limbs", body_with_limbs},
      {"chain_of_rings", chain_of_rings},
      {"fat_torus", fat_torus},
      {"frame", frame},
      {"hand", hand},
      {"helix", helix},
      {"knot", knot},
      {"letter", letter},
      {"parallel_prongs", parallel_prongs},
      {"plant", plant},
      {"plate_with_handles", plate_with_handles},
      {"ring", ring},
      {"theta", theta},
      {"two_parts", two_parts},
      {"worm", worm},
  };
  return families;
}

} // namespace families

/// Kinds of shapes that `known_shape()` draws, in alphabetical order.
inline const std::vector<std::string>& family_names()
{
  static const std::vector<std::string> names = names_of(families::all());
  return names;
}

/// A shape of a family; the seed chooses its dimensions, angles, numbers of limbs and orientation.
///
/// What the families keep to, so that no one would draw another skeleton, even with noise: a limb's
/// radius is at least 2.5 % of the bounding box' diagonal; a limb with a free end sticks out of
/// what it sits on by at least 2.5 times the radius of that; a loop's hole is at least 1.5 times as
/// wide as the radius of the tube around it; and between limbs that do not meet there is a gap of
/// at least the radius of the thinner.
///
/// \throws std::invalid_argument if there is no family of that name
inline Known_shape known_shape(const std::string& family, unsigned seed)
{
  const auto found = families::all().find(family);
  if(found == families::all().end())
    throw std::invalid_argument("known_shape: no family " + family);
  Random random(seed);
  const Known_shape shape = found->second(random);
  return finished(shape, random.rotation(), family, seed);
}

} // namespace shapes

#endif // POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_FAMILIES_H
