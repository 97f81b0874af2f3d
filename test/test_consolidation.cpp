// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Noise is taken off a mixture, and nothing else.

#include "catch2.h"
#include "generator/Random.h"

#include <CGAL/Point_set_skeletonization_3/internal/surface/patches.h>
#include <CGAL/Point_set_skeletonization_3/internal/consolidation/consolidate.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

using namespace CGAL::Point_set_skeletonization_3::internal;
using shapes::Random;

namespace {

constexpr unsigned seeds = 3;

Gaussians components(std::size_t size, const std::function<Vector3()>& draw)
{
  Gaussians result;
  for(std::size_t i = 0; i < size; ++i)
    result.push_back({1, draw(), Matrix3::Zero()});
  return result;
}

Consolidated_surface consolidated(const Gaussians& mixture)
{
  using Tag = CGAL::Sequential_tag;
  const Box_tree tree = tree_of_means<Tag>(mixture);
  return Surface_consolidation<Tag>(mixture, tree, patch_neighborhoods<Tag>(tree))();
}

/// Values of what is no outlier.
std::vector<double> kept(const Consolidated_surface& surface,
                         const std::function<double(const Vector3&)>& value)
{
  std::vector<double> result;
  for(std::size_t i = 0; i < surface.positions.size(); ++i)
    if(!surface.outlier[i])
      result.push_back(value(surface.positions[i]));
  return result;
}

double root_mean_square(const std::vector<double>& values)
{
  double sum = 0;
  for(double v : values)
    sum += v * v;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

double widest_gap(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  double result = 0;
  for(std::size_t i = 1; i < values.size(); ++i)
    result = std::max(result, values[i] - values[i - 1]);
  return result;
}

} // namespace

// Points that are dropped take their places in the neighbourhoods of the others with them.
TEST_CASE("neighbourhoods of the points that are left are those asked anew")
{
  for(unsigned seed = 0; seed < seeds; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    std::vector<Vector3> all(500), left;
    for(Vector3& p : all)
      p = random.direction();
    std::vector<std::size_t> index_of(all.size(), all.size());
    for(std::size_t i = all.size(); i-- > 0;) // backwards: another order
      if(i % 100 != seed) {
        index_of[i] = left.size();
        left.push_back(all[i]);
      }
    using Tag = CGAL::Sequential_tag;
    const Box_tree tree_of_all(all.size(), [&](std::size_t i) { return all[i]; });
    const Box_tree tree_of_left(left.size(), [&](std::size_t i) { return left[i]; });
    const K_nearest_neighbors known =
      renumbered<Tag>(neighborhoods<Tag>(tree_of_all, 7), index_of, tree_of_left);
    const K_nearest_neighbors asked = neighborhoods<Tag>(tree_of_left, 7);
    for(std::size_t i = 0; i < left.size(); ++i) {
      REQUIRE(known[i].size() == asked[i].size());
      for(std::size_t k = 0; k < asked[i].size(); ++k)
        CHECK(known[i].begin()[k].index == asked[i].begin()[k].index);
    }
  }
}

TEST_CASE("Where there is no noise nothing moves")
{
  for(unsigned seed = 0; seed < seeds; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Gaussians sphere = components(2000, [&] { return random.direction(); });
    const Consolidated_surface surface = consolidated(sphere);
    CHECK(surface.noise == 0);
    for(std::size_t i = 0; i < sphere.size(); ++i)
      CHECK(surface.positions[i] == sphere[i].mean);
  }
}

TEST_CASE("A noisy plane becomes flat and keeps its width")
{
  constexpr double sigma = 0.03; // a spacing and a half
  for(unsigned seed = 0; seed < seeds; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Gaussians plane = components(2000, [&] {
      const double x = random.uniform(), y = random.uniform(), z = sigma * random.normal();
      return Vector3(x, y, z);
    });
    const Consolidated_surface surface = consolidated(plane);
    CHECK(surface.noise > 0.5);
    CHECK(root_mean_square(kept(surface, [](const Vector3& p) { return p.z(); })) < sigma / 3);
    const std::vector<double> x = kept(surface, [](const Vector3& p) { return p.x(); });
    CHECK(*std::max_element(x.begin(), x.end()) - *std::min_element(x.begin(), x.end()) > 0.9);
  }
}

TEST_CASE("A twig drowned in noise becomes thin and does not gather in lumps")
{
  constexpr double sigma = 0.01;
  for(unsigned seed = 0; seed < seeds; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Gaussians twig = components(500, [&] {
      const double x = random.uniform(), y = sigma * random.normal(), z = sigma * random.normal();
      return Vector3(x, y, z);
    });
    const auto along = [](const Vector3& p) { return p.x(); };
    const auto across = [](const Vector3& p) { return std::hypot(p.y(), p.z()); };
    const Consolidated_surface surface = consolidated(twig);
    CHECK(root_mean_square(kept(surface, across)) < sigma);
    CHECK(widest_gap(kept(surface, along)) < 3 * sigma);
  }
}

TEST_CASE("Points far from all others are outliers")
{
  for(unsigned seed = 0; seed < seeds; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    Gaussians sphere = components(2000, [&] { return random.direction(); });
    sphere.push_back({1, Vector3(2, 0, 0), Matrix3::Zero()});
    const Consolidated_surface surface = consolidated(sphere);
    CHECK(surface.outlier.back());
    CHECK(std::count(surface.outlier.begin(), surface.outlier.end(), true) < 20);
  }
}
