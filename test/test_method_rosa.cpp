// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial

// Axes of rotational symmetry of planar cuts, joined to a skeleton.

#include "catch2.h"
#include "method_checks.h"
#include "method_shapes.h"

#include "methods/rosa.h"

#include <cstddef>

namespace {

Skeleton check(const shapes::Shape& shape, std::size_t components, std::size_t cycles,
               std::size_t ends, double off)
{
  const Method_input input = shapes::method_input(shape);
  const Method_result result = rosa(input);
  shapes::check_skeleton(result, input, shape, components, cycles, ends, off);
  return result.skeleton;
}

} // namespace

TEST_CASE("ROSA: a cylinder is one branch on the axis")
{
  const Skeleton skeleton = check(shapes::cylinder(), 1, 0, 2, 0.1);
  CHECK(shapes::off_axis(skeleton, shapes::cylinder()).back() < 0.2);
}

TEST_CASE("ROSA: a Y has three ends")
{
  CHECK(count_graph(check(shapes::y_junction(), 1, 0, 3, 0.1)).junctions == 1);
}

TEST_CASE("ROSA: a ring is one cycle")
{
  check(shapes::ring(), 1, 1, 0, 0.1);
}

TEST_CASE("ROSA: every component has a skeleton of its own")
{
  check(shapes::two_parts(), 2, 0, 4, 0.1);
}
