// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Rows that a surface was sampled in are found, however curved it is; wires and twigs are none.

#include "catch2.h"
#include "generator/Random.h"
#include "threads.h"

#include <CGAL/Point_set_skeletonization_3/internal/consolidation/parallel_rows.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/K_nearest_neighbors.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace parallel_rows_test {

using namespace CGAL::Point_set_skeletonization_3::internal;
using shapes::Random;

namespace {

constexpr unsigned seeds = 3;

std::vector<double> distances_of_rows(const std::vector<Vector3>& places, double longest_step = 2,
                                      Concurrency concurrency = Concurrency::sequential)
{
  const Box_tree tree(places);
  const K_nearest_neighbors nearest =
    k_nearest_neighbors(tree, surface_neighbors + 1, Concurrency::sequential);
  return Parallel_rows(places, tree, nearest, longest_step, concurrency).distances();
}

double share_on_lines(const std::vector<Vector3>& places)
{
  const Box_tree tree(places);
  return Parallel_rows(places, tree,
                       k_nearest_neighbors(tree, surface_neighbors + 1, Concurrency::sequential),
                       2, Concurrency::sequential)
    .share_on_lines();
}

double share_in_rows(const std::vector<Vector3>& places)
{
  const std::vector<double> distances = distances_of_rows(places);
  return double(std::count_if(distances.begin(), distances.end(),
                              [](double distance) { return distance > 0; })) /
         double(distances.size());
}

/// Places one step apart along a line.
void add_line(std::vector<Vector3>& places, const Vector3& from, const Vector3& direction,
              int number, Random& random)
{
  for(int k = 0; k < number; ++k)
    places.push_back(from + (k + random.uniform(-0.3, 0.3)) * direction +
                     0.05 * random.uniform_vector());
}

} // namespace

TEST_CASE("Rows around a tube and along it are as far apart as they are")
{
  const bool is_around = GENERATE(true, false);
  for(unsigned seed = 0; seed < seeds; ++seed) {
    Random random(seed);
    const double apart = random.uniform(4, 7); // steps
    CAPTURE(seed, apart, is_around);
    std::vector<Vector3> tube;
    if(is_around) {
      const double radius = 2 * apart;
      for(int slice = 0; slice < 20; ++slice)
        for(double place = 0; place < 2 * CGAL_PI * radius; ++place) {
          const double angle = (place + random.uniform(-0.3, 0.3)) / radius;
          tube.emplace_back(radius * std::cos(angle), radius * std::sin(angle), slice * apart);
        }
    }
    else {
      constexpr int around = 8;
      const double radius = apart / (2 * std::sin(CGAL_PI / around));
      for(int row = 0; row < around; ++row) {
        const double angle = 2 * CGAL_PI * row / around;
        add_line(tube, radius * Vector3(std::cos(angle), std::sin(angle), 0),
                 Vector3::UnitZ(), 100, random);
      }
    }
    std::size_t right = 0;
    for(const double distance : distances_of_rows(tube))
      right += distance > 0.8 * apart && distance < 1.2 * apart;
    CHECK(static_cast<double>(right) > 0.95 * static_cast<double>(tube.size()));
  }
}

TEST_CASE("What is sampled evenly, twigs, nets and wires far from each other are no rows")
{
  for(unsigned seed = 0; seed < seeds; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    std::vector<Vector3> plane, volume, twigs, net, wires;
    for(int k = 0; k < 3000; ++k) {
      plane.emplace_back(random.uniform(0, 50), random.uniform(0, 50), 0);
      volume.push_back(15 * random.uniform_vector());
    }
    CHECK(share_on_lines(plane) < 0.1);
    CHECK(share_in_rows(plane) == 0);
    CHECK(share_in_rows(volume) == 0);

    for(int twig = 0; twig < 100; ++twig)
      add_line(twigs, 100 * random.uniform_vector(), random.direction(), 30, random);
    CHECK(share_on_lines(twigs) > 0.9);
    CHECK(share_in_rows(twigs) == 0);

    for(int wire = 0; wire < 10; ++wire) {
      add_line(net, Vector3(0, 10 * wire, 0), Vector3::UnitX(), 90, random);
      add_line(net, Vector3(10 * wire, 0, 0), Vector3::UnitY(), 90, random);
      add_line(wires, Vector3(0, 20 * wire, 0), Vector3::UnitX(), 90, random);
    }
    CHECK(share_in_rows(net) == 0);
    CHECK(share_in_rows(wires) == 0);
  }
}

TEST_CASE("Rows are followed to the rims of a sheet, though nothing is beyond")
{
  for(unsigned seed = 0; seed < seeds; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    std::vector<Vector3> sheet;
    for(int row = 0; row < 8; ++row)
      add_line(sheet, Vector3(0, 5 * row, 0), Vector3::UnitX(), 60, random);
    CHECK(share_in_rows(sheet) > 0.97);
    std::vector<Vector3> two; // wires: neither has one on both sides
    add_line(two, Vector3::Zero(), Vector3::UnitX(), 60, random);
    add_line(two, Vector3(0, 5, 0), Vector3::UnitX(), 60, random);
    CHECK(share_in_rows(two) == 0);
  }
}

TEST_CASE("Rows do not depend on the unit, nor on threads")
{
  Random random(7);
  std::vector<Vector3> places;
  for(int row = 0; row < 30; ++row)
    add_line(places, Vector3(0, 5 * row, 0.01 * row * row), Vector3::UnitX(), 100, random);
  const std::vector<double> expected = distances_of_rows(places);
  for_threads([&](Concurrency concurrency) {
    CHECK(distances_of_rows(places, 2, concurrency) == expected);
  });
  for(Vector3& p : places)
    p *= 1024;
  CHECK(distances_of_rows(places) == std::vector<double>(places.size(), 0)); // single points
  std::vector<double> scaled = distances_of_rows(places, 2048);
  for(double& distance : scaled)
    distance /= 1024;
  CHECK(scaled == expected);
}

} // namespace parallel_rows_test
