// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Rows of a sheet are merged into pieces as long as the rows are apart, and nothing else is.

#include "catch2.h"
#include "generator/Random.h"
#include "threads.h"

#include <CGAL/Point_set_skeletonization_3/internal/consolidation/crossing_rows.h>
#include <CGAL/Point_set_skeletonization_3/internal/consolidation/merge_rows.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numeric>
#include <vector>

using namespace CGAL::Point_set_skeletonization_3::internal;
using shapes::Random;

namespace merge_rows_test {

constexpr unsigned seeds = 3;
constexpr double spacing = 0.01, flatness = 0.02;

/// A mixture of which nothing was moved.
Consolidated_mixture mixture_of(const std::vector<Vector3>& places)
{
  Consolidated_mixture result;
  for(const Vector3& p : places)
    result.components.push_back({1, p, Matrix3::Zero()});
  result.tree = Box_tree(places);
  result.merged_into.resize(places.size());
  std::iota(result.merged_into.begin(), result.merged_into.end(), std::size_t(0));
  result.cell_size = spacing;
  result.neighbors =
    k_nearest_neighbors(result.tree, surface_neighbors + 1, Concurrency::sequential);
  return result;
}

Consolidated_mixture merged(const std::vector<Vector3>& places,
                            Concurrency concurrency = Concurrency::sequential)
{
  return with_rows_merged(mixture_of(places), flatness, concurrency);
}

/// Lines along a direction in the plane z = 0, `apart` spacings from each other.
std::vector<Vector3> rows(int number, double apart, double angle, Random& random)
{
  const Vector3 along(std::cos(angle), std::sin(angle), 0), across(-along.y(), along.x(), 0);
  std::vector<Vector3> result;
  for(int row = 0; row < number; ++row)
    for(int k = 0; k < 100; ++k)
      result.push_back(spacing * ((k + random.uniform(-0.3, 0.3)) * along + row * apart * across));
  return result;
}

TEST_CASE("Rows become pieces as long as they are apart, of one row each")
{
  for(unsigned seed = 0; seed < seeds; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const double apart = random.uniform(5, 9);
    const std::vector<Vector3> places = rows(12, apart, random.uniform(0, 3), random);
    const Consolidated_mixture result = merged(places);
    // Cells are a power of two wide, and the borders of some cut off short pieces.
    const double pieces = static_cast<double>(places.size()) / apart;
    CHECK(static_cast<double>(result.components.size()) < 2 * pieces);
    CHECK(static_cast<double>(result.components.size()) > pieces / 2);
    double weight = 0;
    std::vector<Vector3> sums(result.components.size(), Vector3::Zero());
    for(std::size_t i = 0; i < places.size(); ++i) {
      REQUIRE(result.merged_into[i] < sums.size());
      sums[result.merged_into[i]] += places[i];
      // A piece is in one row: none is further away than along it.
      CHECK((places[i] - result.components[result.merged_into[i]].mean).norm() <
            2 * apart * spacing);
    }
    for(std::size_t piece = 0; piece < sums.size(); ++piece) {
      const Gaussian& component = result.components[piece];
      weight += component.weight;
      CHECK((sums[piece] / component.weight - component.mean).norm() < 1e-12);
    }
    CHECK(weight == static_cast<double>(places.size()));
  }
}

TEST_CASE("A plane that is sampled evenly stays as it is, and so do two wires and a fork")
{
  for(unsigned seed = 0; seed < seeds; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    std::vector<Vector3> plane;
    for(int k = 0; k < 3000; ++k)
      plane.push_back(spacing * Vector3(random.uniform(0, 50), random.uniform(0, 50), 0));
    CHECK(merged(plane).components.size() == plane.size());

    const std::vector<Vector3> wires =
      rows(2, random.uniform(4, 8), random.uniform(0, 3), random);
    CHECK(merged(wires).components.size() == wires.size());

    std::vector<Vector3> fork;
    for(const double angle : {0.0, 1.7, 2.4, 4.0})
      for(const Vector3& p : rows(1, 0, angle, random))
        fork.push_back(p);
    CHECK(merged(fork).components.size() == fork.size());
  }
}

TEST_CASE("Rows that cross fill the cells of a level, single points none")
{
  for(unsigned seed = 0; seed < seeds; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    constexpr double wide = 12, apart = 5;
    const double angle = random.uniform(0, 3);
    std::vector<Vector3> places = rows(20, apart, angle, random);
    for(const Vector3& p : rows(20, apart, angle + CGAL_PI / 2, random))
      places.push_back(p + 100 * spacing * Vector3(std::cos(angle), std::sin(angle), 0));
    const auto are_rows = [](const std::vector<Vector3>& crossing) {
      const Consolidated_mixture mixture = mixture_of(crossing);
      const Component_octree octree(mixture.components, mixture.cell_size);
      const std::vector<int> levels =
        Crossing_rows(mixture.components, mixture.neighbors, octree, flatness,
                      Concurrency::sequential)
          .levels();
      return std::count(levels.begin(), levels.end(), 0) < std::ptrdiff_t(levels.size() / 2);
    };
    CHECK(are_rows(places));
    for(Vector3& p : places)
      p *= wide;
    CHECK_FALSE(are_rows(places));
  }
}

TEST_CASE("Beside rows that are far apart, cells of an even part are wider, and narrower further on")
{
  for(unsigned seed = 0; seed < seeds; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    std::vector<Vector3> places;
    for(int k = 0; k < 10000; ++k)
      places.push_back(spacing * Vector3(random.uniform(-100, 0), random.uniform(0, 100), 0));
    const double apart = 8;
    for(const Vector3& p : rows(12, apart, CGAL_PI / 2, random)) // along y, towards smaller x
      places.emplace_back(spacing - p.x(), p.y(), 0);
    const Consolidated_mixture result = merged(places);
    const auto share_left = [&](double begin, double end) { // of places between two x, in spacings
      const auto is_between = [&](const Vector3& p) {
        return p.x() >= spacing * begin && p.x() < spacing * end;
      };
      const std::vector<Vector3> left = means_of(result.components);
      return double(std::count_if(left.begin(), left.end(), is_between)) /
             double(std::count_if(places.begin(), places.end(), is_between));
    };
    CHECK(share_left(-2, 0) < 0.5);
    CHECK(share_left(-100, -50) == 1);
  }
}

TEST_CASE("Merged rows do not depend on threads")
{
  Random random(7);
  const std::vector<Vector3> places = rows(30, 6, 0.4, random);
  const Consolidated_mixture one = merged(places);
  REQUIRE(one.components.size() < places.size());
  for_threads([&](Concurrency concurrency) {
    CHECK(merged(places, concurrency).merged_into == one.merged_into);
  });
}

} // namespace merge_rows_test
