// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Shapes whose curve skeleton is known, sampled at random.

#include "both_methods.h"
#include "catch2.h"
#include "graph_counts.h"
#include "shapes.h"
#include "skeleton_checks.h"

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

namespace known_shapes_test {

using Kernel = CGAL::Simple_cartesian<double>;
using Skeleton = CGAL::Curve_skeleton_3<Kernel>;
using shapes::Vector;

namespace {

constexpr unsigned int seeds[] = {1, 2, 3};
constexpr double radii[] = {0.05, 0.1};

Skeleton skeleton_of(const shapes::Shape& shape, std::size_t size, unsigned int seed,
                     bool published = false)
{
  const auto points = shapes::to_points<Kernel>(shapes::sample(shape, size, seed));
  Skeleton skeleton;
  REQUIRE(extract(published, points, skeleton));
  check_valid(skeleton, size);
  return skeleton;
}

// Distances of the vertices to the nearest axis, in radii.
std::vector<double> offsets(const Skeleton& skeleton, const shapes::Shape& shape)
{
  std::vector<double> result;
  for(const auto v : boost::make_iterator_range(vertices(skeleton)))
    result.push_back(shapes::distance_to_axes(shape, shapes::to_vector(skeleton[v].point)) /
                     shape.front().radius);
  return result;
}

double median(std::vector<double> values)
{
  REQUIRE(!values.empty());
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

// The curve stays inside the tubes and, but for the corners that it cuts, close to their axes.
void check_centred(const Skeleton& skeleton, const shapes::Shape& shape)
{
  const std::vector<double> offset = offsets(skeleton, shape);
  CHECK(*std::max_element(offset.begin(), offset.end()) < 1);
  CHECK(median(offset) < 0.1);
}

// Every vertex has a radius that is true at its place, and the radius of the tube in the middle.
void check_radii(const Skeleton& skeleton, const shapes::Shape& shape)
{
  const std::vector<double> offset = offsets(skeleton, shape);
  std::vector<double> ratio;
  for(const auto v : boost::make_iterator_range(vertices(skeleton))) {
    ratio.push_back(skeleton[v].radius / shape.front().radius);
    CAPTURE(v, ratio[v], offset[v]);
    CHECK(std::abs(ratio[v] - (1 - offset[v])) < 0.15);
  }
  CHECK(std::abs(median(ratio) - 1) < 0.15);
}

double distance_to_nearest_end(const Skeleton& skeleton, const Vector& place)
{
  double distance = std::numeric_limits<double>::infinity();
  for(const auto v : boost::make_iterator_range(vertices(skeleton)))
    if(out_degree(v, skeleton) == 1)
      distance = std::min(distance, (shapes::to_vector(skeleton[v].point) - place).norm());
  return distance;
}

std::size_t number_of_indices(const Skeleton& skeleton)
{
  std::size_t count = 0;
  for(const auto v : boost::make_iterator_range(vertices(skeleton)))
    count += skeleton[v].indices.size();
  return count;
}

} // namespace

TEST_CASE("A cylinder is one branch along its axis, from cap to cap")
{
  for(unsigned int seed : seeds)
    for(double radius : radii) {
      CAPTURE(seed, radius);
      const shapes::Shape shape = shapes::cylinder(radius);
      const Skeleton skeleton = skeleton_of(shape, 3000, seed);
      const Graph_counts counts = count_graph(skeleton);
      CHECK(counts.components == 1);
      CHECK(counts.cycles == 0);
      CHECK(counts.ends == 2);
      CHECK(counts.junctions == 0);
      CHECK(std::abs(counts.length - 1) < 2 * radius); // neither zigzag nor shrunken

      check_centred(skeleton, shape);
      check_radii(skeleton, shape);
      for(double offset : offsets(skeleton, shape))
        CHECK(offset < 0.1);
      for(double side : {-1, 1})
        CHECK(distance_to_nearest_end(skeleton, Vector(side * (0.5 + radius), 0, 0)) <
              1.3 * radius);
      CHECK(number_of_indices(skeleton) == 3000);
    }
}

TEST_CASE("The radius is that of the limb, in noise as well")
{
  // The deviation of the noise is 0, a fifth and half of the radius.
  constexpr double radius = 0.1;
  for(const double noise : {0.0, 0.02, 0.05})
    for(const unsigned int seed : seeds) {
      CAPTURE(noise, seed);
      std::vector<Vector> points = shapes::sample(shapes::cylinder(radius), 10000, seed);
      std::mt19937 generator(seed);
      std::normal_distribution<double> normal(0, 1);
      for(Vector& p : points)
        p += noise * Vector(normal(generator), normal(generator), normal(generator));
      Skeleton skeleton;
      REQUIRE(CGAL::extract_l1_medial_skeleton(shapes::to_points<Kernel>(points), skeleton));
      std::vector<double> radii_of_vertices;
      for(const auto v : boost::make_iterator_range(vertices(skeleton)))
        radii_of_vertices.push_back(skeleton[v].radius);
      CHECK(median(radii_of_vertices) > 0.75 * radius);
      CHECK(median(radii_of_vertices) < 1.25 * radius);
    }
}

TEST_CASE("A Y has three ends and one junction")
{
  for(unsigned int seed : seeds)
    for(double radius : radii) {
      CAPTURE(seed, radius);
      const shapes::Shape shape = shapes::y_junction(radius);
      const Skeleton skeleton = skeleton_of(shape, 6000, seed);
      const Graph_counts counts = count_graph(skeleton);
      CHECK(counts.components == 1);
      CHECK(counts.cycles == 0);
      CHECK(counts.ends == 3);
      CHECK(counts.junctions == 1);
      check_centred(skeleton, shape);
      for(const shapes::Capsule& limb : shape)
        CHECK(distance_to_nearest_end(skeleton, limb.b) < radius);
      for(const auto v : boost::make_iterator_range(vertices(skeleton)))
        if(out_degree(v, skeleton) == 3)
          CHECK(shapes::to_vector(skeleton[v].point).norm() < 1.5 * radius);
    }
}

TEST_CASE("A ring is one cycle")
{
  for(unsigned int seed : seeds)
    for(double radius : radii) {
      CAPTURE(seed, radius);
      const shapes::Shape shape = shapes::ring(radius);
      const Skeleton skeleton = skeleton_of(shape, 6000, seed);
      const Graph_counts counts = count_graph(skeleton);
      CHECK(counts.components == 1);
      CHECK(counts.cycles == 1);
      CHECK(counts.ends == 0);
      CHECK(counts.length == Approx(2 * shapes::pi).epsilon(0.05));
      check_centred(skeleton, shape);
    }
}

TEST_CASE("The frame of a cube has five independent cycles")
{
  for(double radius : radii) {
    CAPTURE(radius);
    const shapes::Shape shape = shapes::cube_frame(radius);
    const Skeleton skeleton = skeleton_of(shape, 12000, 1);
    const Graph_counts counts = count_graph(skeleton);
    CHECK(counts.components == 1);
    CHECK(counts.cycles == 5);
    CHECK(counts.ends == 0);
    check_centred(skeleton, shape);
  }
}

TEST_CASE("Two parts stay two parts")
{
  for(unsigned int seed : seeds) {
    CAPTURE(seed);
    const shapes::Shape shape = shapes::two_parts();
    const Skeleton skeleton = skeleton_of(shape, 5000, seed);
    const Graph_counts counts = count_graph(skeleton);
    CHECK(counts.components == 2);
    CHECK(counts.cycles == 0);
    CHECK(counts.ends == 4);
    check_centred(skeleton, shape);
    CHECK(number_of_indices(skeleton) == 5000);
  }
}

TEST_CASE("The published method makes a single tree of everything")
{
  for(const shapes::Shape& shape :
      {shapes::cylinder(), shapes::y_junction(), shapes::ring(), shapes::two_parts()}) {
    CAPTURE(shape.size());
    const Skeleton skeleton = skeleton_of(shape, 3000, 4, true);
    const Graph_counts counts = count_graph(skeleton);
    CHECK(counts.components == 1);
    CHECK(counts.cycles == 0);
    CHECK(counts.ends >= 2);
    CHECK(number_of_indices(skeleton) == 3000);
  }
}

} // namespace known_shapes_test
