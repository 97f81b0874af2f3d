// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What tells points on lines from others: their nearest neighbourhoods.

#include "catch2.h"
#include "generator/Random.h"

#include <CGAL/Point_set_skeletonization_3/internal/core/straightness.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace straightness_test {

using namespace CGAL::Point_set_skeletonization_3::internal;
using shapes::Random;

namespace {

/// Of some points: how many are straight with their nearest.
Straightness straightness_of(const std::vector<Vector3>& points)
{
  Straightness result;
  for(const Vector3& p : points) {
    std::vector<Vector3> near = points;
    std::sort(near.begin(), near.end(), [&](const Vector3& a, const Vector3& b) {
      return (a - p).squaredNorm() < (b - p).squaredNorm();
    });
    result.add(are_straight(places_of_line, [&](std::size_t k) { return near[k]; }));
  }
  return result;
}

std::vector<Vector3> random_points(unsigned int seed, const Vector3& extent)
{
  constexpr std::size_t size = 300;
  Random random(seed);
  std::vector<Vector3> result;
  for(std::size_t i = 0; i < size; ++i)
    result.push_back(random.uniform_vector().cwiseProduct(extent));
  return result;
}

} // namespace

TEST_CASE("Points of a thin twig are on lines, those of a plane and of a volume are not")
{
  const unsigned int seed = GENERATE(1u, 2u, 3u);
  const double unit = GENERATE(1e-6, 1.0, 1e6);
  CAPTURE(seed, unit);
  const auto are_on_lines = [&](const Vector3& extent) {
    return straightness_of(random_points(seed, unit * extent)).is_on_lines();
  };
  constexpr double spacing = 1. / 300;
  CHECK(are_on_lines({1, spacing, spacing}));
  CHECK_FALSE(are_on_lines({1, 1, 0}));
  CHECK_FALSE(are_on_lines({1, 1, 1}));
}

TEST_CASE("Crossing lines are lines, and too few points are none")
{
  std::vector<Vector3> cross = random_points(1, {1, 0, 0});
  for(const Vector3& p : random_points(2, {1, 0, 0}))
    cross.emplace_back(0.5, p.x() - 0.5, 0);
  CHECK(straightness_of(cross).is_on_lines());
  CHECK_FALSE(are_straight(2, [](std::size_t k) -> Vector3 { return Vector3(double(k), 0, 0); }));
  CHECK_FALSE(are_straight(5, [](std::size_t) -> Vector3 { return Vector3::Zero(); }));
}

} // namespace straightness_test
