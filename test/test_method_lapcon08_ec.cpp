// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Meshes contracted to curves, and their edges collapsed.

#include "catch2.h"
#include "method_checks.h"
#include "method_shapes.h"

#include "methods/lapcon08_ec.h"

#include <cstddef>

namespace {

void check(const shapes::Shape& shape, std::size_t components, std::size_t cycles, std::size_t ends)
{
  const Method_input input = shapes::method_input(shape);
  shapes::check_skeleton(lapcon08_ec(input), input, shape, components, cycles, ends, 0.25);
}

} // namespace

TEST_CASE("LapCon08EC: a cylinder has two ends, a Y three, two cylinders four, a ring is one cycle")
{
  check(shapes::cylinder(0.2), 1, 0, 2);
  check(shapes::y_junction(0.2), 1, 0, 3);
  check(shapes::two_parts(0.2), 2, 0, 4);
  check(shapes::ring(0.2), 1, 1, 0);
}
