// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch2.h"

#include <CGAL/Point_set_skeletonization_3/internal/curve/doubled_tips.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace doubled_tips_test {

using namespace CGAL::Point_set_skeletonization_3::internal;

namespace {

constexpr double step = 0.3; // radii of a limb

// Adds a curve from vertex `from`, or from a new one at `begin` if there are as many, in steps.
// Returns its last vertex.
std::size_t add_curve(Skeleton_graph& graph, std::size_t from, const Vector3& begin,
                      const Vector3& end, double radius = 1)
{
  const auto steps = static_cast<int>((end - begin).norm() / (step * radius));
  if(from == graph.vertices.size())
    graph.vertices.push_back({begin, radius});
  for(int k = 1; k <= steps; ++k) {
    graph.vertices.push_back({Vector3(begin + k * (end - begin) / steps), radius});
    graph.edges.emplace_back(k == 1 ? from : graph.vertices.size() - 2, graph.vertices.size() - 1);
  }
  return graph.vertices.size() - 1;
}

std::vector<Vector3> doubled(const Skeleton_graph& graph)
{
  const std::vector<bool> is_doubled = doubled_tips(graph);
  std::vector<Vector3> result;
  for(std::size_t v = 0; v < is_doubled.size(); ++v)
    if(is_doubled[v])
      result.push_back(graph.vertices[v].position);
  return result;
}

// Adds a limb from (0, 0, 0) to (20, 0, 0); returns its last vertex.
std::size_t add_limb(Skeleton_graph& graph)
{
  return add_curve(graph, 0, Vector3(0, 0, 0), Vector3(20, 0, 0));
}

} // namespace

TEST_CASE("The way back along a limb is dropped, the way out is kept")
{
  for(const double unit : {1., 1e-4, 1e4}) {
    CAPTURE(unit);
    Skeleton_graph graph;
    const std::size_t end = add_limb(graph);
    add_curve(graph, end, Vector3(20, 0.2, 0), Vector3(8, 0.2, 0));
    for(auto& vertex : graph.vertices) {
      vertex.position *= unit;
      vertex.radius *= unit;
    }
    double first = 20 * unit;
    const std::vector<Vector3> dropped = doubled(graph);
    for(const Vector3& p : dropped) {
      CHECK(p.y() > 0.1 * unit);
      first = std::min(first, p.x());
    }
    CHECK(first == Approx(8 * unit));
    CHECK(static_cast<double>(dropped.size()) * step > 9); // all but the turn
  }
}

TEST_CASE("A branch in the core of a limb is dropped up to its junction")
{
  Skeleton_graph graph;
  add_limb(graph);
  const std::size_t junction = 20;
  add_curve(graph, junction, graph.vertices[junction].position, Vector3(14, 0.3, 0));
  const std::size_t all = graph.vertices.size();
  const std::vector<bool> is_doubled = doubled_tips(graph);
  bool is_only_branch = true;
  std::size_t dropped = 0;
  const std::size_t of_limb = static_cast<std::size_t>(20 / step) + 1;
  for(std::size_t v = 0; v < all; ++v) {
    dropped += is_doubled[v] ? 1 : 0;
    is_only_branch = is_only_branch && is_doubled[v] == (v >= of_limb);
  }
  CHECK(dropped > 0);
  CHECK(is_only_branch);
}

TEST_CASE("Of two limbs that overlap something stays everywhere")
{
  Skeleton_graph graph;
  add_limb(graph);
  add_curve(graph, graph.vertices.size(), Vector3(15, 0.2, 0), Vector3(30, 0.2, 0));
  const std::vector<bool> is_doubled = doubled_tips(graph);
  for(double x = 0; x <= 30; x += step) {
    CAPTURE(x);
    bool is_there = false;
    for(std::size_t v = 0; v < is_doubled.size(); ++v)
      is_there = is_there || (!is_doubled[v] && std::abs(graph.vertices[v].position.x() - x) < 1);
    CHECK(is_there);
  }
  CHECK(!doubled(graph).empty());
}

TEST_CASE("Limbs beside each other, twigs and thin limbs that leave thick ones stay")
{
  Skeleton_graph beside;
  add_limb(beside);
  add_curve(beside, beside.vertices.size(), Vector3(5, 1.8, 0), Vector3(15, 1.8, 0));
  CHECK(doubled(beside).empty());

  Skeleton_graph twig;
  add_limb(twig);
  add_curve(twig, 30, twig.vertices[30].position, twig.vertices[30].position + Vector3(0, 2, 0),
            0.1);
  CHECK(doubled(twig).empty());

  // Points far from a thin line say nothing about its radius: it is not in the core of a limb that
  // is not in its own.
  Skeleton_graph thin;
  add_limb(thin);
  add_curve(thin, thin.vertices.size(), Vector3(5, 0.3, 0), Vector3(15, 0.3, 0), 0.1);
  CHECK(doubled(thin).empty());
}

TEST_CASE("Rings, bends and single vertices have no doubled tips")
{
  CHECK(doubled_tips({}).empty());
  Skeleton_graph graph;
  graph.vertices.push_back({Vector3(100, 0, 0), 1});
  CHECK(doubled(graph).empty());
  const std::size_t corner = add_curve(graph, 1, Vector3(0, 0, 0), Vector3(5, 0, 0));
  add_curve(graph, corner, Vector3(5, 0, 0), Vector3(5, 5, 0));
  CHECK(doubled(graph).empty());
  const std::size_t last = graph.vertices.size() - 1;
  graph.edges.emplace_back(last, 1);
  CHECK(doubled(graph).empty());
}

} // namespace doubled_tips_test
