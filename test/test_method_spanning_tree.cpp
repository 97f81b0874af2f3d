// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The spanning tree of thinned points: a tree without short twigs.

#include "catch2.h"
#include "method_checks.h"

#include "methods/spanning_tree.h"

#include <cstddef>

namespace {

// Thinner than a cell: its tree is a curve.
constexpr double wire = 0.001;

Graph_counts counts_of(const shapes::Shape& shape)
{
  Method_input input;
  input.points = shapes::to_points<Kernel>(shapes::sample(shape, 2000, 1));
  const Method_result result = spanning_tree(input);
  CHECK(shapes::median_off_axis(result.skeleton, shape) < 1);
  return shapes::counts_of(result, input);
}

} // namespace

TEST_CASE("Spanning tree: a wire has two ends, a Y three")
{
  for(const std::size_t ends : {2, 3}) {
    CAPTURE(ends);
    const Graph_counts counts =
        counts_of(ends == 2 ? shapes::cylinder(wire) : shapes::y_junction(wire));
    CHECK(counts.components == 1);
    CHECK(counts.cycles == 0);
    CHECK(counts.ends == ends);
  }
}

TEST_CASE("Spanning tree: a ring is opened")
{
  const Graph_counts counts = counts_of(shapes::ring(wire));
  CHECK(counts.components == 1);
  CHECK(counts.cycles == 0);
  CHECK(counts.ends == 2);
  CHECK(counts.length > 0.9 * 2 * shapes::pi);
}

TEST_CASE("Spanning tree: two parts are joined")
{
  const Graph_counts counts = counts_of(shapes::two_parts(wire));
  CHECK(counts.components == 1);
  CHECK(counts.cycles == 0);
}
