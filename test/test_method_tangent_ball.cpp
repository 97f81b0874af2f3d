// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial

// Shrunk tangent balls, joined to a skeleton.

#include "catch2.h"
#include "method_checks.h"
#include "method_shapes.h"

#include "methods/tangent_ball.h"

#include <cstddef>
#include <stdexcept>

namespace {

Skeleton check(const shapes::Shape& shape, std::size_t components, std::size_t cycles,
               std::size_t ends, double off)
{
  const Method_input input = shapes::method_input(shape);
  const Method_result result = tangent_ball(input);
  shapes::check_skeleton(result, input, shape, components, cycles, ends, off);
  return result.skeleton;
}

} // namespace

TEST_CASE("Tangent balls: a cylinder is one branch on the axis")
{
  const Skeleton skeleton = check(shapes::cylinder(), 1, 0, 2, 0.1);
  CHECK(shapes::off_axis(skeleton, shapes::cylinder()).back() < 0.1);
}

TEST_CASE("Tangent balls: a Y has three ends")
{
  CHECK(count_graph(check(shapes::y_junction(), 1, 0, 3, 0.1)).junctions == 1);
}

TEST_CASE("Tangent balls: a ring is one cycle")
{
  check(shapes::ring(), 1, 1, 0, 0.1);
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
  check(shapes::two_parts(), 2, 0, 4, 0.1);
}

TEST_CASE("Tangent balls: normals that point inwards are an error")
{
  Method_input input = shapes::method_input(shapes::cylinder());
  for(auto& normal : input.normals)
    normal = -normal;
  CHECK_THROWS_AS(tangent_ball(input), std::runtime_error);
}
