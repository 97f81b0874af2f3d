// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial

// Clouds contracted to curves.

#include "catch2.h"
#include "method_checks.h"
#include "method_shapes.h"

#include "methods/lapcon10.h"

#include <cstddef>

namespace {

Graph_counts check_centred(const shapes::Shape& shape)
{
  const Method_input input = shapes::method_input(shape);
  const Method_result result = lapcon10(input);
  CHECK(shapes::median_off_axis(result.skeleton, shape) < 0.7); // a ring contracts as a whole, too
  return shapes::counts_of(result, input);
}

void check_tree(const shapes::Shape& shape, std::size_t components, std::size_t ends)
{
  const Graph_counts counts = check_centred(shape);
  CHECK(counts.components == components);
  CHECK(counts.cycles == 0);
  CHECK(counts.ends == ends);
}

} // namespace

TEST_CASE("LapCon10: a cylinder has two ends, a Y three, two cylinders four")
{
  check_tree(shapes::cylinder(0.1), 1, 2);
  check_tree(shapes::y_junction(0.1), 1, 3);
  check_tree(shapes::two_parts(0.1), 2, 4);
}

TEST_CASE("LapCon10: a ring is one cycle")
{
  const Graph_counts counts = check_centred(shapes::ring(0.1));
  CHECK(counts.components == 1);
  CHECK(counts.cycles == 1);
  CHECK(counts.ends == 0);
}
