// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_FAMILIES_H
#define POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_FAMILIES_H

#include "Known_shape.h"

#include <string>
#include <vector>


namespace shapes {

/// Kinds of shapes that `known_shape()` draws, in alphabetical order.
const std::vector<std::string>& family_names();

/// A shape of a family; the seed chooses its dimensions, angles, numbers of limbs and orientation.
///
/// What the families keep to, so that no one would draw another skeleton, even with noise: a limb's
/// radius is at least 2.5 % of the bounding box' diagonal; a limb with a free end sticks out of
/// what it sits on by at least 2.5 times the radius of that; a loop's hole is at least 1.5 times as
/// wide as the radius of the tube around it; and between limbs that do not meet there is a gap of
/// at least the radius of the thinner.
///
/// \throws std::invalid_argument if there is no family of that name
Known_shape known_shape(const std::string& family, unsigned seed);

} // namespace shapes

#endif // POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_FAMILIES_H
