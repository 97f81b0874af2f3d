// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial

// Samples that contract to L1-medians, and the branches they form.

#include "catch2.h"
#include "method_checks.h"
#include "method_shapes.h"

#include "methods/l1_wlop.h"

#include <cstddef>
#include <stdexcept>

namespace {

/// The least radius comes from the number of points: fewer than these, and it is not local.
Method_input points_of(const shapes::Shape& shape)
{
  Method_input input;
  input.points = shapes::to_points<Kernel>(shapes::sample(shape, 5000, 2));
  return input;
}

Skeleton check(const shapes::Shape& shape, std::size_t components, std::size_t cycles,
               std::size_t ends, double off)
{
  const Method_input input = points_of(shape);
  const Method_result result = l1_wlop(input);
  shapes::check_skeleton(result, input, shape, components, cycles, ends, off);
  return result.skeleton;
}

} // namespace

TEST_CASE("L1-WLOP: a cylinder is one branch on the axis")
{
  const Skeleton skeleton = check(shapes::cylinder(), 1, 0, 2, 0.1);
  CHECK(shapes::off_axis(skeleton, shapes::cylinder()).back() < 0.2);
}

TEST_CASE("L1-WLOP: a Y has three ends")
{
  CHECK(count_graph(check(shapes::y_junction(), 1, 0, 3, 0.1)).junctions == 1);
}

TEST_CASE("L1-WLOP: a ring is one cycle")
{
  check(shapes::ring(), 1, 1, 0, 0.2); // medians of arcs lie inwards
}

TEST_CASE("L1-WLOP: parts that are apart stay apart")
{
  const Method_input input = points_of(shapes::two_parts());
  const Graph_counts counts = shapes::counts_of(l1_wlop(input), input);
  CHECK(counts.components == 2);
  CHECK(counts.cycles == 0);
}

TEST_CASE("L1-WLOP: too few points for a branch are an error")
{
  Method_input input;
  input.points = {Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0)};
  CHECK_THROWS_AS(l1_wlop(input), std::runtime_error);
}
