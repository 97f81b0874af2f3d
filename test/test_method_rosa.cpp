// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial

// Axes of rotational symmetry of planar cuts, joined to a skeleton.

#include "catch2.h"
#include "method_checks.h"
#include "method_shapes.h"

#include "methods/rosa.h"

TEST_CASE("ROSA: a cylinder is one branch on the axis")
{
  const shapes::Shape shape = shapes::cylinder();
  const Method_input input = shapes::method_input(shape);
  const Method_result result = rosa(input);
  const Graph_counts counts = shapes::counts_of(result, input);
  CHECK(counts.components == 1);
  CHECK(counts.cycles == 0);
  CHECK(counts.ends == 2);
  CHECK(shapes::off_axis(result.skeleton, shape).back() < 0.2);
}

TEST_CASE("ROSA: a Y has three ends")
{
  const shapes::Shape shape = shapes::y_junction();
  const Method_input input = shapes::method_input(shape);
  const Method_result result = rosa(input);
  const Graph_counts counts = shapes::counts_of(result, input);
  CHECK(counts.components == 1);
  CHECK(counts.cycles == 0);
  CHECK(counts.ends == 3);
  CHECK(counts.junctions == 1);
  CHECK(shapes::median_off_axis(result.skeleton, shape) < 0.1);
}

TEST_CASE("ROSA: a ring is one cycle")
{
  const shapes::Shape shape = shapes::ring();
  const Method_input input = shapes::method_input(shape);
  const Method_result result = rosa(input);
  const Graph_counts counts = shapes::counts_of(result, input);
  CHECK(counts.components == 1);
  CHECK(counts.cycles == 1);
  CHECK(counts.ends == 0);
  CHECK(shapes::median_off_axis(result.skeleton, shape) < 0.1);
}

TEST_CASE("ROSA: every component has a skeleton of its own")
{
  const Method_input input = shapes::method_input(shapes::two_parts());
  const Graph_counts counts = shapes::counts_of(rosa(input), input);
  CHECK(counts.components == 2);
  CHECK(counts.ends == 4);
}
