// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What is asked through a tree of boxes is what a look at every point gives.

#include "catch2.h"
#include "generator/Random.h"

#include <CGAL/Point_set_skeletonization_3/internal/spatial/Box_tree.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Visible_surface.h>
#include <CGAL/Point_set_skeletonization_3/internal/medial/medial_balls.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/K_nearest_neighbors.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/nearest_points.h>
#include <CGAL/Point_set_skeletonization_3/internal/medial/oriented_mixture.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Winding_number.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <vector>

using namespace CGAL::Point_set_skeletonization_3::internal;

namespace {

constexpr unsigned int seed = 1;

// In [-1, 1)^3.
Vector3 random_vector(shapes::Random& random)
{
  return 2 * random.uniform_vector() - Vector3::Ones();
}

// Every fifth is one and the same point.
std::vector<Vector3> cloud(std::size_t size)
{
  shapes::Random random(seed);
  std::vector<Vector3> points;
  for(std::size_t i = 0; i < size; ++i)
    points.push_back(i % 5 == 0 ? Vector3(0.1, 0.2, 0.3) : random_vector(random));
  return points;
}

Box_tree tree_of(const std::vector<Vector3>& points)
{
  return Box_tree(points.size(), [&](std::size_t i) { return points[i]; });
}

// Patches of an ellipsoid with semi-axes 1, 1 and 0.4, with outward normals.
std::vector<Patch> ellipsoid(std::size_t size)
{
  shapes::Random random(seed);
  const Vector3 axes(1, 1, 0.4);
  std::vector<Patch> patches(size);
  for(Patch& patch : patches) {
    const Vector3 direction = random.direction();
    patch.mean = axes.cwiseProduct(direction);
    patch.normal = direction.cwiseQuotient(axes).normalized();
    // The map from the sphere stretches areas by the product of the axes times |direction / axes|.
    patch.area = 4 * CGAL_PI / static_cast<double>(size) * axes.prod() *
                 direction.cwiseQuotient(axes).norm();
    patch.planarity = 1;
    patch.spacing = std::sqrt(patch.area);
  }
  return patches;
}

Box_tree tree_over(const std::vector<Patch>& patches)
{
  return Box_tree(patches.size(), [&](std::size_t i) { return patches[i].mean; });
}

double sum_of_dipoles(const std::vector<Patch>& patches, const Vector3& q)
{
  double sum = 0;
  for(const Patch& patch : patches) {
    const Vector3 d = patch.mean - q;
    if(d.norm() > patch.spacing / 2)
      sum += patch.planarity * patch.area * patch.normal.dot(d) / std::pow(d.norm(), 3);
  }
  return sum / (4 * CGAL_PI);
}

// Radius of the ball that touches `a` from inside and `b`.
double ball_radius(const Patch& a, const Patch& b)
{
  const Vector3 d = b.mean - a.mean;
  return d.squaredNorm() / (-2 * a.normal.dot(d));
}

} // namespace

TEST_CASE("The points closer than a radius, each once")
{
  for(std::size_t size : {0u, 1u, 8u, 9u, 500u}) {
    CAPTURE(size, seed);
    const std::vector<Vector3> points = cloud(size);
    const Box_tree tree = tree_of(points);
    shapes::Random random(seed + 1);
    for(int query = 0; query < 50; ++query) {
      const Vector3 q = random_vector(random);
      const double radius = random.uniform(0, 1);
      std::vector<std::size_t> found, expected;
      tree.visit_within(q, radius, [&](std::size_t k, double squared_distance) {
        const std::size_t i = tree.order()[k];
        REQUIRE(squared_distance == (points[i] - q).squaredNorm());
        found.push_back(i);
      });
      for(std::size_t i = 0; i < size; ++i)
        if((points[i] - q).squaredNorm() < radius * radius)
          expected.push_back(i);
      std::sort(found.begin(), found.end());
      REQUIRE(found == expected);
    }
  }
}

// Places that rows are not filled by, next to each other on a line through the cloud.
std::vector<Vector3> places_on_line(shapes::Random& random)
{
  const Vector3 from = random_vector(random), to = random_vector(random);
  std::vector<Vector3> places;
  for(int k = 0; k < 27; ++k)
    places.push_back(from + k / 27.0 * (to - from));
  return places;
}

TEST_CASE("The nearest point of places in a row")
{
  for(std::size_t size : {1u, 8u, 9u, 500u}) {
    CAPTURE(size, seed);
    const std::vector<Vector3> points = cloud(size);
    const Box_tree tree = tree_of(points);
    shapes::Random random(seed + 2);
    for(int query = 0; query < 20; ++query) {
      const std::vector<Vector3> places = places_on_line(random);
      const std::vector<std::size_t> found = nearest_points<CGAL::Sequential_tag>(
        tree, places.size(), [&](std::size_t k) { return places[k]; });
      REQUIRE(found.size() == places.size());
      for(std::size_t k = 0; k < places.size(); ++k) {
        double expected = std::numeric_limits<double>::infinity();
        for(const Vector3& p : points)
          expected = std::min(expected, (p - places[k]).norm());
        REQUIRE(found[k] < size);
        REQUIRE((points[found[k]] - places[k]).norm() == Approx(expected).epsilon(1e-5));
      }
    }
  }
  CHECK(nearest_points<CGAL::Sequential_tag>(tree_of(cloud(3)), 0, [](std::size_t) {
          return Vector3(0, 0, 0);
        }).empty());
}

TEST_CASE("The neighbourhoods of points are what a look at every point gives")
{
  for(std::size_t size : {1u, 5u, 8u, 40u, 500u}) {
    CAPTURE(size, seed);
    const std::vector<Vector3> points = cloud(size);
    constexpr std::size_t wanted = 11;
    const K_nearest_neighbors found = neighborhoods<CGAL::Sequential_tag>(tree_of(points), wanted);
    for(std::size_t i = 0; i < size; ++i) {
      std::vector<double> expected;
      for(const Vector3& p : points)
        expected.push_back((p - points[i]).norm());
      std::sort(expected.begin(), expected.end());
      REQUIRE(found[i].size() == std::min(wanted, size));
      REQUIRE(std::is_sorted(found[i].begin(), found[i].end()));
      std::set<std::size_t> different;
      for(std::size_t k = 0; k < std::min(wanted, size); ++k) {
        const Neighbor& neighbor = found[i].begin()[k];
        different.insert(neighbor.index);
        REQUIRE(neighbor.squared_distance == (points[neighbor.index] - points[i]).squaredNorm());
        REQUIRE(std::sqrt(neighbor.squared_distance) == Approx(expected[k]).epsilon(1e-5));
      }
      REQUIRE(different.size() == found[i].size());
    }
  }
}

TEST_CASE("The distance to the nearest patch that is seen from inside")
{
  CAPTURE(seed);
  const std::vector<Patch> patches = ellipsoid(1000);
  std::vector<double> confidence(patches.size());
  for(std::size_t i = 0; i < confidence.size(); ++i)
    confidence[i] = static_cast<double>(i % 11) / 10;
  const Box_tree tree = tree_over(patches);
  const Visible_surface visible(patches, confidence, tree);
  const auto expected = [&](const Vector3& q) {
    double nearest = std::numeric_limits<double>::infinity();
    for(std::size_t i = 0; i < patches.size(); ++i) {
      const Vector3 d = patches[i].mean - q;
      if(visibility(d, patches[i].normal, confidence[i]) > 0.5)
        nearest = std::min(nearest, d.norm());
    }
    return nearest;
  };
  shapes::Random random(seed + 5);
  for(int query = 0; query < 20; ++query) {
    const std::vector<Vector3> places = places_on_line(random);
    const std::vector<double> found = visible.distances<CGAL::Sequential_tag>(
      places.size(), [&](std::size_t k) { return places[k]; });
    for(std::size_t k = 0; k < places.size(); ++k)
      REQUIRE(found[k] == Approx(expected(places[k])).epsilon(1e-4));
  }
  const auto inside = [&](std::size_t i) { return Vector3(0.9 * patches[i].mean); };
  const std::vector<double> beside =
    visible.distances_beside_patches<CGAL::Sequential_tag>(inside);
  for(std::size_t i = 0; i < patches.size(); ++i)
    REQUIRE(beside[i] == Approx(expected(inside(i))).epsilon(1e-4));
  // From outside of all, with every patch turned towards the place away from it.
  const std::vector<Patch> one = {patches[0]};
  const Box_tree tree_of_one = tree_over(one);
  CHECK(Visible_surface(one, {1}, tree_of_one)
          .distances<CGAL::Sequential_tag>(
            1, [&](std::size_t) { return Vector3(2 * patches[0].mean); })[0] == 0);
}

TEST_CASE("The winding number is the sum of all dipoles, up to the error of the expansion")
{
  CAPTURE(seed);
  const std::vector<Patch> patches = ellipsoid(3000);
  const Box_tree tree = tree_over(patches);
  const Winding_number winding_number(patches, tree);
  shapes::Random random(seed + 3);
  for(int query = 0; query < 300; ++query) {
    const Vector3 q = 1.5 * random_vector(random);
    const double found = winding_number(q);
    REQUIRE(std::abs(found - sum_of_dipoles(patches, q)) < 0.05);
    const Vector3 beside = q + Vector3(0.1, 0, 0);
    const auto both = winding_number(std::array<Vector3, 2>{{q, beside}});
    REQUIRE(std::abs(both[0] - sum_of_dipoles(patches, q)) < 0.05);
    REQUIRE(std::abs(both[1] - sum_of_dipoles(patches, beside)) < 0.05);
    const auto in_a_row = winding_number.at_places<CGAL::Sequential_tag>(
      9, [&](std::size_t k) { return k % 2 == 0 ? q : beside; });
    for(std::size_t k = 0; k < 9; ++k)
      REQUIRE(std::abs(in_a_row[k] - both[k % 2]) < 0.05);
    const double level = q.cwiseQuotient(Vector3(1, 1, 0.4)).norm(); // 1 on the surface
    if(level < 0.7)
      REQUIRE(found > 0.75);
    if(level > 1.5)
      REQUIRE(found < 0.25);
  }
  CHECK(Winding_number({}, Box_tree())(Vector3::Zero()) == 0);
}

TEST_CASE("The winding number of patches that coincide is finite, and 0 far away")
{
  for(const std::size_t size : {1u, 20u}) {
    CAPTURE(size);
    std::vector<Patch> patches(size);
    for(Patch& patch : patches) {
      patch.mean = Vector3(0.3, 0.2, 0.1);
      patch.spacing = least_spacing;
      patch.area = least_spacing * least_spacing;
      patch.planarity = 1;
    }
    const Box_tree tree = tree_over(patches);
    const Winding_number winding_number(patches, tree);
    CHECK(std::isfinite(winding_number(patches[0].mean)));
    CHECK(std::abs(winding_number(Vector3(0.4, 0.3, 0.2))) < 1e-6);
  }
}

TEST_CASE("The facing ball is the third smallest of those with all patches that face one and count")
{
  CAPTURE(seed);
  const std::vector<Patch> patches = ellipsoid(1000);
  std::vector<double> confidence(patches.size());
  for(std::size_t i = 0; i < confidence.size(); ++i)
    confidence[i] = i % 10 == 0 ? trusted_orientation / 2 : 1;
  const auto found =
    Facing_balls(patches, confidence, tree_over(patches)).radii<CGAL::Sequential_tag>();
  for(std::size_t i = 0; i < patches.size(); ++i) {
    if(confidence[i] < trusted_orientation) {
      REQUIRE(found[i] == 0);
      continue;
    }
    std::vector<double> radii;
    for(std::size_t j = 0; j < patches.size(); ++j)
      if(confidence[j] >= trusted_orientation &&
         patches[j].normal.dot(patches[i].normal) <= facing_normals &&
         patches[i].normal.dot(patches[j].mean - patches[i].mean) < 0)
        radii.push_back(ball_radius(patches[i], patches[j]));
    std::sort(radii.begin(), radii.end());
    REQUIRE(radii.size() > 2);
    REQUIRE(found[i] == Approx(radii[2]).epsilon(1e-4));
  }
  const std::vector<Patch> two = {patches[0], patches[1]};
  CHECK(Facing_balls(two, {1, 1}, tree_over(two)).radii<CGAL::Sequential_tag>()[0] == 0);
}
