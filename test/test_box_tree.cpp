// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial

// What is asked through a tree of boxes is what a look at every point gives.

#include "catch2.h"
#include "generator/Random.h"

#include <CGAL/Point_set_skeletonization_3/internal/Box_tree.h>
#include <CGAL/Point_set_skeletonization_3/internal/medial_balls.h>
#include <CGAL/Point_set_skeletonization_3/internal/winding_number.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
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

TEST_CASE("The nearest point by branch and bound")
{
  CAPTURE(seed);
  const std::vector<Vector3> points = cloud(500);
  const Box_tree tree = tree_of(points);
  shapes::Random random(seed + 2);
  for(int query = 0; query < 50; ++query) {
    const Vector3 q = random_vector(random);
    double nearest = std::numeric_limits<double>::infinity(), expected = nearest;
    std::size_t visits = 0;
    tree.visit_below(
      nearest, [&](std::size_t node) { return tree.boxes()[node].squared_distance(q); },
      [&](std::size_t k) {
        ++visits;
        nearest = std::min(nearest, (points[tree.order()[k]] - q).squaredNorm());
      });
    for(const Vector3& p : points)
      expected = std::min(expected, (p - q).squaredNorm());
    REQUIRE(nearest == expected);
    REQUIRE(visits < points.size() / 2);
  }
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
  for(const std::size_t size : {1, 20}) {
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
    REQUIRE(found[i] == Approx(radii[2]).epsilon(1e-12));
  }
  const std::vector<Patch> two = {patches[0], patches[1]};
  CHECK(Facing_balls(two, {1, 1}, tree_over(two)).radii<CGAL::Sequential_tag>()[0] == 0);
}
