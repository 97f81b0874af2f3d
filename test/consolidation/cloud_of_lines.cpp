// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Clouds of lines are told from others; in them nothing moves and no twig is an outlier.

#include "catch2.h"
#include "generator/Random.h"

#include <CGAL/Point_set_skeletonization_3/internal/consolidation/cloud_of_lines.h>
#include <CGAL/Point_set_skeletonization_3/internal/consolidation/consolidate.h>
#include <CGAL/Point_set_skeletonization_3/internal/consolidation/merge_rows.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/K_nearest_neighbors.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace cloud_of_lines_test {

using namespace CGAL::Point_set_skeletonization_3::internal;
using shapes::Random;

namespace {

constexpr unsigned seeds = 3;
constexpr double width = 0.002; // of twigs; their points are ten times as far apart

void add(Gaussians& cloud, const Vector3& place) { cloud.push_back({1, place, Matrix3::Zero()}); }

/// Twigs in random directions, each beginning on one before it. Along every other one points are
/// five times as far apart.
Gaussians twigs(std::size_t number, Random& random)
{
  constexpr int points = 30;
  Gaussians result;
  add(result, Vector3::Zero());
  for(std::size_t twig = 0; twig < number; ++twig) {
    const Vector3 root =
      result[static_cast<std::size_t>(random.uniform() * static_cast<double>(result.size()))].mean;
    const Vector3 direction = random.direction();
    const double apart = twig % 2 == 0 ? 10 * width : 50 * width;
    for(int k = 1; k <= points; ++k)
      add(result, root + (k + random.uniform(-0.4, 0.4)) * apart * direction +
                    width * random.uniform_vector());
  }
  return result;
}

Gaussians random_cloud(std::size_t size, const std::function<Vector3()>& draw)
{
  Gaussians result;
  for(std::size_t i = 0; i < size; ++i)
    add(result, draw());
  return result;
}

bool is_of_lines(const Gaussians& cloud)
{
  const Box_tree tree(means_of(cloud));
  return is_cloud_of_lines(
    cloud, tree, k_nearest_neighbors(tree, surface_neighbors + 1, Concurrency::sequential));
}

Consolidated_mixture consolidated(const Gaussians& cloud, double cell_size)
{
  return consolidate(cloud, Neighborhood(cloud, Concurrency::sequential), cell_size,
                     Consolidation_options(), Concurrency::sequential);
}

} // namespace

TEST_CASE("Twigs of single points are a cloud of lines; surfaces, their rims and volumes are none")
{
  for(unsigned seed = 0; seed < seeds; ++seed) {
    Random random(seed);
    const double unit = std::vector<double>{1e-6, 1, 1e6}[seed % 3];
    CAPTURE(seed, unit);
    const auto scaled = [&](Gaussians cloud) {
      for(Gaussian& g : cloud)
        g.mean *= unit;
      return cloud;
    };
    for(const std::size_t number : {20, 60, 200}) // more components than are asked, too
      CHECK(is_of_lines(scaled(twigs(number, random))));
    for(const std::size_t size : {1000, 3000, 9000}) {
      CAPTURE(size);
      const auto draw = [&](const std::function<Vector3()>& place) {
        return is_of_lines(scaled(random_cloud(size, place)));
      };
      CHECK_FALSE(draw([&] { return random.direction(); }));
      CHECK_FALSE(draw([&] { return random.uniform_vector(); }));
      CHECK_FALSE(draw([&] { // a strip: half of the points are near its rim
        return Vector3(random.uniform(0, 20), random.uniform(0, 4), 0);
      }));
    }
  }
}

TEST_CASE("The fewer components there are, the less it takes to be a cloud of lines; of 500 nothing")
{
  for(const std::size_t number : {750, 1500, 3000, 10000})
    CHECK(least_share_on_lines(number) < least_share_on_lines(2 * number));
  CHECK(least_share_on_lines(100000) > 1);
  for(unsigned seed = 0; seed < seeds; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    CHECK(is_of_lines(random_cloud(500, [&] { return random.direction(); })));
  }
}

TEST_CASE("Any few points, however they coincide, are a cloud of lines or none")
{
  Gaussians cloud;
  for(int k = 0; k < 12; ++k) {
    add(cloud, Vector3(k % 2, 0, 0));
    CHECK_NOTHROW(is_of_lines(cloud));
  }
}

TEST_CASE("In a cloud of lines nothing moves, and twigs are no outliers, but most points in space are")
{
  std::size_t outliers_dropped = 0, all_outliers = 0; // of all seeds: some are beside twigs
  for(unsigned seed = 0; seed < seeds; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    Gaussians cloud = twigs(60, random);
    const std::size_t number = cloud.size(), outliers = number / 50;
    Eigen::AlignedBox3d box;
    for(const Gaussian& g : cloud)
      box.extend(g.mean);
    for(std::size_t k = 0; k < outliers; ++k)
      add(cloud, box.min() + box.sizes().cwiseProduct(random.uniform_vector()));
    const Consolidated_mixture result = consolidated(cloud, 0);
    REQUIRE(result.is_of_lines);
    CHECK(result.noise == 0);
    all_outliers += outliers;
    std::size_t twigs_dropped = 0;
    for(std::size_t i = 0; i < cloud.size(); ++i)
      if(result.merged_into[i] == Consolidated_mixture::none)
        ++(i < number ? twigs_dropped : outliers_dropped);
      else
        REQUIRE(result.components[result.merged_into[i]].mean == cloud[i].mean);
    CHECK(100 * twigs_dropped < 5 * number);
  }
  CHECK(2 * outliers_dropped > all_outliers);
}

TEST_CASE("Rows of a sheet look like a cloud of lines until they are merged, lines always")
{
  constexpr double spacing = 0.01, flatness = 0.02, apart = 8;
  for(unsigned seed = 0; seed < seeds; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    Gaussians rows;
    for(int row = 0; row < 20; ++row)
      for(int k = 0; k < 150; ++k)
        add(rows, spacing * Vector3(k + random.uniform(-0.3, 0.3), apart * row, 0));
    const Consolidated_mixture mixture = consolidated(rows, spacing);
    CHECK_FALSE(with_rows_merged(mixture, flatness, Concurrency::sequential).is_of_lines);
    const Consolidated_mixture lines = consolidated(twigs(60, random), 10 * width);
    CHECK(with_rows_merged(lines, flatness, Concurrency::sequential).is_of_lines);
  }
}

} // namespace cloud_of_lines_test
