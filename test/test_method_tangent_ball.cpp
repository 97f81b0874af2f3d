// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial

// Shrunk tangent balls, joined to a skeleton.

#include "catch2.h"
#include "method_checks.h"
#include "method_shapes.h"

#include "methods/tangent_ball.h"

#include <stdexcept>

TEST_CASE("Tangent balls: a cylinder is one branch on the axis")
{
  const shapes::Shape shape = shapes::cylinder();
  const Method_input input = shapes::method_input(shape);
  const Method_result result = tangent_ball(input);
  const Graph_counts counts = shapes::counts_of(result, input);
  CHECK(counts.components == 1);
  CHECK(counts.cycles == 0);
  CHECK(counts.ends == 2);
  CHECK(shapes::off_axis(result.skeleton, shape).back() < 0.1);
}

TEST_CASE("Tangent balls: their radius is that of the tube")
{
  const Method_input input = shapes::method_input(shapes::cylinder(0.2));
  const Skeleton skeleton = tangent_ball(input).skeleton;
  for(const auto v : boost::make_iterator_range(vertices(skeleton)))
    CHECK(skeleton[v].radius == Approx(0.2).epsilon(0.1));
}

TEST_CASE("Tangent balls: a Y has three ends")
{
  const shapes::Shape shape = shapes::y_junction();
  const Method_input input = shapes::method_input(shape);
  const Method_result result = tangent_ball(input);
  const Graph_counts counts = shapes::counts_of(result, input);
  CHECK(counts.components == 1);
  CHECK(counts.cycles == 0);
  CHECK(counts.ends == 3);
  CHECK(counts.junctions == 1);
  CHECK(shapes::median_off_axis(result.skeleton, shape) < 0.1);
}

TEST_CASE("Tangent balls: a ring is one cycle")
{
  const shapes::Shape shape = shapes::ring();
  const Method_input input = shapes::method_input(shape);
  const Method_result result = tangent_ball(input);
  const Graph_counts counts = shapes::counts_of(result, input);
  CHECK(counts.components == 1);
  CHECK(counts.cycles == 1);
  CHECK(counts.ends == 0);
  CHECK(shapes::median_off_axis(result.skeleton, shape) < 0.1);
}

TEST_CASE("Tangent balls: every component has a skeleton of its own")
{
  const Method_input input = shapes::method_input(shapes::two_parts());
  const Graph_counts counts = shapes::counts_of(tangent_ball(input), input);
  CHECK(counts.components == 2);
  CHECK(counts.ends == 4);
}

TEST_CASE("Tangent balls: normals that point inwards are an error")
{
  Method_input input = shapes::method_input(shapes::cylinder());
  for(auto& normal : input.normals)
    normal = -normal;
  CHECK_THROWS_AS(tangent_ball(input), std::runtime_error);
}
