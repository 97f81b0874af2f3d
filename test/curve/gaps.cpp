// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What is joined over gaps: fragments and limbs that were not seen from all sides.

#include "catch2.h"

#include <CGAL/Point_set_skeletonization_3/internal/core/Union_find.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Bridge.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Curve_options.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Measured_components.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Skeleton_graph.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/bridge_gaps.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/continue_limbs.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/join_fragments.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <vector>

namespace gaps_test {

using namespace CGAL::Point_set_skeletonization_3::internal;

namespace {

constexpr double step = 0.01;

Skeleton_graph::Vertex vertex_at(const Vector3& position, double open)
{
  Skeleton_graph::Vertex result;
  result.position = position;
  result.radius = step;
  result.resolution = step;
  result.evidence = 1;
  result.open = open;
  return result;
}

/// Adds a line of vertices.
void add_line(Skeleton_graph& graph, const Vector3& from, const Vector3& to, double open,
              double spacing = step)
{
  const int edges = static_cast<int>(std::round((to - from).norm() / spacing));
  for(int k = 0; k <= edges; ++k) {
    if(k > 0)
      graph.edges.emplace_back(graph.vertices.size() - 1, graph.vertices.size());
    graph.vertices.push_back(vertex_at(from + k * (to - from) / edges, open));
    graph.vertices.back().resolution = spacing;
  }
}

/// Whether a line of length 0.2 is joined to one of length 4, at some distance from its middle.
bool is_joined(double gap, double open, double points = 1)
{
  Skeleton_graph graph;
  add_line(graph, Vector3(-2, 0, 0), Vector3(2, 0, 0), 0);
  const std::size_t whole = graph.vertices.size();
  add_line(graph, Vector3(0, gap, 0), Vector3(0, gap + 0.2, 0), open);
  std::vector<double> number(graph.vertices.size(), points);
  std::fill_n(number.begin(), whole, 1.0);
  join_fragments(graph, number, Curve_options());
  const bool result = Measured_components(graph, number).are_connected(0, whole);
  CHECK(graph.edges.size() == graph.vertices.size() - (result ? 1 : 2)); // no cycle
  return result;
}

/// An arc of the unit circle without some degrees.
Skeleton_graph arc(double missing, double open, double evidence)
{
  Skeleton_graph graph;
  constexpr int edges = 300;
  for(int k = 0; k <= edges; ++k) {
    const double angle = (360 - missing) * k / edges * CGAL_PI / 180;
    graph.vertices.push_back(vertex_at(Vector3(std::cos(angle), std::sin(angle), 0), open));
    graph.vertices.back().evidence = evidence;
    if(k > 0)
      graph.edges.emplace_back(k - 1, k);
  }
  return graph;
}

/// Surface points of vertices: one at each.
std::vector<std::vector<Vector3>> one_each(const Skeleton_graph& graph)
{
  std::vector<std::vector<Vector3>> result;
  for(const Skeleton_graph::Vertex& vertex : graph.vertices)
    result.push_back({vertex.position});
  return result;
}

std::size_t number_of_components(const Skeleton_graph& graph)
{
  Union_find sets = components_of(graph);
  std::set<std::size_t> result;
  for(std::size_t v = 0; v < graph.vertices.size(); ++v)
    result.insert(sets.find(v));
  return result.size();
}

std::size_t loops_of_continued(Skeleton_graph graph)
{
  continue_limbs(graph, one_each(graph), Curve_options());
  return graph.edges.size() + number_of_components(graph) - graph.vertices.size();
}

/// Number of limbs joined of two that point at each other, from x = -`length` to 0 and, as long as
/// `other`, from x = `gap`; the points of their tips cover `seen` of the gap from both sides.
std::size_t joined(double length, double gap, double other, double seen)
{
  Skeleton_graph graph;
  add_line(graph, Vector3(-length, 0, 0), Vector3(0, 0, 0), 1);
  const std::size_t tip = graph.vertices.size() - 1;
  add_line(graph, Vector3(gap, 0, 0), Vector3(gap + other, 0, 0), 1);
  std::vector<std::vector<Vector3>> points = one_each(graph);
  points[tip].assign(3, Vector3(seen, 0, 0));
  points[tip + 1].assign(3, Vector3(gap - seen, 0, 0));
  const std::size_t before = number_of_components(graph);
  continue_limbs(graph, points, Curve_options());
  return before - number_of_components(graph);
}

} // namespace

TEST_CASE("A fragment is joined over a gap of twice its length, and no wider one")
{
  CHECK(is_joined(0.15, 1));
  CHECK(is_joined(0.35, 1));
  CHECK_FALSE(is_joined(0.45, 1));
}

TEST_CASE("What was seen from all sides, or is no small part, is no fragment")
{
  CHECK_FALSE(is_joined(0.15, 0));
  CHECK_FALSE(is_joined(0.15, 1, 10)); // half the points of the other
}

TEST_CASE("What branches is sooner a shape of its own than what is one limb")
{
  for(const double branch : {0.01, 0.15}) {
    CAPTURE(branch);
    Skeleton_graph graph;
    add_line(graph, Vector3(-2, 0, 0), Vector3(2, 0, 0), 0);
    const std::size_t piece = graph.vertices.size();
    add_line(graph, Vector3(0, 0.1, 0), Vector3(0, 0.3, 0), 1);
    const std::size_t middle = (piece + graph.vertices.size()) / 2;
    for(int k = 0; k < 6; ++k) {
      const double angle = k * CGAL_PI / 3;
      const std::size_t first = graph.vertices.size();
      const Vector3 start = graph.vertices[middle].position;
      add_line(graph, start, start + branch * Vector3(std::cos(angle), 0, std::sin(angle)), 1);
      graph.edges.emplace_back(middle, first);
    }
    const double in_piece = static_cast<double>(graph.vertices.size() - piece);
    std::vector<double> points(graph.vertices.size(), 0.2 * static_cast<double>(piece) / in_piece);
    std::fill_n(points.begin(), piece, 1.0);
    const std::size_t before = graph.edges.size();
    join_fragments(graph, points, Curve_options());
    CHECK(graph.edges.size() == before + (branch < 0.1 ? 1 : 0));
  }
}

TEST_CASE("A fragment between two shapes joins the nearer one, and not the two")
{
  Skeleton_graph graph;
  add_line(graph, Vector3(-2, 0, 0), Vector3(2, 0, 0), 1);
  const std::size_t other = graph.vertices.size();
  add_line(graph, Vector3(-2, 0.4, 0), Vector3(2, 0.4, 0), 1);
  const std::size_t fragment = graph.vertices.size();
  add_line(graph, Vector3(0, 0.12, 0), Vector3(0, 0.3, 0), 1);
  const std::vector<double> points(graph.vertices.size(), 1);
  join_fragments(graph, points, Curve_options());
  const Measured_components components(graph, points);
  CHECK(components.are_connected(fragment, other));
  CHECK_FALSE(components.are_connected(fragment, 0));
}

TEST_CASE("What is joined to a component does not make others its fragments")
{
  Skeleton_graph graph;
  for(int k = 0; k < 12; ++k) // each is longer than the gap to the next
    add_line(graph, Vector3(0, 0.3 * k, 0), Vector3(0, 0.3 * k + 0.2, 0), 1);
  const std::size_t before = graph.edges.size();
  join_fragments(graph, std::vector<double>(graph.vertices.size(), 1), Curve_options());
  CHECK(graph.edges.size() == before);
}

TEST_CASE("Limbs are joined over a gap that is shorter than both together")
{
  CHECK(joined(0.5, 0.55, 0.1, 0) == 1);
  CHECK(joined(0.1, 0.55, 0.5, 0) == 1); // whichever is the longer
  CHECK(joined(0.5, 0.65, 0.1, 0) == 0);
}

TEST_CASE("A gap is one between surface points, which lie beyond the tips")
{
  CHECK(joined(0.5, 0.7, 0.1, 0.03) == 1); // 0.64 are missing, 0.66 were seen
  CHECK(joined(0.5, 0.7, 0.1, 0.02) == 0);
  CHECK(joined(0.5, 0.7, 0.1, 0.6) == 1); // the points of one tip overlap those of the other
}

TEST_CASE("An arc becomes a circle if it is longer than the gap, and both tips point over it")
{
  CHECK(loops_of_continued(arc(30, 1, 1)) == 1);
  CHECK(loops_of_continued(arc(120, 1, 1)) == 0);
}

TEST_CASE("Tips that were seen from all sides, or limbs without evidence, end where they end")
{
  CHECK(loops_of_continued(arc(30, 0, 1)) == 0);
  CHECK(loops_of_continued(arc(30, 1, 0.2)) == 0);
}

TEST_CASE("Where nothing is missing, a limb goes on without evidence, however it was seen")
{
  const double spacing_in_degrees = step * 180 / CGAL_PI;
  for(const double open : {0.0, 1.0})
    for(const double evidence : {0.2, 1.0}) {
      CAPTURE(open, evidence);
      CHECK(loops_of_continued(arc(1.2 * spacing_in_degrees, open, evidence)) == 1);
      CHECK(loops_of_continued(arc(2 * spacing_in_degrees, open, evidence)) ==
            (open == 1 && evidence == 1 ? 1 : 0));
    }
}

TEST_CASE("Two limbs over a gap are judged as one: together they have evidence or have not")
{
  for(const double evidence : {0.4, 0.1}) {
    CAPTURE(evidence);
    Skeleton_graph graph;
    add_line(graph, Vector3(-0.4, 0, 0), Vector3(0, 0, 0), 1);
    const std::size_t other = graph.vertices.size();
    add_line(graph, Vector3(0.2, 0, 0), Vector3(0.6, 0, 0), 1);
    for(std::size_t v = 0; v < other; ++v)
      graph.vertices[v].evidence = evidence; // the other has 1
    continue_limbs(graph, one_each(graph), Curve_options());
    CHECK(Measured_components(graph, std::vector<double>(graph.vertices.size(), 1))
            .are_connected(0, other) == (evidence + 1 > 2 * Curve_options().limb_evidence));
  }
}

TEST_CASE("Over a gap a loop is closed if there is room for a hole in it")
{
  for(const double apart : {0.01, 0.1}) { // limbs that are joined at their ends, one with a gap
    CAPTURE(apart);
    Skeleton_graph graph;
    add_line(graph, Vector3(0, 0, 0), Vector3(1, 0, 0), 1);
    const std::size_t right = graph.vertices.size();
    add_line(graph, Vector3(1, apart, 0), Vector3(0.55, apart, 0), 1);
    add_line(graph, Vector3(0.45, apart, 0), Vector3(0, apart, 0), 1);
    graph.edges.emplace_back(right - 1, right);
    graph.edges.emplace_back(graph.vertices.size() - 1, 0);
    for(Skeleton_graph::Vertex& vertex : graph.vertices)
      vertex.is_cross_section = true;
    CHECK(loops_of_continued(graph) == (apart > 2 * step ? 1 : 0));
  }
}

TEST_CASE("A limb ends within the gap of another")
{
  Skeleton_graph graph;
  add_line(graph, Vector3(-1, 0, 0), Vector3(0, 0, 0), 1);
  add_line(graph, Vector3(0.4, 0, 0), Vector3(1.4, 0, 0), 1);
  const std::size_t third = graph.vertices.size();
  add_line(graph, Vector3(0.2, 0.05, 0), Vector3(0.2, 1, 0), 1);
  continue_limbs(graph, one_each(graph), Curve_options());
  const auto adjacency = graph.adjacency();
  REQUIRE(adjacency[third].size() == 2);
  const Vector3 end = graph.vertices[adjacency[third][1]].position;
  CHECK(end.y() == Approx(0).margin(1e-12));
  CHECK(std::abs(end.x() - 0.2) < 0.04); // 37 degrees
  CHECK(adjacency[adjacency[third][1]].size() == 3);
}

TEST_CASE("A limb goes on to the limb that it points at, not to one beside it")
{
  Skeleton_graph graph;
  add_line(graph, Vector3(0, 0, 0), Vector3(1, 0, 0), 1);
  add_line(graph, Vector3(1.3, -1, 0), Vector3(1.3, 1, 0), 1); // in front
  add_line(graph, Vector3(0, 0.2, 0), Vector3(1, 0.2, 0), 1); // beside, and in front of the same
  const std::size_t before = graph.edges.size();
  continue_limbs(graph, one_each(graph), Curve_options());
  REQUIRE(graph.edges.size() == before + 2);
  for(std::size_t e = before; e < graph.edges.size(); ++e) {
    const auto [a, b] = graph.edges[e];
    CHECK(graph.vertices[a].position.x() == 1);
    CHECK(graph.vertices[b].position.x() == 1.3);
  }
}

TEST_CASE("A few points in the air are no limb that reaches as far as from each to the next")
{
  for(const double spacing : {step, 10 * step}) { // 31 points, or 4
    CAPTURE(spacing);
    Skeleton_graph graph;
    add_line(graph, Vector3(-2, 0, 0), Vector3(2, 0, 0), 1);
    const std::size_t row = graph.vertices.size();
    add_line(graph, Vector3(0, 0.25, 0), Vector3(0, 0.55, 0), 1, spacing);
    const std::vector<double> points(graph.vertices.size(), 1);
    const bool is_limb = spacing == step;
    const auto is_joined = [&](const Skeleton_graph& result) {
      return Measured_components(result, points).are_connected(0, row);
    };
    Skeleton_graph result = graph;
    continue_limbs(result, one_each(graph), Curve_options());
    CHECK(is_joined(result) == is_limb);
    result = graph;
    join_fragments(result, points, Curve_options());
    CHECK(is_joined(result) == is_limb);
    result = graph;
    bridge_gaps(result, one_each(graph), Curve_options());
    CHECK_FALSE(is_joined(result));
  }
}

TEST_CASE("No limb goes on in the wall of what was seen from all sides")
{
  for(const double open : {0.0, 1.0}) {
    CAPTURE(open);
    Skeleton_graph graph;
    add_line(graph, Vector3(0, -1, 0), Vector3(0, 1, 0), open);
    const std::size_t other = graph.vertices.size();
    add_line(graph, Vector3(0.3, 0, 0), Vector3(1, 0, 0), 1);
    continue_limbs(graph, one_each(graph), Curve_options());
    CHECK(Measured_components(graph, std::vector<double>(graph.vertices.size(), 1))
            .are_connected(0, other) == (open == 1));
  }
}

} // namespace gaps_test
