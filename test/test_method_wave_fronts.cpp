// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Rings of vertices of a mesh, collapsed to their centres.

#include "catch2.h"
#include "method_checks.h"
#include "method_shapes.h"

#include "methods/wave_fronts.h"

#include <cstddef>

namespace {

constexpr double radii[] = {0.1, 0.2};

// A tree that reaches all ends, with a spur at most, as where waves part or end in bits of a ring.
void check_tree(const shapes::Shape& shape, std::size_t ends)
{
  const Method_input input = shapes::method_input(shape);
  const Method_result result = wave_fronts(input);
  const Graph_counts counts = shapes::counts_of(result, input);
  CHECK(counts.components == 1);
  CHECK(counts.cycles == 0);
  CHECK(counts.ends >= ends);
  CHECK(counts.ends <= ends + 1);
  CHECK(shapes::median_off_axis(result.skeleton, shape) < 0.25);
}

} // namespace

TEST_CASE("Wave fronts: a cylinder has two ends, a Y three")
{
  for(const double radius : radii) {
    CAPTURE(radius);
    check_tree(shapes::cylinder(radius), 2);
    check_tree(shapes::y_junction(radius), 3);
  }
}

TEST_CASE("Wave fronts: a ring is one cycle, with a spur at the seed and some where waves meet")
{
  for(const double radius : radii) {
    CAPTURE(radius);
    const shapes::Shape shape = shapes::ring(radius);
    const Method_input input = shapes::method_input(shape);
    const Method_result result = wave_fronts(input);
    const Graph_counts counts = shapes::counts_of(result, input);
    CHECK(counts.components == 1);
    CHECK(counts.cycles == 1);
    CHECK(counts.ends <= 4);
    CHECK(shapes::median_off_axis(result.skeleton, shape) < 0.25);
  }
}

TEST_CASE("Wave fronts: every component has a skeleton of its own")
{
  const Method_input input = shapes::method_input(shapes::two_parts(0.2));
  const Graph_counts counts = shapes::counts_of(wave_fronts(input), input);
  CHECK(counts.components == 2);
  CHECK(counts.cycles == 0);
}
