// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What makes a loop: a hole of the shape, not limbs that nearly touch.

#include "catch2.h"
#include "generator/Random.h"
#include "graph_counts.h"
#include "shapes.h"

#include <CGAL/Point_set_skeletonization_3/internal/curve/Skeleton_graph.h>
#include <CGAL/Point_set_skeletonization_3/internal/pipeline/link_samples.h>
#include <CGAL/extract_l1_medial_skeleton.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/iterator.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace loops_test {

using shapes::Vector;

namespace {

constexpr unsigned int seeds[] = {1, 2, 3};

Vector around(double angle)
{
  return Vector(std::cos(angle), std::sin(angle), 0);
}

using Kernel = CGAL::Simple_cartesian<double>;
using Skeleton = CGAL::Curve_skeleton_3<Kernel>;

Skeleton skeleton_of(const std::vector<Vector>& points)
{
  Skeleton skeleton;
  REQUIRE(CGAL::extract_l1_medial_skeleton(shapes::to_points<Kernel>(points), skeleton));
  return skeleton;
}

Graph_counts counts_of(const std::vector<Vector>& points)
{
  return count_graph(skeleton_of(points));
}

using CGAL::Point_set_skeletonization_3::internal::Skeleton_graph;

/// A chain of 20 edges of length 1, closed or not, that was seen from one side, and one of `tail`
/// edges that begins at its second vertex, `open` in [0, 1].
Skeleton_graph ring_with_tail(std::size_t tail, double open, bool is_closed)
{
  constexpr std::size_t size = 20;
  const double radius = 0.5 / std::sin(shapes::pi / size);
  Skeleton_graph result;
  for(std::size_t v = 0; v <= size; ++v) {
    result.vertices.emplace_back();
    result.vertices.back().position =
      radius * around(2 * shapes::pi * static_cast<double>(v) / size);
    result.vertices.back().open = 1;
    if(v > 0)
      result.edges.emplace_back(v - 1, v);
  }
  if(is_closed)
    result.edges.emplace_back(size, 0);
  for(std::size_t k = 0; k < tail; ++k) {
    result.edges.emplace_back(k == 0 ? 1 : result.vertices.size() - 1, result.vertices.size());
    result.vertices.emplace_back();
    result.vertices.back().position =
      result.vertices[1].position + static_cast<double>(k + 1) * Vector::UnitZ();
    result.vertices.back().open = open;
  }
  return result;
}

} // namespace

TEST_CASE("Turns of a spring that nearly touch make no loops")
{
  constexpr double r = 0.1, coil = 0.5, pitch = 2.7 * r, turns = 3;
  constexpr int sides = 24; // of a turn
  const auto at = [&](int i) {
    const double turn = static_cast<double>(i) / sides;
    return Vector(coil * around(2 * shapes::pi * turn) + pitch * turn * Vector::UnitZ());
  };
  shapes::Shape spring;
  for(int i = 0; i < turns * sides; ++i)
    spring.push_back({at(i), at(i + 1), r});
  for(const unsigned int seed : seeds) {
    CAPTURE(seed);
    const Graph_counts counts = counts_of(shapes::sample(spring, 20000, seed));
    CHECK(counts.components == 1);
    CHECK(counts.cycles == 0);
    CHECK(counts.ends == 2);
  }
}

TEST_CASE("A pipe is a loop around its middle, however wide its wall is")
{
  // Cut lengthwise, the wall is 13 times as wide as thick.
  const double outer = 1, inner = 0.7, length = 4;
  for(const unsigned int seed : seeds) {
    CAPTURE(seed);
    shapes::Random random(seed);
    std::vector<Vector> points;
    const double rim = outer * outer - inner * inner, outside = outer * length,
                 inside = inner * length; // areas over 2 pi
    while(points.size() < 20000) {
      const double choice = random.uniform() * (rim + outside + inside);
      const double u = random.uniform(), v = random.uniform();
      double radius = choice < rim + outside ? outer : inner, z = length * v;
      if(choice < rim) {
        radius = std::sqrt(inner * inner + v * rim);
        z = choice < rim / 2 ? 0 : length;
      }
      points.push_back(radius * around(2 * shapes::pi * u) + z * Vector::UnitZ());
    }
    const Skeleton skeleton = skeleton_of(points);
    const Graph_counts counts = count_graph(skeleton);
    CHECK(counts.components == 1);
    CHECK(counts.cycles == 1);
    CHECK(counts.ends == 0);
    for(const auto v : CGAL::make_range(vertices(skeleton))) {
      const auto& p = skeleton[v].point;
      const double radius = std::hypot(p.x(), p.y());
      CHECK(inner < radius);
      CHECK(radius < outer);
      CHECK(std::abs(p.z() - length / 2) < outer - inner);
    }
  }
}

TEST_CASE("A screw hole in a plate is a loop")
{
  // A plate of 4 x 2 x 0.4 with a hole of radius 0.25.
  const double length = 4, width = 2, height = 0.4, radius = 0.25;
  const Vector hole(1, 1, 0);
  for(const unsigned int seed : seeds) {
    CAPTURE(seed);
    shapes::Random random(seed);
    std::vector<Vector> points;
    const double faces = length * width, sides = length * height, ends = width * height;
    const double wall = 2 * shapes::pi * radius * height;
    while(points.size() < 10000) {
      const double choice = random.uniform() * (2 * (faces + sides + ends) + wall);
      const double u = random.uniform(), v = random.uniform();
      const double side = std::floor(2 * random.uniform());
      Vector p;
      if(choice < 2 * faces)
        p = Vector(length * u, width * v, height * side);
      else if(choice < 2 * (faces + sides))
        p = Vector(length * u, width * side, height * v);
      else if(choice < 2 * (faces + sides + ends))
        p = Vector(length * side, width * u, height * v);
      else
        p = hole + radius * around(2 * shapes::pi * u) + height * v * Vector::UnitZ();
      if((p - hole).head<2>().norm() > 0.999 * radius)
        points.push_back(p);
    }
    const Graph_counts counts = counts_of(points);
    CHECK(counts.components == 1);
    CHECK(counts.cycles == 1);
  }
}

TEST_CASE("Thin limbs that cross make loops in a frame, not in a tree")
{
  // Lines of points: nothing local tells a joint from a contact. What ends freely is a tree.
  constexpr double spacing = 0.01;
  using Line = std::pair<Vector, Vector>;
  const auto scattered = [&](const std::vector<Line>& lines, double width, unsigned int seed) {
    shapes::Random random(seed);
    std::vector<Vector> points;
    for(const Line& line : lines) {
      const Vector way = line.second - line.first;
      for(double at = 0; at <= way.norm(); at += spacing)
        points.push_back(line.first + at * way.normalized() + width * random.normal_vector());
    }
    return points;
  };
  const double width = GENERATE(0.0, 0.3 * spacing);
  std::vector<Line> frame;
  for(const double at : {0.0, 0.5, 1.0}) {
    frame.push_back({Vector(at, 0, 0), Vector(at, 1, 0)});
    frame.push_back({Vector(0, at, 0), Vector(1, at, 0)});
  }
  const std::vector<Line> tree = {{Vector(0, 0, 0), Vector(0, 1, 0)},
                                  {Vector(0, 0.2, 0), Vector(0.8, 1, 0)},
                                  {Vector(0, 0.8, 0), Vector(0.8, 0.4, 0)}, // touches the former
                                  {Vector(0, 0.5, 0), Vector(-0.5, 0.8, 0)},
                                  {Vector(0, 0.6, 0), Vector(0, 0.8, 0.5)},
                                  {Vector(0, 0.4, 0), Vector(0, 0.6, -0.5)}};
  for(const unsigned int seed : seeds) {
    CAPTURE(seed, width);
    const Graph_counts counts = counts_of(scattered(frame, width, seed));
    CHECK(counts.components == 1);
    CHECK(counts.cycles == 4);
    CHECK(counts.ends == 0);
    const Graph_counts tree_counts = counts_of(scattered(tree, width, seed));
    CHECK(tree_counts.components == 1);
    CHECK(tree_counts.cycles == 0);
  }
}

TEST_CASE("A lattice of wires has its loops, though few patches lead from joint to joint")
{
  // None were found while evidence reached beyond the next joint.
  constexpr int wires = 5, points_of_edge = 36;
  constexpr std::size_t loops = 3 * wires * wires * (wires - 1) - wires * wires * wires + 1;
  for(const unsigned int seed : seeds) {
    CAPTURE(seed);
    shapes::Random random(seed);
    std::vector<Vector> points;
    for(int axis = 0; axis < 3; ++axis)
      for(int i = 0; i < wires; ++i)
        for(int j = 0; j < wires; ++j)
          for(int k = 0; k < (wires - 1) * points_of_edge; ++k) {
            Vector p;
            p[axis] = (k + random.uniform()) / points_of_edge;
            p[(axis + 1) % 3] = i;
            p[(axis + 2) % 3] = j;
            points.push_back(p + 0.01 * random.normal_vector());
          }
    const Graph_counts counts = counts_of(points);
    CHECK(counts.components == 1);
    CHECK(counts.cycles <= loops);
    CHECK(100 * counts.cycles >= 97 * loops);
  }
}

TEST_CASE("A net of wires has its loops, though the wires look like the rows of a scanner")
{
  // None were found while wider cells, which a net fills, were asked.
  constexpr int meshes = 5, points_of_edge = 36;
  for(const unsigned int seed : seeds) {
    CAPTURE(seed);
    shapes::Random random(seed);
    std::vector<Vector> points;
    for(int wire = 0; wire <= meshes; ++wire)
      for(int k = 0; k < meshes * points_of_edge; ++k) {
        const double place = (k + random.uniform()) / points_of_edge;
        points.push_back(Vector(place, wire, 0) + 0.01 * random.normal_vector());
        points.push_back(Vector(wire, place, 0) + 0.01 * random.normal_vector());
      }
    const Graph_counts counts = counts_of(points);
    CHECK(counts.components == 1);
    CHECK(counts.cycles == meshes * meshes);
  }
}

TEST_CASE("A net of tubes as thin as their spacing is no noise around a plane")
{
  // There was no curve at all while the tubes were taken for noise.
  constexpr int meshes = 4, points_of_edge = 60;
  constexpr double radius = 0.12; // 1.2 spacings
  for(const unsigned int seed : seeds) {
    CAPTURE(seed);
    shapes::Random random(seed);
    std::vector<Vector> points;
    for(int axis = 0; axis < 2; ++axis)
      for(int tube = 0; tube <= meshes; ++tube)
        for(int k = 0; k < meshes * points_of_edge; ++k) {
          const double angle = random.uniform(0, 2 * shapes::pi);
          Vector p(0, 0, radius * std::sin(angle));
          p[axis] = random.uniform(0, meshes);
          p[1 - axis] = tube + radius * std::cos(angle);
          points.push_back(p);
        }
    const Graph_counts counts = counts_of(points);
    CHECK(counts.components == 1);
    CHECK(counts.cycles <= meshes * meshes);
    CHECK(2 * counts.cycles > meshes * meshes); // not all of them yet: 11 to 16
  }
}

TEST_CASE("In a frame, hardly anything that was not seen from all sides is on no loop")
{
  using CGAL::Point_set_skeletonization_3::internal::is_frame;
  const auto frame = [](std::size_t tail, double open) { return ring_with_tail(tail, open, true); };
  const auto tree = [](std::size_t tail, double open) { return ring_with_tail(tail, open, false); };
  const double noise = GENERATE(0, 0.4, 1);
  const CGAL::Point_set_skeletonization_3::internal::Linking_options options;
  CHECK(is_frame(frame(0, 1), tree(0, 1), noise, 1, options));
  CHECK(is_frame(frame(4, 1), tree(4, 1), noise, 1, options));
  CHECK_FALSE(is_frame(frame(5, 1), tree(5, 1), noise, 1, options));
  CHECK(is_frame(frame(100, 0), tree(100, 0), noise, 1, options)); // a limb seen from all sides
  CHECK_FALSE(is_frame(frame(4, 1), tree(40, 1), noise, 1, options)); // the frame left twigs out
  CHECK(is_frame(frame(0, 1), tree(40, 1), noise, 1, options)); // nothing of it is loose
}

TEST_CASE("A frame with no more loops than the tree is kept with noise")
{
  using CGAL::Point_set_skeletonization_3::internal::is_frame;
  const CGAL::Point_set_skeletonization_3::internal::Linking_options options;
  for(const bool is_closed : {false, true}) {
    const Skeleton_graph graph = ring_with_tail(9, 1, is_closed);
    CHECK_FALSE(is_frame(graph, graph, 0, 1, options)); // a third is loose, or all
    CHECK(is_frame(graph, graph, 1, 1, options));
  }
  CHECK_FALSE(is_frame(ring_with_tail(9, 1, true), ring_with_tail(9, 1, false), 1, 1, options));
  CHECK(is_frame(ring_with_tail(9, 1, false), ring_with_tail(9, 1, true), 1, 1, options));
}

TEST_CASE("In a frame of resolved strips, most of what was not seen from all sides is on loops")
{
  using CGAL::Point_set_skeletonization_3::internal::is_frame;
  const CGAL::Point_set_skeletonization_3::internal::Linking_options options;
  const double noise = 0;
  const auto is_frame_of = [&](std::size_t tail, double unresolved, double open) {
    Skeleton_graph frame = ring_with_tail(tail, 1, true), tree = ring_with_tail(tail, 1, false);
    for(Skeleton_graph* graph : {&frame, &tree})
      for(auto& vertex : graph->vertices)
        vertex.open *= open;
    return is_frame(frame, tree, noise, unresolved, options);
  };
  CHECK(is_frame_of(9, 0, 1)); // a third is loose
  CHECK(is_frame_of(9, 0.2, 1));
  CHECK_FALSE(is_frame_of(9, 0.3, 1));
  CHECK_FALSE(is_frame_of(30, 0, 1)); // more than half
  CHECK_FALSE(is_frame_of(9, 0, 0.4)); // most of it was seen from all sides
}

TEST_CASE("A bare circle is a loop")
{
  std::vector<Vector> points;
  constexpr int size = 2000;
  for(int k = 0; k < size; ++k)
    points.push_back(around(2 * shapes::pi * k / size));
  const Graph_counts counts = counts_of(points);
  CHECK(counts.components == 1);
  CHECK(counts.cycles == 1);
  CHECK(counts.ends == 0);
}

} // namespace loops_test
