// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_SCANNED_FAMILIES_H
#define POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_SCANNED_FAMILIES_H

#include "Known_shape.h"

#include <string>
#include <vector>

namespace shapes {

/// Kinds of shapes that only a scan can show: upright ones with limbs of few points or with sheets.
const std::vector<std::string>& scanned_family_names();

/// A shape to be scanned: of one of these families, or of any other. Limbs that do not meet do not
/// touch. \throws std::invalid_argument if there is no family of that name
Known_shape scanned_shape(const std::string& family, unsigned seed);

} // namespace shapes

#endif // POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_SCANNED_FAMILIES_H
