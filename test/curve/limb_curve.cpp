// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Whether the balls of a limb are in it, or between it and another one that faces it.

#include "surface_of.h"

#include "catch2.h"

#include <CGAL/Point_set_skeletonization_3/internal/curve/limb_curve.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/visit_around.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace limb_curve_test {

using namespace CGAL::Point_set_skeletonization_3::internal;

namespace {

// Two sheets, a distance of one apart, along the z axis; the balls in the middle touch both.
struct Two_sheets
{
  static constexpr int length = 40, width = 5; // patches
  static constexpr double step = 0.2;

  Patches patches;
  Samples samples;
  Surface_quotient quotient;
  std::vector<double> heights; // of each vertex

  // The patches at one height, or those of one of the sheets, are of a vertex.
  void add_vertex(double z, const std::vector<double>& sides)
  {
    const std::size_t v = quotient.graph.vertices.size();
    quotient.members.emplace_back();
    quotient.piece_of.push_back(v);
    heights.push_back(z);
    for(double x : sides)
      for(int k = 0; k < width; ++k) {
        Patch patch;
        patch.mean = Vector3(x, step * (k - width / 2), z);
        patch.normal = Vector3(x > 0 ? 1 : -1, 0, 0);
        patch.spacing = step;
        patch.area = step * step;
        patch.weight = 1;
        patch.components = 1;
        quotient.vertex_of_patch.push_back(v);
        quotient.members[v].push_back(patches.size());
        samples.push_back({Vector3(0, patch.mean.y(), z), std::abs(x)});
        patches.push_back(patch);
      }
    quotient.graph.vertices.push_back(middle(quotient.members[v], patches, samples));
  }

  void connect(std::size_t v, std::size_t w) { quotient.graph.edges.emplace_back(v, w); }

  // What remains without the vertices from `removed` on.
  Limb_curve curve(std::size_t removed, Concurrency concurrency = Concurrency::sequential) const
  {
    std::vector<bool> is_removed(quotient.graph.vertices.size(), false);
    for(std::size_t v = removed; v < is_removed.size(); ++v)
      is_removed[v] = true;
    return limb_curve(quotient,
                      {without(quotient.graph, is_removed),
                       std::vector<bool>(is_removed.size(), false), indices_of_kept(is_removed)},
                      surfaces::surface_of(patches), samples, concurrency);
  }

  Limb_curve curve() const { return curve(quotient.graph.vertices.size()); }
};

// Two leaves with a limb each, that part at the height 0, one after the other.
Two_sheets two_leaves()
{
  Two_sheets result;
  for(double x : {-0.5, 0.5})
    for(int k = 0; k < Two_sheets::length; ++k) {
      result.add_vertex(Two_sheets::step * k, {x});
      if(k > 0)
        result.connect(result.heights.size() - 2, result.heights.size() - 1);
    }
  result.connect(0, Two_sheets::length);
  return result;
}

} // namespace

TEST_CASE("Balls between two leaves are in neither: the curve is on each")
{
  const Two_sheets leaves = two_leaves();
  const Limb_curve curve = leaves.curve();
  for(std::size_t v = 0; v < leaves.heights.size(); ++v) {
    CAPTURE(v, leaves.heights[v]);
    const double side = v < Two_sheets::length ? -0.5 : 0.5;
    // From a leaf to the other one the way is twice the height.
    const bool is_between = 2 * leaves.heights[v] > 2 + 1e-9;
    CHECK(curve.graph.vertices[v].position.x() == Approx(is_between ? side : 0).margin(1e-6));
    CHECK(curve.graph.vertices[v].position.z() == Approx(leaves.heights[v]).margin(1e-6));
    CHECK(is_open(curve.graph.vertices[v]) == is_between);
    for(std::size_t i : leaves.quotient.members[v])
      CHECK(is_off_surface(curve.samples[i], leaves.patches[i]) == !is_between);
  }
}

TEST_CASE("Limbs that part at a junction face each other once they are apart")
{
  constexpr int stem = 10;
  constexpr double radius = 0.25;
  Two_sheets plant;
  for(int k = 0; k < stem; ++k) {
    plant.add_vertex(Two_sheets::step * (k - stem + 1), {-radius, radius});
    if(k > 0)
      plant.connect(plant.heights.size() - 2, plant.heights.size() - 1);
  }
  for(double x : {-0.5, 0.5})
    for(int k = 1; k < Two_sheets::length; ++k) {
      plant.add_vertex(Two_sheets::step * k, {x});
      plant.connect(k == 1 ? stem - 1 : plant.heights.size() - 2, plant.heights.size() - 1);
    }
  const Limb_curve curve = plant.curve();
  for(std::size_t v = 0; v < plant.heights.size(); ++v) {
    CAPTURE(v, plant.heights[v]);
    // Within two radii of the junction, limbs are not apart yet.
    const bool is_apart = plant.heights[v] > 2 * radius;
    const Skeleton_graph::Vertex& vertex = curve.graph.vertices[v];
    CHECK(std::abs(vertex.position.x()) == Approx(is_apart ? 0.5 : 0).margin(1e-6));
    CHECK(is_open(vertex) == is_apart);
    CHECK(vertex.facing == Approx(is_apart ? 1 : 0));
  }
}

TEST_CASE("Balls that touch both sides of one limb stay")
{
  Two_sheets limb;
  for(int k = 0; k < Two_sheets::length; ++k) {
    limb.add_vertex(Two_sheets::step * k, {-0.5, 0.5});
    if(k > 0)
      limb.connect(limb.heights.size() - 2, limb.heights.size() - 1);
  }
  const Limb_curve curve = limb.curve();
  for(const Skeleton_graph::Vertex& vertex : curve.graph.vertices)
    CHECK(vertex.position.x() == Approx(0).margin(1e-6));
  for(std::size_t i = 0; i < limb.samples.size(); ++i)
    CHECK(curve.samples[i].position == limb.samples[i].position);
}

TEST_CASE("What faces a limb and has no curve of its own belongs to it")
{
  const Two_sheets leaves = two_leaves();
  const Limb_curve curve = leaves.curve(Two_sheets::length);
  REQUIRE(curve.graph.vertices.size() == Two_sheets::length);
  for(const Skeleton_graph::Vertex& vertex : curve.graph.vertices)
    CHECK(vertex.position.x() == Approx(0).margin(1e-6));
}

TEST_CASE("Balls between limbs are the same for any number of threads")
{
  const Two_sheets leaves = two_leaves();
  const std::size_t all = leaves.quotient.graph.vertices.size();
  const Limb_curve one = leaves.curve(), many = leaves.curve(all, Concurrency::parallel);
  for(std::size_t v = 0; v < all; ++v)
    CHECK(one.graph.vertices[v].position == many.graph.vertices[v].position);
}

TEST_CASE("Vertices are visited in the order of their way, each once")
{
  Skeleton_graph graph; // a cycle of four edges of lengths 1, 1, 1 and 3, and a vertex beside it
  for(double x : {0., 1., 2., 3., 9.})
    graph.vertices.push_back({Vector3(x, 0, 0)});
  graph.edges = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  std::vector<std::size_t> order;
  std::vector<double> ways;
  std::size_t barred = 4; // nothing leads on from here
  const auto visit = [&](std::size_t last) {
    order.clear();
    ways.clear();
    visit_around(
      graph, graph.adjacency(), 1, [&](std::size_t u, std::size_t) { return u != barred; },
      [&](std::size_t v, double way) {
        order.push_back(v);
        ways.push_back(way);
        return v != last;
      });
  };
  visit(4);
  CHECK(order == std::vector<std::size_t>{1, 0, 2, 3});
  CHECK(ways == std::vector<double>{0, 1, 1, 2});
  visit(2);
  CHECK(order == std::vector<std::size_t>{1, 0, 2});
  barred = 2;
  visit(4);
  CHECK(order == std::vector<std::size_t>{1, 0, 2, 3});
  CHECK(ways == std::vector<double>{0, 1, 1, 4}); // by the long edge
}

} // namespace limb_curve_test
