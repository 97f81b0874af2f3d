// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Shrunk tangent balls, joined to a skeleton.

#include "catch2.h"
#include "method_checks.h"
#include "method_shapes.h"

#include "methods/tangent_ball.h"

#include <stdexcept>

namespace {

Method_input input_of(const shapes::Shape& shape)
{
  return shapes::method_input(shape);
}

} // namespace

TEST_CASE("Tangent balls: a cylinder is one branch, a Y has three ends, a ring is one cycle")
{
  const shapes::Off_axis off = {0.1, 0.1, 0.1};
  shapes::check_simple_shapes(tangent_ball, input_of, off);
}

TEST_CASE("Tangent balls: their radius is that of the tube")
{
  const Method_input input = shapes::method_input(shapes::cylinder(0.2));
  const Skeleton skeleton = tangent_ball(input).skeleton;
  for(const auto v : boost::make_iterator_range(vertices(skeleton)))
    CHECK(skeleton[v].radius == Approx(0.2).epsilon(0.1));
}

TEST_CASE("Tangent balls: every component has a skeleton of its own")
{
  const Method_input input = input_of(shapes::two_parts());
  shapes::check_skeleton(tangent_ball(input), input, shapes::two_parts(), 2, 0, 4, 0.1);
}

TEST_CASE("Tangent balls: normals that point inwards are an error")
{
  Method_input input = shapes::method_input(shapes::cylinder());
  for(auto& normal : input.normals)
    normal = -normal;
  CHECK_THROWS_AS(tangent_ball(input), std::runtime_error);
}
