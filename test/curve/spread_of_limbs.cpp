// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The radius of a limb whose other side was not seen is the spread of its points.

#include "catch2.h"
#include "generator/Random.h"

#include <CGAL/Point_set_skeletonization_3/internal/core/squared_distance_to_segment.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/spread_of_limbs.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace spread_of_limbs_test {

using namespace CGAL::Point_set_skeletonization_3::internal;

namespace {

constexpr unsigned int seeds[] = {1, 2, 3};
constexpr std::size_t length = 20; // number of vertices of a limb, at distance 1
constexpr std::size_t enough = 12;
constexpr double gap = 3;        // resolutions
constexpr double resolution = 0.1;

struct Limb
{
  Skeleton_graph graph;
  std::vector<std::vector<Vector3>> surface;
};

/// A path along the x axis, and at each vertex some points with a given offset from it.
Limb limb(std::size_t points, shapes::Random& random, const std::function<Vector3()>& offset)
{
  Limb result;
  for(std::size_t v = 0; v < length; ++v) {
    Skeleton_graph::Vertex vertex;
    vertex.position = Vector3(static_cast<double>(v), 0, 0);
    vertex.open = 1;
    vertex.resolution = resolution;
    result.graph.vertices.push_back(vertex);
    if(v > 0)
      result.graph.edges.emplace_back(v - 1, v);
    result.surface.emplace_back();
    const bool is_end = v == 0 || v + 1 == length;
    for(std::size_t i = 0; i < points; ++i)
      result.surface.back().push_back(
        vertex.position + (is_end ? 0 : random.uniform(-0.5, 0.5)) * Vector3::UnitX() + offset());
  }
  return result;
}

/// The least and the largest radius.
std::pair<double, double> radii(Limb limb)
{
  set_spreads(limb.graph, limb.surface, enough, gap);
  double least = limb.graph.vertices.front().radius, most = least;
  for(const Skeleton_graph::Vertex& vertex : limb.graph.vertices) {
    least = (std::min)(least, vertex.radius);
    most = (std::max)(most, vertex.radius);
  }
  return {least, most};
}

} // namespace

TEST_CASE("A limb seen from one side has the radius of its tube, with few points at a vertex too")
{
  for(const unsigned int seed : seeds) {
    CAPTURE(seed);
    shapes::Random random(seed);
    const auto offset = [&] {
      const double angle = random.uniform(0, CGAL_PI);
      return Vector3(0, 0.3 * std::cos(angle), 0.3 * std::sin(angle));
    };
    for(const std::size_t points : {1u, 30u}) {
      CAPTURE(points);
      const auto [least, most] = radii(limb(points, random, offset));
      CHECK(least == Approx(0.3));
      CHECK(most == Approx(0.3));
    }
  }
}

TEST_CASE("The spread of a leaf is in proportion to its width, that of a twig is its deviation")
{
  constexpr std::size_t points = 2000;
  for(const unsigned int seed : seeds) {
    CAPTURE(seed);
    shapes::Random random(seed);
    const auto leaf = radii(limb(points, random, [&] {
      return Vector3(0, random.uniform(-2, 2), 0);
    }));
    CHECK(leaf.first == Approx(2 * (1 - std::exp(-1.0))).epsilon(0.1));
    CHECK(leaf.second == Approx(leaf.first).epsilon(0.2));
    const auto twig = radii(limb(points, random, [&] {
      return Vector3(0, 0.1 * random.normal(), 0.1 * random.normal());
    }));
    CHECK(twig.first == Approx(0.1 * std::sqrt(2.0)).epsilon(0.1));
    CHECK(twig.second == Approx(0.1 * std::sqrt(2.0)).epsilon(0.1));
  }
}

TEST_CASE("Radii of neighbours are alike though single points are not")
{
  for(const unsigned int seed : seeds) {
    CAPTURE(seed);
    shapes::Random random(seed);
    Limb twig = limb(2, random, [&] {
      return Vector3(0, 0.1 * random.normal(), 0.1 * random.normal());
    });
    twig.surface[length / 2].assign(3, Vector3(10, 50, 0)); // a leaf that has no limb
    const auto [least, most] = radii(twig);
    CHECK(least > 0.05);
    CHECK(most < 0.3);
  }
}

TEST_CASE("What is apart from a limb does not count, however many points it has")
{
  shapes::Random random(seeds[0]);
  Limb tube = limb(1, random, [] { return Vector3(0, 0.3, 0); });
  for(std::size_t v = 0; v < length; v += 2)
    tube.surface[v].assign(10 * enough, tube.graph.vertices[v].position + Vector3(0, 0, 5));
  const auto [least, most] = radii(tube);
  CHECK(least == Approx(0.3));
  CHECK(most == Approx(0.3));
  for(auto& vertex : tube.graph.vertices) // then there is no gap
    vertex.resolution = 5;
  CHECK(radii(tube).first == Approx(5).epsilon(0.02)); // from slanting edges it is less
}

TEST_CASE("Only open limbs have a spread, and only where there are points")
{
  shapes::Random random(seeds[0]);
  Limb tube = limb(3, random, [] { return Vector3(0, 1, 0); });
  constexpr double before = 7;
  for(Skeleton_graph::Vertex& vertex : tube.graph.vertices)
    vertex.radius = before;
  Limb empty = tube, closed = tube;
  for(auto& points : empty.surface)
    points.clear();
  CHECK(radii(empty) == std::make_pair(before, before));
  for(std::size_t v = 0; v < length; v += 2)
    closed.graph.vertices[v].open = 0;
  set_spreads(closed.graph, closed.surface, enough, gap);
  for(std::size_t v = 0; v < length; ++v)
    CHECK(closed.graph.vertices[v].radius == Approx(v % 2 == 0 ? before : 1));
}

TEST_CASE("The distance from a segment is that from its line between its ends")
{
  const Vector3 from(0, 0, 0), to(2, 0, 0);
  CHECK(squared_distance_to_segment(Vector3(1, 3, 0), from, to) == Approx(9));
  CHECK(squared_distance_to_segment(Vector3(-3, 4, 0), from, to) == Approx(25));
  CHECK(squared_distance_to_segment(Vector3(3, 0, 1), from, to) == Approx(2));
  CHECK(squared_distance_to_segment(Vector3(0, 2, 0), from, from) == Approx(4));
}

} // namespace spread_of_limbs_test
