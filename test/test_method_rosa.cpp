// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Axes of rotational symmetry of planar cuts, joined to a skeleton.

#include "catch2.h"
#include "method_checks.h"
#include "method_shapes.h"

#include "methods/rosa.h"

namespace {

Method_input input_of(const shapes::Shape& shape)
{
  return shapes::method_input(shape);
}

} // namespace

TEST_CASE("ROSA: a cylinder is one branch, a Y has three ends, a ring is one cycle")
{
  const shapes::Off_axis off = {0.2, 0.1, 0.1};
  shapes::check_simple_shapes(rosa, input_of, off);
}

TEST_CASE("ROSA: every component has a skeleton of its own")
{
  const Method_input input = input_of(shapes::two_parts());
  shapes::check_skeleton(rosa(input), input, shapes::two_parts(), 2, 0, 4, 0.1);
}
