// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Shortest paths over a mesh: trees on its surface.

#include "catch2.h"
#include "method_checks.h"
#include "method_shapes.h"

#include "methods/teasar.h"

#include <cstddef>

namespace {

// A tree that reaches all limbs and has no spurs; on the surface, one radius from the axis.
void check_tree(const shapes::Shape& shape, std::size_t components, std::size_t ends)
{
  const Method_input input = shapes::method_input(shape);
  const Method_result result = teasar(input);
  const Graph_counts counts = shapes::counts_of(result, input);
  CHECK(counts.components == components);
  CHECK(counts.cycles == 0);
  CHECK(counts.ends == ends);
  CHECK(counts.junctions == ends - 2 * components);
  for(const double distance : shapes::off_axis(result.skeleton, shape))
    CHECK(distance == Approx(1));
}

} // namespace

TEST_CASE("TEASAR: a path or a tree that reaches the tips of the limbs")
{
  for(const double radius : {0.1, 0.2}) {
    CAPTURE(radius);
    check_tree(shapes::cylinder(radius), 1, 2);
    check_tree(shapes::y_junction(radius), 1, 3);
    check_tree(shapes::two_parts(radius), 2, 4);
  }
}

TEST_CASE("TEASAR: a ring becomes a tree that goes around it, with one branch more at most")
{
  for(const double radius : {0.1, 0.2}) {
    CAPTURE(radius);
    const Method_input input = shapes::method_input(shapes::ring(radius));
    const Graph_counts counts = shapes::counts_of(teasar(input), input);
    CHECK(counts.components == 1);
    CHECK(counts.cycles == 0);
    CHECK(counts.ends >= 2);
    CHECK(counts.ends <= 3);
    CHECK(counts.length > 1.6 * shapes::pi);
  }
}
