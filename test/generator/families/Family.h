// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_FAMILIES_FAMILY_H
#define POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_FAMILIES_FAMILY_H

#include "../Known_shape.h"
#include "../Random.h"

#include <map>
#include <string>
#include <vector>

namespace shapes {

/// Draws a shape of a kind.
using Family = Known_shape (*)(Random&);

using Families = std::map<std::string, Family>;

inline std::vector<std::string> names_of(const Families& families)
{
  std::vector<std::string> names;
  for(const auto& family : families)
    names.push_back(family.first);
  return names;
}

} // namespace shapes

#endif // POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_FAMILIES_FAMILY_H
