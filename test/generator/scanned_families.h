// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_SCANNED_FAMILIES_H
#define POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_SCANNED_FAMILIES_H

#include "Known_shape.h"
#include "Random.h"
#include "drawing.h"
#include "families.h"
#include "families/crowns.h"
#include "families/leaves.h"
#include "families/wires.h"

#include <string>
#include <vector>

namespace shapes {

namespace families {

inline const Families& scanned()
{
  static const Families families = {
      {"crown_in_leaf", crown_in_leaf},
      {"leafy_plant", leafy_plant},
      {"tree", tree},
      {"wire_frame", wire_frame},
  };
  return families;
}

} // namespace families

/// Kinds of shapes that only a scan can show: upright ones with limbs of few points or with sheets.
inline const std::vector<std::string>& scanned_family_names()
{
  static const std::vector<std::string> names = names_of(families::scanned());
  return names;
}

/// A shape to be scanned: of one of these families, or of any other. Limbs that do not meet do not
/// touch. \throws std::invalid_argument if there is no family of that name
inline Known_shape scanned_shape(const std::string& family, unsigned seed)
{
  const auto found = families::scanned().find(family);
  if(found == families::scanned().end())
    return known_shape(family, seed);
  Random random(seed);
  const Known_shape shape = found->second(random);
  const Eigen::AngleAxisd turn(full_turn * random.uniform(), Vector::UnitZ());
  return finished(shape, turn.toRotationMatrix(), family, seed);
}

} // namespace shapes

#endif // POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_SCANNED_FAMILIES_H
