// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The skeleton follows its points: moved, scaled, turned or in another order.

#include "both_methods.h"
#include "catch2.h"
#include "graph_counts.h"
#include "shapes.h"
#include "skeleton_checks.h"

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <random>
#include <vector>

namespace equivariance_test {

using Kernel = CGAL::Simple_cartesian<double>;
using Skeleton = CGAL::Curve_skeleton_3<Kernel>;
using shapes::Vector;
using Points = std::vector<Vector>;

namespace {

constexpr double radius = 0.1;

// A branching shape, a loop and a part of its own.
shapes::Shape shape()
{
  shapes::Shape result = shapes::y_junction(radius);
  for(shapes::Capsule c : shapes::ring(radius)) {
    c.a += Vector(0.3, 0.2, 1.5);
    c.b += Vector(0.3, 0.2, 1.5);
    result.push_back(c);
  }
  return result;
}

Points cloud() { return shapes::sample(shape(), 8000, 17); }

Skeleton skeleton_of(const Points& points, bool published)
{
  Skeleton skeleton;
  REQUIRE(extract(published, shapes::to_points<Kernel>(points), skeleton));
  check_valid(skeleton, points.size());
  return skeleton;
}

template <typename Map>
Points image(const Points& points, const Map& map)
{
  Points result;
  for(const Vector& p : points)
    result.push_back(map(p));
  return result;
}

// `b` is `a` under `map`: the same vertices in any order, radii, edges and points of every vertex.
template <typename Map>
void check_follows(const Skeleton& a, const Skeleton& b, const Map& map, double scale,
                   double tolerance)
{
  REQUIRE(num_vertices(a) == num_vertices(b));
  REQUIRE(num_edges(a) == num_edges(b));
  std::vector<std::size_t> match(num_vertices(a));
  double worst = 0;
  for(const auto v : boost::make_iterator_range(vertices(a))) {
    const Vector expected = map(shapes::to_vector(a[v].point));
    const auto distance = [&](std::size_t w) {
      return (shapes::to_vector(b[w].point) - expected).norm() +
             std::abs(b[w].radius - scale * a[v].radius);
    };
    for(const auto w : boost::make_iterator_range(vertices(b)))
      if(distance(w) < distance(match[v]))
        match[v] = w;
    worst = std::max(worst, distance(match[v]));
    CHECK(a[v].indices == b[match[v]].indices);
  }
  CHECK(worst <= scale * tolerance);
  std::size_t lost = 0;
  for(const auto e : boost::make_iterator_range(edges(a)))
    lost += !edge(match[source(e, a)], match[target(e, a)], b).second;
  CHECK(lost == 0);
}

double distance_to_curve(const Skeleton& skeleton, const Vector& p)
{
  double nearest = (shapes::to_vector(skeleton[0].point) - p).norm();
  for(const auto e : boost::make_iterator_range(edges(skeleton))) {
    const shapes::Capsule segment{shapes::to_vector(skeleton[source(e, skeleton)].point),
                                  shapes::to_vector(skeleton[target(e, skeleton)].point), 0};
    nearest = std::min(nearest, segment.distance_to_axis(p));
  }
  return nearest;
}

} // namespace

TEST_CASE("A permutation of the points changes the indices only")
{
  const Points points = cloud();
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), std::mt19937(18));
  Points shuffled;
  for(std::size_t i : order)
    shuffled.push_back(points[i]);

  for(bool published : {false, true}) {
    CAPTURE(published);
    Skeleton after = skeleton_of(shuffled, published);
    for(const auto v : boost::make_iterator_range(vertices(after))) {
      for(auto& i : after[v].indices)
        i = order[i];
      std::sort(after[v].indices.begin(), after[v].indices.end());
    }
    check_follows(skeleton_of(points, published), after, [](const Vector& p) { return p; }, 1,
                  1e-6);
  }
}

TEST_CASE("Scaling the points by a power of ten scales the skeleton")
{
  const Points points = cloud();
  for(bool published : {false, true}) {
    const Skeleton before = skeleton_of(points, published);
    for(double scale : {1e-6, 1e6}) {
      CAPTURE(published, scale);
      const auto map = [&](const Vector& p) { return Vector(scale * p); };
      check_follows(before, skeleton_of(image(points, map), published), map, scale, 1e-6);
    }
  }
}

TEST_CASE("Scaling the smallest feature with the points scales the skeleton")
{
  const Points points = shapes::sample(shape(), 60000, 20);
  const auto skeleton = [](const Points& cloud, double feature) {
    Skeleton result;
    REQUIRE(CGAL::extract_l1_medial_skeleton(shapes::to_points<Kernel>(cloud), result,
                                             CGAL::parameters::smallest_feature(feature)));
    check_valid(result, cloud.size());
    return result;
  };
  const double feature = 1.3 * radius;
  const Skeleton before = skeleton(points, feature);
  CHECK_FALSE(have_same_bits(before, skeleton_of(points, false)));
  for(double scale : {1e-3, 1e3}) {
    CAPTURE(scale);
    const auto map = [&](const Vector& p) { return Vector(scale * p); };
    check_follows(before, skeleton(image(points, map), scale * feature), map, scale, 1e-6);
  }
}

TEST_CASE("Moving the points moves the skeleton, also by ten million diagonals")
{
  // Coordinates are rounded to what they are at the far place, so that both are the same points.
  const Vector far(3e7, -2e7, 1e7);
  const auto there = [&](const Vector& p) { return Vector(p + far); };
  const Points points = image(cloud(), [&](const Vector& p) { return Vector((p + far) - far); });
  for(bool published : {false, true}) {
    CAPTURE(published);
    check_follows(skeleton_of(points, published), skeleton_of(image(points, there), published),
                  there, 1, 1e-6);
  }
}

TEST_CASE("Turning the points keeps the topology and turns the curve")
{
  const Points points = cloud();
  const Skeleton before = skeleton_of(points, false);
  const Graph_counts expected = count_graph(before);
  std::mt19937 generator(19);
  for(int trial = 0; trial < 4; ++trial) {
    const Vector axis = shapes::random_direction(generator);
    const double angle = 0.5 + 1.3 * trial;
    CAPTURE(axis.transpose(), angle);
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, axis).toRotationMatrix();
    const Skeleton after =
      skeleton_of(image(points, [&](const Vector& p) { return Vector(turn * p); }), false);
    const Graph_counts counts = count_graph(after);
    CHECK(counts.components == expected.components);
    CHECK(counts.cycles == expected.cycles);
    CHECK(counts.ends == expected.ends);
    CHECK(counts.junctions == expected.junctions);

    std::vector<double> distances;
    for(const auto v : boost::make_iterator_range(vertices(after)))
      distances.push_back(
        distance_to_curve(before, turn.transpose() * shapes::to_vector(after[v].point)));
    std::sort(distances.begin(), distances.end());
    CHECK(distances[distances.size() / 2] < 0.15 * radius);
    CHECK(distances.back() < 0.75 * radius);
  }
}

} // namespace equivariance_test
