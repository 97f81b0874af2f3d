// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// A limb goes on behind a gap in the data; two limbs side by side are not joined unless asked for.
// See also curve/gaps.cpp.

#include "catch2.h"
#include "generator/Random.h"
#include "graph_counts.h"
#include "shapes.h"

#include <CGAL/extract_l1_medial_skeleton.h>

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace bridging_test {

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using shapes::Vector;

constexpr unsigned int seeds[] = {1, 2, 3};

Graph_counts counts_of(const std::vector<Vector>& points, bool single_component = false)
{
  CGAL::Curve_skeleton_3<Kernel> skeleton;
  REQUIRE(CGAL::extract_l1_medial_skeleton(
      shapes::to_points<Kernel>(points), skeleton,
      CGAL::parameters::single_component(single_component)));
  return count_graph(skeleton);
}

// Points of a shape without those whose x is within `half_width` of 0.
std::vector<Vector> with_gap(const shapes::Shape& shape, double half_width, unsigned int seed)
{
  std::vector<Vector> points = shapes::sample(shape, 10000, seed);
  points.erase(std::remove_if(points.begin(), points.end(),
                              [&](const Vector& p) { return std::abs(p.x()) < half_width; }),
               points.end());
  return points;
}

} // namespace

TEST_CASE("A limb goes on behind a gap as long as it is thick")
{
  for(const unsigned int seed : seeds) {
    CAPTURE(seed);
    const Graph_counts counts = counts_of(with_gap(shapes::cylinder(), 0.1, seed));
    CHECK(counts.components == 1);
    CHECK(counts.cycles == 0);
    CHECK(counts.ends == 2);
  }
}

TEST_CASE("Half of a trunk, seen from one side, goes on behind a gap as long as it is thick")
{
  // In two parts while its radius at a tip was that of the nearest patch.
  constexpr double radius = 0.05;
  for(const unsigned int seed : seeds) {
    CAPTURE(seed);
    shapes::Random random(seed);
    std::vector<Vector> points;
    for(int i = 0; i < 8000; ++i) {
      const double z = random.uniform(0, 1);
      const double angle = random.uniform(-shapes::pi / 2, shapes::pi / 2);
      if(std::abs(z - 0.5) > radius)
        points.push_back(Vector(radius * std::cos(angle), radius * std::sin(angle), z));
    }
    const Graph_counts counts = counts_of(points);
    CHECK(counts.components == 1);
    CHECK(counts.cycles == 0);
    CHECK(counts.ends == 2);
  }
}

TEST_CASE("A strip of a limb belongs to it though its sides were not seen and it hangs at the tip")
{
  // Three limbs, each with two slits along it; where it begins, a piece of one strip is missing
  // too. That strip was a limb that leads back.
  constexpr double radius = 0.1;
  const double slit = GENERATE(0.5, 0.8, 1.0);
  for(const unsigned int seed : seeds) {
    CAPTURE(slit, seed);
    shapes::Random random(seed);
    const auto direction = [](int limb) {
      const double angle = limb * 2 * shapes::pi / 3;
      return Vector(std::cos(angle), std::sin(angle), 0);
    };
    const auto is_in_limb = [&](const Vector& p, int limb) {
      const double along = (std::max)(0.0, direction(limb).dot(p));
      return (p - along * direction(limb)).norm() < 0.999 * radius;
    };
    std::vector<Vector> points;
    for(int limb = 0; limb < 3; ++limb) {
      const Vector axis = direction(limb), side = axis.cross(Vector::UnitZ());
      for(int i = 0; i < 3000; ++i) {
        const double along = random.uniform(0, 1);
        const double angle = random.uniform(-shapes::pi, shapes::pi);
        const bool is_in_front = std::abs(angle) < shapes::pi / 2;
        const Vector p =
          along * axis + radius * (std::cos(angle) * Vector::UnitZ() + std::sin(angle) * side);
        if(std::abs(std::abs(angle) - shapes::pi / 2) > slit / 2 &&
           !(is_in_front && std::abs(along - 0.35) < 0.06) && !is_in_limb(p, (limb + 1) % 3) &&
           !is_in_limb(p, (limb + 2) % 3))
          points.push_back(p);
      }
      for(int i = 0; i < 300; ++i) {
        const Vector beyond = random.direction();
        if(beyond.dot(axis) > 0)
          points.push_back(axis + radius * beyond);
      }
    }
    const Graph_counts counts = counts_of(points);
    CHECK(counts.components == 1);
    CHECK(counts.cycles == 0);
    CHECK(counts.ends == 3);
  }
}

TEST_CASE("A bridge makes no loop: a ring with a gap in it stays open")
{
  for(const unsigned int seed : seeds) {
    CAPTURE(seed);
    std::vector<Vector> points = shapes::sample(shapes::ring(), 10000, seed);
    const auto is_in_gap = [](const Vector& p) { return std::abs(p.x()) < 0.15 && p.y() > 0; };
    points.erase(std::remove_if(points.begin(), points.end(), is_in_gap), points.end());
    const Graph_counts counts = counts_of(points);
    CHECK(counts.components == 1);
    CHECK(counts.cycles == 0);
    CHECK(counts.ends == 2);
  }
}

TEST_CASE("A gap many times as long as the limb is thick is one between two parts")
{
  for(const unsigned int seed : seeds) {
    CAPTURE(seed);
    CHECK(counts_of(with_gap(shapes::cylinder(0.03), 0.2, seed)).components == 2);
  }
}

TEST_CASE("Parts side by side are joined only if a single component is asked for")
{
  for(const unsigned int seed : seeds) {
    CAPTURE(seed);
    const std::vector<Vector> points = shapes::sample(shapes::two_parts(), 10000, seed);
    CHECK(counts_of(points).components == 2);
    const Graph_counts single = counts_of(points, true);
    CHECK(single.components == 1);
    CHECK(single.cycles == 0);
  }
}

TEST_CASE("Wires behind something are continued: in a frame they close loops")
{
  // Two squares side by side, of lines of points; of each line a piece is missing.
  constexpr double spacing = 0.005, missing = 0.04;
  const double width = GENERATE(0.0, 0.3 * spacing);
  const std::vector<std::pair<Vector, Vector>> lines = {
    {{0, 0, 0}, {2, 0, 0}}, {{0, 1, 0}, {2, 1, 0}}, {{0, 0, 0}, {0, 1, 0}},
    {{1, 0, 0}, {1, 1, 0}}, {{2, 0, 0}, {2, 1, 0}}};
  for(const unsigned int seed : seeds) {
    CAPTURE(seed, width);
    shapes::Random random(seed);
    std::vector<Vector> points;
    for(const auto& [from, to] : lines) {
      const double length = (to - from).norm(), gap = random.uniform(0.2, 0.4);
      for(double at = 0; at <= length; at += spacing)
        if(std::abs(at - gap) > missing)
          points.push_back(from + at * (to - from) / length + width * random.normal_vector());
    }
    const Graph_counts counts = counts_of(points);
    CHECK(counts.components == 1);
    CHECK(counts.cycles == 2);
  }
}

TEST_CASE("A single component of many parts has the cycles of the parts")
{
  // Rings in a row, far apart.
  shapes::Shape shape;
  for(int k = 0; k < 3; ++k)
    for(shapes::Capsule c : shapes::ring()) {
      c.a.z() += 1.5 * k;
      c.b.z() += 1.5 * k;
      shape.push_back(c);
    }
  const std::vector<Vector> points = shapes::sample(shape, 20000, seeds[0]);
  CHECK(counts_of(points).components == 3);
  const Graph_counts single = counts_of(points, true);
  CHECK(single.components == 1);
  CHECK(single.cycles == 3);
}

} // namespace bridging_test
