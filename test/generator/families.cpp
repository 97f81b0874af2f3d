// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "families.h"

#include "Random.h"
#include "drawing.h"
#include "families/Family.h"
#include "families/bodies.h"
#include "families/letters.h"
#include "families/loops.h"
#include "families/trees.h"

#include <stdexcept>

namespace shapes {

namespace families {

const Families& all()
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

const std::vector<std::string>& family_names()
{
  static const std::vector<std::string> names = names_of(families::all());
  return names;
}

Known_shape known_shape(const std::string& family, unsigned seed)
{
  const auto found = families::all().find(family);
  if(found == families::all().end())
    throw std::invalid_argument("known_shape: no family " + family);
  Random random(seed);
  const Known_shape shape = found->second(random);
  return finished(shape, random.rotation(), family, seed);
}

} // namespace shapes
