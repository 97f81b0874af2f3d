// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Samples that contract to L1-medians, and the branches they form.

#include "catch2.h"
#include "method_checks.h"
#include "method_shapes.h"

#include "methods/l1_wlop.h"

#include <stdexcept>

namespace {

/// The least radius comes from the number of points: fewer than these, and it is not local.
Method_input points_of(const shapes::Shape& shape)
{
  Method_input input;
  input.points = shapes::to_points<Kernel>(shapes::sample(shape, 5000, 2));
  return input;
}

} // namespace

TEST_CASE("L1-WLOP: a cylinder is one branch, a Y has three ends, a ring is one cycle")
{
  const shapes::Off_axis off = {0.2, 0.1, 0.2}; // medians of arcs lie inwards
  shapes::check_simple_shapes(l1_wlop, points_of, off);
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
