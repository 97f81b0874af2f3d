// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Data is never a mistake of the programmer: whatever the points, there is a sensible result.

#include "both_methods.h"
#include "catch2.h"
#include "graph_counts.h"
#include "shapes.h"
#include "skeleton_checks.h"

#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace degenerate_points_test {

using Kernel = CGAL::Simple_cartesian<double>;
using Skeleton = CGAL::Curve_skeleton_3<Kernel>;
using shapes::Vector;
using Points = std::vector<Vector>;

namespace {

Skeleton skeleton_of(const Points& points, bool published)
{
  Skeleton skeleton(1);
  REQUIRE(extract(published, shapes::to_points<Kernel>(points), skeleton));
  check_valid(skeleton, points.size());
  return skeleton;
}

// Every vertex within the bounding box of the points, up to `margin` times their extent.
void check_within_box(const Skeleton& skeleton, const Points& points, double margin)
{
  Vector lower = points.front(), upper = points.front();
  for(const Vector& p : points) {
    lower = lower.cwiseMin(p);
    upper = upper.cwiseMax(p);
  }
  const double slack = margin * (upper / 2 - lower / 2).lpNorm<Eigen::Infinity>();
  for(const auto v : boost::make_iterator_range(vertices(skeleton))) {
    const Vector p = shapes::to_vector(skeleton[v].point);
    CHECK((p.array() >= lower.array() - slack).all());
    CHECK((p.array() <= upper.array() + slack).all());
  }
}

// The published repulsion moves a sample by up to mu = 0.35 times its distance from the others, so
// that an extent of 1 can grow to 1 / (1 - 2 mu) but no further.
double margin(bool published) { return published ? 1 / (1 - 2 * 0.35) - 1 : 0.5; }

std::size_t number_of_indices(const Skeleton& skeleton)
{
  std::size_t count = 0;
  for(const auto v : boost::make_iterator_range(vertices(skeleton)))
    count += skeleton[v].indices.size();
  return count;
}

Points scaled(Points points, double scale)
{
  for(Vector& p : points)
    p *= scale;
  return points;
}

Points random_box(std::size_t size, const Vector& extent, unsigned int seed)
{
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-0.5, 0.5);
  Points points;
  for(std::size_t i = 0; i < size; ++i) {
    const double x = uniform(generator), y = uniform(generator), z = uniform(generator);
    points.push_back(extent.cwiseProduct(Vector(x, y, z)));
  }
  return points;
}

} // namespace

TEST_CASE("No point gives an empty skeleton, one point or equal points a single vertex")
{
  for(bool published : {false, true}) {
    CAPTURE(published);
    CHECK(num_vertices(skeleton_of({}, published)) == 0);
    for(std::size_t size : {1u, 2u, 7u, 1000u}) {
      CAPTURE(size);
      const Vector place(3, -4, 5e6);
      const Skeleton skeleton = skeleton_of(Points(size, place), published);
      REQUIRE(num_vertices(skeleton) == 1);
      CHECK(num_edges(skeleton) == 0);
      CHECK((shapes::to_vector(skeleton[0].point) - place).norm() < 1e-6);
      CHECK(skeleton[0].indices.size() == size);
    }
  }
}

TEST_CASE("Two to twenty points give something near them")
{
  for(bool published : {false, true})
    for(std::size_t size = 2; size <= 20; ++size) {
      CAPTURE(published, size);
      const Points points = random_box(size, Vector(1, 1, 1), static_cast<unsigned int>(size));
      const Skeleton skeleton = skeleton_of(points, published);
      CHECK(num_vertices(skeleton) >= 1);
      check_within_box(skeleton, points, margin(published));
    }
}

TEST_CASE("Collinear points stay on their line")
{
  const Vector direction = Vector(1, 2, -2) / 3;
  for(bool published : {false, true})
    for(bool regular : {false, true})
      for(std::size_t size : {3u, 10u, 700u}) {
        CAPTURE(published, regular, size);
        Points points;
        for(const Vector& p : random_box(size, Vector(1, 0, 0), 51))
          points.push_back((regular ? static_cast<double>(points.size()) : p.x()) * direction);
        const Skeleton skeleton = skeleton_of(points, published);
        const Graph_counts counts = count_graph(skeleton);
        CHECK(counts.components == 1);
        if(size == 700 && !published) { // a few points need not make a curve
          CHECK(counts.cycles == 0);
          CHECK(counts.ends == 2);
        }
        const double length = (points.back() - points.front()).norm() + 1;
        for(const auto v : boost::make_iterator_range(vertices(skeleton)))
          CHECK(shapes::to_vector(skeleton[v].point).cross(direction).norm() < 1e-6 * length);
        check_within_box(skeleton, points, margin(published));
      }
}

TEST_CASE("Coplanar points stay in their plane")
{
  Points grid;
  for(int i = 0; i < 30; ++i)
    for(int j = 0; j < 30; ++j)
      grid.emplace_back(i, j, 0);
  for(bool published : {false, true})
    for(const Points& points : {random_box(2000, Vector(1, 1, 0), 53), grid}) {
      CAPTURE(published, points.size());
      const Skeleton skeleton = skeleton_of(points, published);
      REQUIRE(num_vertices(skeleton) >= 1);
      for(const auto v : boost::make_iterator_range(vertices(skeleton)))
        CHECK(std::abs(skeleton[v].point.z()) < 0.01);
      check_within_box(skeleton, points, 0.1);
    }
}

TEST_CASE("Points that fill a box instead of covering a surface")
{
  for(bool published : {false, true}) {
    CAPTURE(published);
    const Points points = random_box(3000, Vector(1, 1, 1), 57);
    const Skeleton skeleton = skeleton_of(points, published);
    CHECK(num_vertices(skeleton) >= 1);
    check_within_box(skeleton, points, margin(published));
  }
}

TEST_CASE("Duplicates share the vertex of the point they repeat")
{
  const Points once = shapes::sample(shapes::cylinder(), 1500, 59);
  Points thrice;
  for(int repetition = 0; repetition < 3; ++repetition)
    thrice.insert(thrice.end(), once.begin(), once.end());
  for(bool published : {false, true}) {
    CAPTURE(published);
    const Skeleton skeleton = skeleton_of(thrice, published);
    CHECK(number_of_indices(skeleton) == thrice.size());
    std::vector<std::size_t> vertex(thrice.size());
    for(const auto v : boost::make_iterator_range(vertices(skeleton)))
      for(std::size_t i : skeleton[v].indices)
        vertex[i] = v;
    std::size_t apart = 0;
    for(std::size_t i = 0; i < once.size(); ++i)
      apart += vertex[i] != vertex[i + once.size()] || vertex[i] != vertex[i + 2 * once.size()];
    CHECK(apart == 0);
    check_within_box(skeleton, once, 0);
  }
}

TEST_CASE("A far outlier leaves a result")
{
  for(bool published : {false, true})
    for(double distance : {10.0, 1e4, 1e12, 1e200}) {
      CAPTURE(published, distance);
      Points points = shapes::sample(shapes::cylinder(), 1500, 61);
      points.emplace_back(distance, 0, 0);
      CHECK(num_vertices(skeleton_of(points, published)) >= 1);
    }
}

TEST_CASE("A coordinate that is not finite is refused by the index of its point")
{
  const double infinity = std::numeric_limits<double>::infinity();
  const double not_a_number = std::numeric_limits<double>::quiet_NaN();
  for(bool published : {false, true})
    for(double bad : {not_a_number, infinity, -infinity})
      for(std::size_t index : {0u, 123u, 499u})
        for(int axis = 0; axis < 3; ++axis) {
          CAPTURE(published, bad, index, axis);
          Points points = random_box(500, Vector(1, 1, 1), 67);
          points[index][axis] = bad;
          Skeleton skeleton(5);
          std::string message;
          try {
            extract(published, shapes::to_points<Kernel>(points), skeleton);
          }
          catch(const std::invalid_argument& error) {
            message = error.what();
          }
          CHECK(message.find("point " + std::to_string(index) + " ") != std::string::npos);
          CHECK(num_vertices(skeleton) == 5); // untouched
        }
}

TEST_CASE("Huge and tiny coordinates")
{
  const Points points = shapes::sample(shapes::cylinder(), 1500, 71);
  for(bool published : {false, true}) {
    const Graph_counts expected = count_graph(skeleton_of(points, published));
    for(double scale : {1e300, 1e-300}) {
      CAPTURE(published, scale);
      const Skeleton skeleton = skeleton_of(scaled(points, scale), published);
      const Graph_counts counts = count_graph(skeleton);
      CHECK(counts.components == expected.components);
      CHECK(counts.cycles == expected.cycles);
      CHECK(counts.ends == expected.ends);
      check_within_box(skeleton, scaled(points, scale), 0);
    }
  }
}

TEST_CASE("The largest box and boxes of denormal extent")
{
  const double largest = std::numeric_limits<double>::max();
  const double smallest = std::numeric_limits<double>::denorm_min();
  const Points points = shapes::sample(shapes::cylinder(), 500, 73);
  for(bool published : {false, true}) {
    for(double extent : {1e-305, 1e-315, 100 * smallest, 3 * smallest, smallest}) {
      CAPTURE(published, extent);
      CHECK(num_vertices(skeleton_of(scaled(points, extent), published)) >= 1);
    }
    Points corners = scaled(points, largest);
    corners.emplace_back(largest, largest, largest);
    corners.emplace_back(-largest, -largest, -largest);
    CHECK(num_vertices(skeleton_of(corners, published)) >= 1);
  }
}

} // namespace degenerate_points_test
