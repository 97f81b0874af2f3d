// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The middle of the points of a limb whose other side was not seen: on a bent sheet, not beside it.

#include "catch2.h"
#include "generator/Random.h"

#include <CGAL/Point_set_skeletonization_3/internal/curve/points_across.h>

#include <CGAL/number_utils.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace points_across_test {

using namespace CGAL::Point_set_skeletonization_3::internal;

namespace {

constexpr double resolution = 0.02, aligned = 0.7;

// Points all along an arc of the circle with radius 1 around the origin, symmetric to the x axis.
Slab arc(double degrees, std::size_t size)
{
  Slab result;
  for(std::size_t i = 0; i < size; ++i) {
    const double share = (static_cast<double>(i) + 0.5) / static_cast<double>(size) - 0.5;
    const double angle = share * degrees * CGAL_PI / 180;
    result.across.emplace_back(std::cos(angle), std::sin(angle));
    result.along.push_back(0.1 * (static_cast<double>(i % 3) - 1));
  }
  return result;
}

double off_arc(double degrees, std::size_t size, double sheet, double facing = 0)
{
  return 1 - points_across(arc(degrees, size), sheet, facing, resolution, aligned).middle.norm();
}

} // namespace

TEST_CASE("The middle of a bent leaf is on it")
{
  for(double degrees : {60., 90., 120.}) {
    CAPTURE(degrees);
    const double beside = off_arc(degrees, 200, 0), on = off_arc(degrees, 200, 1);
    CHECK(beside > 0.01 * degrees / 60);
    CHECK(on < beside / 4);
  }
}

TEST_CASE("Half of a tube has its middle on the axis, a leaf as round that faces a limb on itself")
{
  for(double degrees : {165., 180., 195.}) {
    CAPTURE(degrees);
    const double axis = off_arc(degrees, 200, 0), between = off_arc(degrees, 200, 0, 0.5),
                 on = off_arc(degrees, 200, 0, 1);
    CHECK(axis > 0.95);
    CHECK(on < 0.1);
    CHECK(between > on);
    CHECK(between < axis);
  }
}

TEST_CASE("The middle of a flat leaf stays where it is")
{
  Slab flat;
  for(int i = -100; i <= 100; ++i) {
    flat.across.emplace_back(0.01 * i, 0);
    flat.along.push_back(0.05 * (i % 3));
  }
  const Eigen::Vector2d median = points_across(flat, 1, 0, resolution, aligned).middle;
  CHECK(median.norm() < 0.02);
}

TEST_CASE("Of a dozen points the middle is their median, of a leaf or not")
{
  CHECK(off_arc(120, 12, 1) == off_arc(120, 12, 0));
}

TEST_CASE("Between a sheet and what has points all around, the middle is between both")
{
  const double beside = off_arc(120, 200, 0), on = off_arc(120, 200, 1);
  CHECK(off_arc(120, 200, 0.5) == Approx((beside + on) / 2));
}

TEST_CASE("In the middle of scattered points nearly nothing moves")
{
  for(unsigned int seed : {1, 2, 3}) {
    CAPTURE(seed);
    shapes::Random random(seed);
    Slab disc;
    while(disc.across.size() < 400) {
      const Eigen::Vector2d p(random.uniform(-1, 1), random.uniform(-1, 1));
      if(p.norm() < 1) {
        disc.across.push_back(p);
        disc.along.push_back(random.uniform(-0.1, 0.1));
      }
    }
    const Eigen::Vector2d before = points_across(disc, 0, 0, resolution, aligned).middle;
    CHECK((points_across(disc, 1, 0, resolution, aligned).middle - before).norm() < 0.15);
  }
}

} // namespace points_across_test
