// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The bulk of a cloud is found whatever lies far away, in any order.

#include "catch2.h"

#include <CGAL/Point_set_skeletonization_3/internal/core/Bulk.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

namespace bulk_test {

using namespace CGAL::Point_set_skeletonization_3::internal;

namespace {

using Points = std::vector<Vector3>;

Points random_points(std::size_t size, double extent, unsigned int seed)
{
  std::mt19937 engine(seed);
  const auto coordinate = [&] {
    return extent * (static_cast<double>(engine()) / 4294967296. - 0.5);
  };
  Points points;
  while(points.size() < size) {
    const double x = coordinate(), y = coordinate(), z = coordinate();
    points.emplace_back(x, y, z);
  }
  return points;
}

Bulk bulk_of(const Points& points, std::size_t parts = 1)
{
  Bulk found;
  bool is_found = false;
  for(int pass = 0; !is_found; ++pass) {
    REQUIRE(pass < 50);
    std::vector<Bulk> bulk(parts, found);
    for(std::size_t i = 0; i < points.size(); ++i)
      bulk[i % parts].add(i, points[i]);
    for(std::size_t k = 1; k < parts; ++k)
      bulk[0].add(bulk[k]);
    is_found = bulk[0].end_pass();
    found = bulk[0];
  }
  return found;
}

Box box_of(const Points& points)
{
  Box box;
  for(const Vector3& p : points)
    box.add(p);
  return box;
}

bool are_equal(const Box& a, const Box& b)
{
  return a.lower() == b.lower() && a.upper() == b.upper();
}

} // namespace

TEST_CASE("Without far points the bulk is everything")
{
  for(const double extent : {0., 1e-320, 1., 1e300, std::numeric_limits<double>::max()})
    for(const std::size_t size : {1u, 2u, 1000u, 9000u}) {
      CAPTURE(extent, size);
      const Points points = random_points(size, extent, 3);
      const Bulk bulk = bulk_of(points);
      CHECK(are_equal(bulk.box(), box_of(points)));
      CHECK(bulk.number_of_far() == 0);
    }
}

TEST_CASE("Up to a thousandth of the points is far, at any distance, in any order and parts")
{
  const Points near = random_points(20000, 1, 5);
  for(const double distance : {5., 1e3, 1e12, 1e300})
    for(const std::size_t far : {1u, 7u, 20u}) {
      CAPTURE(distance, far);
      Points points = near;
      for(const Vector3& p : random_points(far, 1, 7))
        points.push_back(distance * p.normalized());
      for(const std::size_t parts : {1u, 3u}) {
        const Bulk bulk = bulk_of(points, parts);
        CHECK(are_equal(bulk.box(), box_of(near)));
        CHECK(bulk.number_of_far() == far);
        std::reverse(points.begin(), points.end());
      }
    }
}

TEST_CASE("More than a thousandth is another part of the shape")
{
  Points points = random_points(20000, 1, 9);
  for(const Vector3& p : random_points(30, 1, 11))
    points.push_back(p + Vector3(100, 0, 0));
  CHECK(bulk_of(points).number_of_far() == 0);
}

TEST_CASE("Far points at every distance, more than there are cells")
{
  const Points near = random_points(4300000, 1, 13);
  Points points = near;
  double distance = 50;
  for(const Vector3& p : random_points(4300, 1, 15))
    points.push_back((distance *= 1.1) * p.normalized());
  const Bulk bulk = bulk_of(points, 2);
  CHECK(are_equal(bulk.box(), box_of(near)));
  CHECK(bulk.number_of_far() == 4300);
}

TEST_CASE("The first point that is not finite is named")
{
  Points points = random_points(100, 1, 17);
  points[31].y() = std::numeric_limits<double>::quiet_NaN();
  points[57].z() = std::numeric_limits<double>::infinity();
  CHECK_THROWS_WITH(bulk_of(points), ContainsSubstring("point 31 "));
}

} // namespace bulk_test
