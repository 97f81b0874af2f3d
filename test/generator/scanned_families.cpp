// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scanned_families.h"

#include "Random.h"
#include "drawing.h"
#include "families.h"
#include "families/Family.h"
#include "families/crowns.h"
#include "families/leaves.h"
#include "families/wires.h"

namespace shapes {

namespace families {

const Families& scanned()
{
  static const Families families = {
      {"crown_in_leaf", crown_in_leaf},
      {"lattice", lattice},
      {"leafy_plant", leafy_plant},
      {"tree", tree},
      {"tube_frame", tube_frame},
      {"wire_frame", wire_frame},
  };
  return families;
}

} // namespace families

const std::vector<std::string>& scanned_family_names()
{
  static const std::vector<std::string> names = names_of(families::scanned());
  return names;
}

Known_shape scanned_shape(const std::string& family, unsigned seed)
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
