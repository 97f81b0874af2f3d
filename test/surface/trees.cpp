// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What a surface of patches is asked through a tree is what a look at every patch gives.

#include "ellipsoid.h"

#include "catch2.h"
#include "generator/Random.h"

#include <CGAL/Point_set_skeletonization_3/internal/surface/Visible_surface.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Winding_number.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/facing.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace trees_test {

using namespace CGAL::Point_set_skeletonization_3::internal;
using surfaces::ellipsoid;
using surfaces::tree_of;

namespace {

constexpr unsigned int seed = 1;

// In [-1, 1)^3.
Vector3 random_vector(shapes::Random& random)
{
  return 2 * random.uniform_vector() - Vector3::Ones();
}

// Places that packets are not filled by, next to each other on a line through the ellipsoid.
std::vector<Vector3> places_on_line(shapes::Random& random)
{
  const Vector3 from = random_vector(random), to = random_vector(random);
  std::vector<Vector3> places;
  for(int k = 0; k < 27; ++k)
    places.push_back(from + k / 27.0 * (to - from));
  return places;
}

double sum_of_dipoles(const Patches& patches, const Vector3& q)
{
  double sum = 0;
  for(const Patch& patch : patches) {
    const Vector3 d = patch.mean - q;
    if(d.norm() > patch.spacing / 2)
      sum += patch.planarity * patch.area * patch.normal.dot(d) / std::pow(d.norm(), 3);
  }
  return sum / (4 * CGAL_PI);
}

} // namespace

TEST_CASE("The distance to the nearest patch that is seen from inside")
{
  CAPTURE(seed);
  const Patches patches = ellipsoid(1000, seed);
  std::vector<double> confidence(patches.size());
  for(std::size_t i = 0; i < confidence.size(); ++i)
    confidence[i] = static_cast<double>(i % 11) / 10;
  const Visible_surface visible(patches, confidence, tree_of(patches));
  const auto expected = [&](const Vector3& q) {
    double nearest = std::numeric_limits<double>::infinity();
    for(std::size_t i = 0; i < patches.size(); ++i) {
      const Vector3 d = patches[i].mean - q;
      if(patches[i].normal.dot(d) > least_visible_cosine(confidence[i]) * d.norm())
        nearest = std::min(nearest, d.norm());
    }
    return nearest;
  };
  shapes::Random random(seed + 5);
  for(int query = 0; query < 20; ++query) {
    const std::vector<Vector3> places = places_on_line(random);
    const std::vector<double> found = visible.distances(places, Concurrency::sequential);
    for(std::size_t k = 0; k < places.size(); ++k)
      REQUIRE(found[k] == Approx(expected(places[k])).epsilon(1e-4));
  }
  std::vector<Vector3> inside;
  for(const Patch& patch : patches)
    inside.push_back(0.9 * patch.mean);
  const std::vector<double> beside =
    visible.distances_beside_patches(inside, Concurrency::sequential);
  for(std::size_t i = 0; i < patches.size(); ++i)
    REQUIRE(beside[i] == Approx(expected(inside[i])).epsilon(1e-4));
  // From outside of all, with every patch turned towards the place away from it.
  const Patches one = {patches[0]};
  CHECK(Visible_surface(one, {1}, tree_of(one))
          .distances({2 * patches[0].mean}, Concurrency::sequential)[0] == 0);
}

TEST_CASE("The winding number is the sum of all dipoles, up to the error of the expansion")
{
  CAPTURE(seed);
  const Patches patches = ellipsoid(3000, seed);
  const Winding_number winding_number(patches, tree_of(patches), Concurrency::sequential);
  shapes::Random random(seed + 3);
  for(int query = 0; query < 300; ++query) {
    const Vector3 q = 1.5 * random_vector(random);
    const double found = winding_number(q);
    REQUIRE(std::abs(found - sum_of_dipoles(patches, q)) < 0.05);
    const Vector3 beside = q + Vector3(0.1, 0, 0);
    const auto both = winding_number(std::array<Vector3, 2>{{q, beside}});
    REQUIRE(std::abs(both[0] - sum_of_dipoles(patches, q)) < 0.05);
    REQUIRE(std::abs(both[1] - sum_of_dipoles(patches, beside)) < 0.05);
    std::vector<Vector3> places;
    for(int k = 0; k < 9; ++k)
      places.push_back(k % 2 == 0 ? q : beside);
    const std::vector<double> of_packets =
      winding_number.at_places(places, Concurrency::sequential);
    for(std::size_t k = 0; k < 9; ++k)
      REQUIRE(std::abs(of_packets[k] - both[k % 2]) < 0.05);
    const double level = q.cwiseQuotient(Vector3(1, 1, 0.4)).norm(); // 1 on the surface
    if(level < 0.7)
      REQUIRE(found > 0.75);
    if(level > 1.5)
      REQUIRE(found < 0.25);
  }
  CHECK(Winding_number({}, Box_tree(), Concurrency::sequential)(Vector3::Zero()) == 0);
}

TEST_CASE("The winding number of patches that coincide is finite, and 0 far away")
{
  for(const std::size_t size : {1u, 20u}) {
    CAPTURE(size);
    Patches patches(size);
    for(Patch& patch : patches) {
      patch.mean = Vector3(0.3, 0.2, 0.1);
      patch.spacing = least_spacing;
      patch.area = least_spacing * least_spacing;
      patch.planarity = 1;
    }
    const Winding_number winding_number(patches, tree_of(patches), Concurrency::sequential);
    CHECK(std::isfinite(winding_number(patches[0].mean)));
    CHECK(std::abs(winding_number(Vector3(0.4, 0.3, 0.2))) < 1e-6);
  }
}

} // namespace trees_test
