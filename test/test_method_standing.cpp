// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Where this package is behind the methods that take raw points.

#include "catch2.h"

#include "Table.h"
#include "comparison/lost_figures.h"

#include <cmath>
#include <limits>
#include <sstream>

namespace {

Compared row(const std::string& method, double off_centre)
{
  Compared result;
  result.input = "shape";
  result.method = method;
  result.status = "ok";
  result.measured.off_centre = off_centre;
  return result;
}

} // namespace

TEST_CASE("Standing: within 5 % of the first is not behind")
{
  CHECK(standing_of({row("l1_medial", 0.104), row("lapcon10", 0.1)}).lost.empty());
  const Standing standing = standing_of({row("l1_medial", 0.106), row("lapcon10", 0.1)});
  REQUIRE(standing.lost.size() == 1);
  CHECK(standing.compared == 1);
  CHECK(standing.lost.front().figure == "off_centre");
  CHECK(standing.lost.front().best_method == "lapcon10");
}

TEST_CASE("Standing: what is infinite, off-centre where a skeleton is outside, is a dash in tables")
{
  CHECK(fixed(std::numeric_limits<double>::infinity(), 3) == "-");
  CHECK(fixed(not_measured, 3) == "-");
  CHECK(fixed(0.25, 3) == "0.250");
}

TEST_CASE("Standing: methods that need more than points are not compared")
{
  CHECK(standing_of({row("l1_medial", 0.2), row("mcf", 0.1), row("rosa", 0.1)}).compared == 0);
}

TEST_CASE("Standing: without a skeleton, or with one that is outside, a method is behind")
{
  Compared failed = row("l1_medial", 0);
  failed.status = "failed";
  CHECK(standing_of({failed, row("lapcon10", 0.1)}).lost.size() == 1);
  const double outside = std::numeric_limits<double>::infinity();
  CHECK(standing_of({row("l1_medial", outside), row("lapcon10", 0.1)}).lost.size() == 1);
  CHECK(standing_of({row("l1_medial", 0.1), row("lapcon10", outside)}).lost.empty());
}

TEST_CASE("Standing: cycles and ends count as they differ from the truth")
{
  Compared ours = row("l1_medial", 0.1), other = row("lapcon10", 0.1);
  for(Compared* each : {&ours, &other})
    each->measured.truth = {1, 2, 3};
  ours.measured.got.cycles = 3;
  other.measured.got.cycles = 2;
  ours.measured.got.ends = 3;
  other.measured.got.ends = 1;
  const Standing standing = standing_of({ours, other});
  REQUIRE(standing.lost.size() == 1);
  CHECK(standing.lost.front().figure == "cycles");
  CHECK(standing.lost.front().ours == 1);
  CHECK(standing.compared == 3);
}

TEST_CASE("Standing: every input and level of noise for itself")
{
  Compared noisy = row("l1_medial", 0.2), noisy_other = row("lapcon10", 0.1);
  noisy.noise = noisy_other.noise = 0.01;
  const Standing standing =
      standing_of({row("l1_medial", 0.1), row("lapcon10", 0.1), noisy, noisy_other});
  REQUIRE(standing.lost.size() == 1);
  CHECK(standing.lost.front().noise == 0.01);
  std::ostringstream out;
  print_standing(out, standing);
  CHECK(out.str().find("1 of 2") != std::string::npos);
}
