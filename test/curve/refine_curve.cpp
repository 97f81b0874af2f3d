// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Branches cut, resampled and smoothed keep what they connect; tips reach the ends of limbs.

#include "catch2.h"

#include <CGAL/Point_set_skeletonization_3/internal/core/Union_find.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/branches.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/extend_open_tips.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/refine_curve.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <set>
#include <utility>
#include <vector>

namespace refine_curve_test {

using namespace CGAL::Point_set_skeletonization_3::internal;

namespace {

// Squares in a row: every second branch is closed, those between lead from square to square.
Skeleton_graph squares(std::size_t size)
{
  Skeleton_graph graph;
  const auto add = [&](double x, double y) {
    graph.vertices.push_back({Vector3(x, y, 0), 0.1, 0, false});
    return graph.vertices.size() - 1;
  };
  for(std::size_t i = 0; i < size; ++i) {
    const double x = 3 * static_cast<double>(i);
    const std::size_t corner = add(x, 0);
    if(i > 0)
      graph.edges.emplace_back(corner - 4, corner);
    graph.edges.emplace_back(corner, add(x, 1));
    graph.edges.emplace_back(corner + 1, add(x + 1, 1));
    graph.edges.emplace_back(corner + 2, add(x + 1, 0));
    graph.edges.emplace_back(corner + 3, corner);
  }
  return graph;
}

std::size_t components(const Skeleton_graph& graph)
{
  Union_find connectivity(graph.vertices.size());
  std::size_t result = graph.vertices.size();
  for(const Skeleton_graph::Edge& e : graph.edges)
    result -= connectivity.join(e.first, e.second) ? 1 : 0;
  return result;
}

// A path with a radius, through vertices one unit apart on the x axis and off it by `off(x)`.
template <typename Off>
Skeleton_graph path(int size, double radius, const Off& off)
{
  Skeleton_graph graph;
  for(int x = 0; x < size; ++x) {
    graph.vertices.push_back({Vector3(x, off(x), 0), radius, 0, false});
    if(x > 0)
      graph.edges.emplace_back(graph.vertices.size() - 2, graph.vertices.size() - 1);
  }
  return graph;
}

double straight(double) { return 0; }

double roughness(const Skeleton_graph& graph)
{
  double sum = 0;
  for(const auto& vertex : graph.vertices)
    sum += std::abs(vertex.position.y());
  return sum;
}

bool everywhere(const Vector3&) { return true; }

// A step of the same length everywhere.
std::function<double(const Skeleton_graph::Vertex&)> every(double step)
{
  return [step](const Skeleton_graph::Vertex&) { return step; };
}

} // namespace

TEST_CASE("Every edge is in one branch, from end or junction to end or junction")
{
  constexpr std::size_t size = 5;
  Skeleton_graph graph = squares(size);
  graph.vertices.push_back({Vector3(0, 5, 0), 1, 0, false}); // alone
  const auto adjacency = graph.adjacency();
  std::size_t edges = 0, closed = 0, alone = 0;
  for(const Branch& branch : branches(graph)) {
    edges += branch.size() - 1;
    closed += is_closed(branch);
    alone += branch.size() == 1;
    for(std::size_t k = 1; k + 1 < branch.size(); ++k)
      CHECK(adjacency[branch[k]].size() == 2);
    for(std::size_t k = 1; k < branch.size(); ++k) {
      const std::vector<std::size_t>& next = adjacency[branch[k]];
      CHECK(std::count(next.begin(), next.end(), branch[k - 1]) == 1);
    }
  }
  CHECK(edges == graph.edges.size());
  CHECK(closed == size);
  CHECK(alone == 1);

  // A cycle without a junction.
  const std::vector<Branch> ring = branches(squares(1));
  REQUIRE(ring.size() == 1);
  CHECK(is_closed(ring[0]));
  CHECK(ring[0].size() == 5);
}

TEST_CASE("Resampling keeps components and cycles and makes no parallel edges")
{
  constexpr std::size_t size = 5;
  for(int k = 1; k < 200; ++k) {
    const double step = 0.02 * k;
    CAPTURE(step);
    const Skeleton_graph graph = resampled(squares(size), every(step));
    CHECK(components(graph) == 1);
    CHECK(graph.edges.size() + 1 - graph.vertices.size() == size);
    std::set<std::pair<std::size_t, std::size_t>> different;
    for(const Skeleton_graph::Edge& e : graph.edges)
      different.insert(std::minmax(e.first, e.second));
    CHECK(different.size() == graph.edges.size());
  }
}

TEST_CASE("Resampled vertices are evenly spaced on the branch, with the radius there")
{
  Skeleton_graph graph = path(11, 0, straight);
  for(auto& vertex : graph.vertices)
    vertex.radius = vertex.position.x();
  for(const double step : {0.3, 1.0, 2.7, 100.0}) {
    CAPTURE(step);
    const Skeleton_graph result = resampled(graph, every(step));
    const double pieces = std::max(1.0, std::round(10 / step));
    CHECK(result.vertices.size() == 1 + static_cast<std::size_t>(pieces));
    double shortest = 100, longest = 0;
    for(const auto& e : result.edges) {
      const double length =
        (result.vertices[e.first].position - result.vertices[e.second].position).norm();
      shortest = std::min(shortest, length);
      longest = std::max(longest, length);
    }
    CHECK(longest == Approx(shortest));
    for(const auto& vertex : result.vertices)
      CHECK(vertex.radius == Approx(vertex.position.x()).margin(1e-12));
  }
  Skeleton_graph point;
  point.vertices.push_back({Vector3(1, 2, 3), 4, 0, false});
  CHECK(resampled(point, every(1)).vertices.size() == 1);
  CHECK(resampled(Skeleton_graph(), every(1)).vertices.empty());
}

TEST_CASE("Resampled vertices are as far apart as asked for where they are")
{
  Skeleton_graph graph = path(101, 0, straight);
  for(auto& vertex : graph.vertices)
    vertex.radius = 1 + vertex.position.x() / 100;
  const Skeleton_graph result =
    resampled(graph, [](const Skeleton_graph::Vertex& vertex) { return vertex.radius; });
  for(const auto& e : result.edges) {
    const auto &a = result.vertices[e.first], &b = result.vertices[e.second];
    CHECK((a.position - b.position).norm() == Approx((a.radius + b.radius) / 2).epsilon(0.05));
  }
}

TEST_CASE("Smoothing takes a zigzag off, keeps a bend, and moves no end or junction")
{
  Skeleton_graph zigzag = path(41, 1, [](double x) { return std::fmod(x, 2) == 0 ? 0.3 : -0.3; });
  const Skeleton_graph before = zigzag;
  smooth(zigzag);
  CHECK(zigzag.edges == before.edges);
  CHECK(zigzag.vertices.front().position == before.vertices.front().position);
  CHECK(zigzag.vertices.back().position == before.vertices.back().position);
  CHECK(roughness(zigzag) < 0.2 * roughness(before));

  const auto hill = [](double x) { return 10 * std::sin(CGAL_PI * x / 40); };
  Skeleton_graph bend = path(41, 1, hill);
  smooth(bend);
  for(const auto& vertex : bend.vertices)
    CHECK(std::abs(vertex.position.y() - hill(vertex.position.x())) < 0.1);

  for(std::size_t size : {4, 6, 7, 8, 12, 40}) { // a wave as long as a cycle stays
    Skeleton_graph cycle;
    for(std::size_t v = 0; v < size; ++v) {
      const double angle = 2 * CGAL_PI * static_cast<double>(v) / static_cast<double>(size);
      cycle.vertices.push_back({Vector3(std::cos(angle), std::sin(angle), 0), 1, 0, false});
      cycle.edges.emplace_back(v, (v + 1) % size);
    }
    smooth(cycle);
    for(const auto& vertex : cycle.vertices)
      CHECK(std::abs(vertex.position.norm() - 1) < 0.15);
  }

  Skeleton_graph row = squares(5);
  smooth(row);
  const auto adjacency = row.adjacency();
  for(std::size_t v = 0; v < row.vertices.size(); ++v)
    if(adjacency[v].size() != 2)
      CHECK(row.vertices[v].position == squares(5).vertices[v].position);
}

TEST_CASE("Points of lines are not smoothed, and resampled vertices between them are on lines")
{
  Skeleton_graph zigzag = path(20, 1, [](double x) { return std::fmod(x, 2) - 0.5; });
  for(std::size_t v = 5; v < 15; ++v)
    zigzag.vertices[v].is_on_line = true;
  Skeleton_graph graph = zigzag;
  smooth(graph);
  for(std::size_t v = 1; v + 1 < graph.vertices.size(); ++v)
    CHECK((graph.vertices[v].position == zigzag.vertices[v].position) == (v >= 5 && v < 15));
  for(const Skeleton_graph::Vertex& vertex : resampled(zigzag, every(0.1)).vertices)
    CHECK(vertex.is_on_line == (vertex.position.x() >= 5 && vertex.position.x() <= 14));
}

TEST_CASE("A tip moves out until its ball reaches the end of the limb")
{
  constexpr double radius = 1.5;
  // A cap around (14, 0, 0), which belongs to the last vertex at x = 10.
  const Skeleton_graph before = path(11, radius, straight);
  std::vector<std::vector<Vector3>> surface(before.vertices.size());
  for(int k = 0; k <= 8; ++k)
    for(double z : {-0.1, 0.1}) {
      const double angle = CGAL_PI * (k - 4) / 8;
      surface.back().push_back(
        Vector3(14 + radius * std::cos(angle), radius * std::sin(angle), z));
    }
  Skeleton_graph graph = before;
  extend_tips(graph, surface, everywhere);
  CHECK(graph.vertices.back().position.x() == Approx(14).margin(0.1 * radius));
  CHECK(graph.vertices.back().position.y() == Approx(0).margin(1e-12));
  for(std::size_t v = 0; v + 1 < graph.vertices.size(); ++v)
    CHECK(graph.vertices[v].position == before.vertices[v].position);

  // Not to where nothing is inside.
  graph = before;
  extend_tips(graph, surface, [](const Vector3& p) { return p.x() < 11.5; });
  CHECK(graph.vertices.back().position.x() > 10);
  CHECK(graph.vertices.back().position.x() < 11.5);

  // One or two points far out are outliers, and a tip never moves back.
  graph = before;
  surface.back() = {Vector3(50, 0, 0), Vector3(60, 0, 0), Vector3(9, radius, 0),
                    Vector3(9, -radius, 0)};
  extend_tips(graph, surface, everywhere);
  CHECK(graph.vertices.back().position == before.vertices.back().position);
}

namespace {

// The end of a leaf, three points wide, on an arc of a length that continues the x axis from
// (10, 0, 0): the points that `is_seen(s)`, s from 0 at the tip of the curve.
template <typename Is_seen>
std::vector<Vector3> end_of_leaf(int length, const Is_seen& is_seen)
{
  constexpr double radius = 10;
  std::vector<Vector3> result;
  for(int s = 0; s <= length; ++s)
    if(is_seen(s))
      for(int z = -1; z <= 1; ++z)
        result.emplace_back(10 + radius * std::sin(s / radius), radius * (1 - std::cos(s / radius)),
                            z);
  return result;
}

// The x axis from 0 to 10 after extension through the points of its tip.
Skeleton_graph extended_leaf(const std::vector<Vector3>& points, double open)
{
  Skeleton_graph graph = path(11, 0.5, straight);
  for(Skeleton_graph::Vertex& vertex : graph.vertices) {
    vertex.resolution = 1;
    vertex.open = open;
  }
  std::vector<std::vector<Vector3>> points_of_vertices(graph.vertices.size());
  points_of_vertices.back() = points;
  extend_open_tips(graph, points_of_vertices, std::vector<double>(graph.vertices.size(), 0.5),
                   Curve_options());
  return graph;
}

} // namespace

TEST_CASE("The tip of a leaf goes on through its points to their end, but not over a gap or back")
{
  constexpr int length = 6;
  constexpr double open = 1, closed = 0;
  const auto all = [](int) { return true; };
  const std::vector<Vector3> leaf = end_of_leaf(length, all);
  const Skeleton_graph before = extended_leaf({}, open);
  const Skeleton_graph after = extended_leaf(leaf, open);
  REQUIRE(after.vertices.size() > before.vertices.size());
  // One of the last three points; and it is still one branch.
  CHECK(std::find(leaf.end() - 3, leaf.end(), after.vertices.back().position) != leaf.end());
  CHECK(branches(after).size() == 1);
  for(std::size_t v = 0; v < before.vertices.size(); ++v)
    CHECK(after.vertices[v].position == before.vertices[v].position);

  const auto tip_of = [](const Skeleton_graph& graph) { return graph.vertices.back().position; };
  CHECK(tip_of(extended_leaf(leaf, closed)) == tip_of(before)); // has an inside
  const auto before_gap = [](int s) { return s <= 2 || s > 5; };
  const Vector3 at_gap = tip_of(extended_leaf(end_of_leaf(10, before_gap), open));
  CHECK(at_gap.x() == Approx(10 + 10 * std::sin(0.2)));
  CHECK(tip_of(extended_leaf({Vector3(9, 0, 0), Vector3(8, 0, 0), Vector3(7, 0, 0)}, open)) ==
        tip_of(before));
}

TEST_CASE("A tip points along its branch, not along its last edge")
{
  Skeleton_graph graph = path(11, 2, straight);
  graph.vertices.back().position = Vector3(9, 0.5, 0); // aside
  const Vector3 direction = tip_direction(10, graph, graph.adjacency());
  CHECK(direction.norm() == Approx(1));
  CHECK(direction.x() > 0.9);
}

} // namespace refine_curve_test
