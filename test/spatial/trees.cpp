// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What is asked through a tree of boxes is what a look at every point gives.

#include "catch2.h"
#include "generator/Random.h"
#include "threads.h"

#include <CGAL/Point_set_skeletonization_3/internal/spatial/Box_tree.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/K_nearest_neighbors.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/nearest_points.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <vector>

namespace trees_test {

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

// Places that packets are not filled by, next to each other on a line through the cloud.
std::vector<Vector3> places_on_line(shapes::Random& random)
{
  const Vector3 from = random_vector(random), to = random_vector(random);
  std::vector<Vector3> places;
  for(int k = 0; k < 27; ++k)
    places.push_back(from + k / 27.0 * (to - from));
  return places;
}

void check_same(const K_nearest_neighbors& a, const K_nearest_neighbors& b)
{
  REQUIRE(a.size() == b.size());
  REQUIRE(a.k() == b.k());
  for(std::size_t i = 0; i < a.size(); ++i)
    for(std::size_t k = 0; k < a.k(); ++k) {
      const Neighbor &n = a[i].begin()[k], &m = b[i].begin()[k];
      REQUIRE((n.index == m.index && n.squared_distance == m.squared_distance));
    }
}

} // namespace

TEST_CASE("A tree holds every point once, in leaves inside the boxes above them")
{
  for(const std::size_t size : {0u, 1u, 8u, 9u, 500u, 5000u}) {
    CAPTURE(size, seed);
    const std::vector<Vector3> points = cloud(size);
    const Box_tree tree(points, Concurrency::parallel);
    std::vector<std::size_t> order = tree.order();
    for(std::size_t k = 0; k < size; ++k)
      REQUIRE(tree.positions()[k] == points[order[k]]);
    std::sort(order.begin(), order.end());
    for(std::size_t i = 0; i < size; ++i)
      REQUIRE(order[i] == i);
    CHECK(tree.by_index(tree.positions()) == points);
    for(std::size_t n = 0; n < tree.nodes().size(); ++n) {
      const Box_tree::Node& node = tree.nodes()[n];
      for(std::size_t k = node.begin; k < node.end; ++k)
        REQUIRE(tree.boxes()[n].contains(tree.positions()[k]));
      if(tree.is_leaf(n)) {
        REQUIRE(node.end - node.begin <= Box_tree::leaf_size);
        continue;
      }
      REQUIRE(tree.nodes()[tree.left(n)].begin == node.begin);
      REQUIRE(tree.nodes()[tree.left(n)].end == tree.nodes()[tree.right(n)].begin);
      REQUIRE(tree.nodes()[tree.right(n)].end == node.end);
    }
  }
}

TEST_CASE("The points closer than a radius, each once")
{
  for(std::size_t size : {0u, 1u, 8u, 9u, 500u}) {
    CAPTURE(size, seed);
    const std::vector<Vector3> points = cloud(size);
    const Box_tree tree(points);
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
      REQUIRE(tree.has_any_within(q, radius) == !expected.empty());
    }
  }
}

TEST_CASE("The nearest point of places next to each other")
{
  for(std::size_t size : {1u, 8u, 9u, 500u}) {
    CAPTURE(size, seed);
    const std::vector<Vector3> points = cloud(size);
    const Box_tree tree(points);
    shapes::Random random(seed + 2);
    for(int query = 0; query < 20; ++query) {
      const std::vector<Vector3> places = places_on_line(random);
      const std::vector<std::size_t> found =
        nearest_points(tree, places, Concurrency::sequential);
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
  CHECK(nearest_points(Box_tree(cloud(3)), {}, Concurrency::sequential).empty());
}

TEST_CASE("The nearest neighbours of points are what a look at every point gives")
{
  for(std::size_t size : {1u, 5u, 8u, 40u, 500u}) {
    CAPTURE(size, seed);
    const std::vector<Vector3> points = cloud(size);
    constexpr std::size_t wanted = 11;
    const K_nearest_neighbors found =
      k_nearest_neighbors(Box_tree(points), wanted, Concurrency::sequential);
    REQUIRE(found.size() == size);
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

// Points that are dropped take their places in the neighbourhoods of the others with them.
TEST_CASE("The neighbours of the points that are left are those asked anew")
{
  for(const unsigned int drop : {0u, 1u, 2u}) {
    CAPTURE(drop);
    shapes::Random random(drop);
    std::vector<Vector3> all(500), left;
    for(Vector3& p : all)
      p = random.direction();
    std::vector<std::size_t> index_of(all.size(), all.size());
    for(std::size_t i = all.size(); i-- > 0;) // backwards: another order
      if(i % 100 != drop) {
        index_of[i] = left.size();
        left.push_back(all[i]);
      }
    const Box_tree tree_of_all(all), tree_of_left(left);
    const K_nearest_neighbors before =
      k_nearest_neighbors(tree_of_all, 7, Concurrency::sequential);
    check_same(renumbered(before, index_of, tree_of_left, Concurrency::sequential),
               k_nearest_neighbors(tree_of_left, 7, Concurrency::sequential));
  }
}

TEST_CASE("Any number of threads builds the same tree and finds the same neighbours")
{
  const std::vector<Vector3> points = cloud(20000);
  const Box_tree expected(points);
  const K_nearest_neighbors neighbors = k_nearest_neighbors(expected, 11, Concurrency::sequential);
  const std::vector<std::size_t> nearest =
    nearest_points(expected, points, Concurrency::sequential);
  for_threads([&](Concurrency concurrency) {
    const Box_tree tree(points, concurrency);
    CHECK(tree.order() == expected.order());
    CHECK(tree.positions() == expected.positions());
    check_same(k_nearest_neighbors(tree, 11, concurrency), neighbors);
    CHECK(nearest_points(tree, points, concurrency) == nearest);
  });
}

} // namespace trees_test
