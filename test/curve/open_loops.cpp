// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Which loops are opened, and where.

#include "catch2.h"
#include "surface_of.h"

#include <CGAL/Point_set_skeletonization_3/internal/core/Union_find.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Curve_options.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/limb_evidence.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/open_loops.h>
#include <CGAL/Point_set_skeletonization_3/internal/pipeline/limb_network.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

namespace open_loops_test {

using namespace CGAL::Point_set_skeletonization_3::internal;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A regular polygon with this number of vertices, and their evidence.
Skeleton_graph polygon(std::size_t size, double evidence)
{
  Skeleton_graph graph;
  graph.vertices.resize(size);
  for(std::size_t v = 0; v < size; ++v) {
    const double angle = 2 * CGAL_PI * static_cast<double>(v) / static_cast<double>(size);
    graph.vertices[v].position = {std::cos(angle), std::sin(angle), 0};
    graph.vertices[v].evidence = evidence;
    graph.edges.emplace_back(v, (v + 1) % size);
  }
  return graph;
}

std::vector<double> evidence_of(const Skeleton_graph& graph)
{
  std::vector<double> result;
  for(const auto& vertex : graph.vertices)
    result.push_back(vertex.evidence);
  return result;
}

/// Opens loops with less mean evidence than this.
Skeleton_graph opened_below(const Skeleton_graph& graph, double least)
{
  return with_loops_opened(graph, evidence_of(graph), [&](const Loop& loop) {
    return evidence_along(loop, graph).evidence() >= least;
  });
}

bool has_edge(const Skeleton_graph& graph, std::size_t v, std::size_t w)
{
  return std::count(graph.edges.begin(), graph.edges.end(), Skeleton_graph::Edge(v, w)) +
           std::count(graph.edges.begin(), graph.edges.end(), Skeleton_graph::Edge(w, v)) >
         0;
}

Patch patch_at(const Vector3& place, const Vector3& normal, double spacing)
{
  Patch patch;
  patch.mean = place;
  patch.normal = normal.normalized();
  patch.weight = 1;
  patch.spacing = spacing;
  patch.area = spacing * spacing;
  return patch;
}

/// The evidence at a vertex in the middle of the patches that are nearest to a place, within
/// `reach`. Samples are as far behind their patches as `depth`.
double evidence_near(const Vector3& place, double reach, const Patches& patches, double depth,
                     Strip kind_of_strip = Strip::side)
{
  const Surface surface = surfaces::surface_of(patches);
  Samples samples;
  for(const Patch& patch : patches)
    samples.push_back({patch.mean - depth * patch.normal, depth});
  std::vector<std::size_t> members;
  for(std::size_t i = 0; i < patches.size(); ++i)
    if((patches[i].mean - place).norm() < reach)
      members.push_back(i);
  REQUIRE(members.size() > 2);
  return Limb_evidence(surface, samples, kind_of_strip)(
    middle(members, patches, samples), members);
}

} // namespace

TEST_CASE("There is evidence for a tube, a line and a strip, not for scattered points")
{
  constexpr double radius = 0.1, spacing = 0.025;
  constexpr int around = 24, along = 60;
  Patches tube, line, strip, scattered;
  for(int k = 0; k < along; ++k) {
    const Vector3 on_axis = (k - along / 2) * spacing * Vector3::UnitZ();
    for(int l = 0; l < around; ++l) {
      const double angle = 2 * CGAL_PI * l / around;
      const Vector3 outward(std::cos(angle), std::sin(angle), 0);
      tube.push_back(patch_at(on_axis + radius * outward, outward, spacing));
    }
    line.push_back(patch_at(on_axis, Vector3::UnitX(), spacing));
    for(int l = -2; l <= 2; ++l) // one side of a wire
      strip.push_back(patch_at(on_axis + l * spacing * Vector3::UnitY(), Vector3::UnitX(), spacing));
  }
  const unsigned int seed = GENERATE(1u, 2u, 3u);
  CAPTURE(seed);
  std::mt19937 random(seed);
  const auto number = [&] { return static_cast<double>(random()) / 4294967296.0 - 0.5; };
  for(int k = 0; k < 3000; ++k) {
    const double x = number(), y = number(), z = number(), u = number(), v = number();
    scattered.push_back(patch_at({x, y, z}, {u, v, number()}, 0.07));
  }
  constexpr double most = 0.5; // what the options ask of a loop
  const Vector3 origin = Vector3::Zero();
  CHECK(evidence_near(origin, 1.1 * radius, tube, radius) > 0.8);
  CHECK(evidence_near(origin, 2.5 * spacing, line, 0) > 0.5);
  CHECK(evidence_near(origin, 2.1 * spacing, strip, 0) > 0.5);
  CHECK(evidence_near(origin, 2.1 * spacing, strip, 0, Strip::leaf) < 0.5);
  CHECK(evidence_near(origin, 0.15, scattered, radius) < most);
}

TEST_CASE("Half the width of a tube is its radius; of a strip it is half its width in the mean")
{
  constexpr double radius = 0.1;
  constexpr std::size_t number = 24;
  Patches ring, strip;
  Samples on_axis, on_strip;
  std::vector<std::size_t> members;
  for(std::size_t k = 0; k < number; ++k) {
    const double angle = 2 * CGAL_PI * static_cast<double>(k) / number;
    const Vector3 outward(std::cos(angle), std::sin(angle), 0);
    ring.push_back(patch_at(radius * outward, outward, 0.025));
    on_axis.push_back({Vector3::Zero(), radius});
    const double across = radius * (2 * (static_cast<double>(k) + 0.5) / number - 1);
    strip.push_back(patch_at({across, 0, 0}, Vector3::UnitZ(), 0.01));
    on_strip.push_back({strip.back().mean, 0});
    members.push_back(k);
  }
  CHECK(middle(members, ring, on_axis).half_width == Approx(radius));
  CHECK(middle(members, strip, on_strip).half_width == Approx(radius / 2).epsilon(0.01));
}

TEST_CASE("A loop is named in its order, from whichever vertex")
{
  Skeleton_graph graph = polygon(7, 1);
  graph.vertices.resize(9);
  graph.edges.emplace_back(2, 7); // a limb
  graph.edges.emplace_back(7, 8);
  for(std::size_t last = 0; last < 7; ++last) {
    CAPTURE(last);
    Loop_search loops(graph.vertices.size());
    for(std::size_t e = 0; e < graph.edges.size(); ++e)
      if(e != last) {
        CHECK(loops.closed_by(graph.edges[e]).empty());
        loops.add(graph.edges[e]);
      }
    const Loop loop = loops.closed_by(graph.edges[last]);
    CHECK(loop.size() == 7);
    visit_edges(loop, [&](std::size_t v, std::size_t w) { CHECK(has_edge(graph, v, w)); });
    CHECK(evidence_along(loop, graph).length() == Approx(14 * std::sin(CGAL_PI / 7)));
  }
}

TEST_CASE("An edge beside a long loop is asked first for the short one that it closes")
{
  Skeleton_graph graph = polygon(40, 1);
  graph.vertices.resize(41);
  graph.vertices[40].evidence = 0.9;
  graph.edges.emplace_back(0, 40); // a detour around vertex 1
  graph.edges.emplace_back(40, 2);
  std::vector<std::size_t> sizes;
  with_loops_opened(graph, evidence_of(graph), [&](const Loop& loop) {
    sizes.push_back(loop.size());
    return true;
  });
  CHECK(sizes == std::vector<std::size_t>{40, 4, 40});
}

TEST_CASE("A loop is opened where its evidence is least")
{
  Skeleton_graph graph = polygon(10, 0.4);
  graph.vertices[6].evidence = 0.1;
  const Skeleton_graph opened = opened_below(graph, 0.5);
  CHECK(opened.edges.size() == 9);
  CHECK(has_edge(opened, 5, 6) != has_edge(opened, 6, 7));
}

TEST_CASE("A loop with enough evidence stays, though one place has none; a tree has no loop")
{
  Skeleton_graph graph = polygon(10, 0.9);
  graph.vertices[6].evidence = 0;
  CHECK(opened_below(graph, 0.5).edges.size() == 10);
  CHECK(opened_below(graph, infinity).edges.size() == 9);
}

TEST_CASE("A loop has room for a hole if it is wider than its limbs and than gaps, in any unit")
{
  constexpr std::size_t size = 40;
  const double unit = GENERATE(1e-3, 1.0, 1e3);
  CAPTURE(unit);
  // Limbs along a closed curve, for each number from 0 to 1 the place at that share of it.
  const auto has_room = [&](double radius, const auto& place, double spacing = 0) {
    Skeleton_graph graph = polygon(size, 1);
    Loop loop;
    for(std::size_t v = 0; v < size; ++v) {
      graph.vertices[v].position =
        unit * place(2 * CGAL_PI * static_cast<double>(v) / static_cast<double>(size));
      graph.vertices[v].is_cross_section = v % 2 == 0;
      graph.vertices[v].radius = v % 2 == 0 ? unit * radius : 100 * unit; // of a body
      graph.vertices[v].half_width = 100 * unit; // of a sheet
      graph.vertices[v].resolution = unit * spacing;
      loop.push_back(v);
    }
    return room_for_hole(loop, graph) >= 1;
  };
  const auto circle = [](double t) { return Vector3(std::cos(t), std::sin(t), 0); };
  CHECK(has_room(0.9, circle));
  CHECK_FALSE(has_room(1.1, circle));
  CHECK(has_room(0, circle, 0.5));
  CHECK_FALSE(has_room(0, circle, 0.8)); // such gaps there are between points
  const auto slot = [](double t) { return Vector3(10 * std::cos(t), std::sin(t), 0); };
  CHECK(has_room(0.9, slot));
  const auto eight = [](double t) {
    return Vector3(std::cos(t), std::sin(2 * t), 0.2 * std::sin(t));
  };
  CHECK(has_room(0.3, eight));
  const auto to_and_fro = [](double t) { return Vector3(std::cos(t), 0.01 * std::sin(t), 0); };
  CHECK_FALSE(has_room(0.3, to_and_fro));
  const auto around_and_back = [](double t) -> Vector3 {
    const double angle = 2 * std::cos(t);
    return (1 + 0.01 * std::sin(t)) * Vector3(std::cos(angle), std::sin(angle), 0);
  };
  CHECK_FALSE(has_room(0.3, around_and_back)); // however the limb bends
}

TEST_CASE("The less of a loop in a tree was seen from all sides, the wider its hole must be")
{
  constexpr std::size_t size = 40;
  const double unseen = GENERATE(0.0, 0.1, 0.2, 0.3, 0.4, 0.45, 0.6, 1.0); // share of the loop
  const double radius = GENERATE(0.05, 0.3, 0.7, 1.2);
  CAPTURE(unseen, radius);
  Skeleton_graph graph = polygon(size, 0.9);
  Loop loop(size);
  std::iota(loop.begin(), loop.end(), std::size_t(0));
  for(std::size_t v : loop) {
    graph.vertices[v].is_cross_section = true;
    graph.vertices[v].radius = radius;
    graph.vertices[v].open = static_cast<double>(v) < unseen * size ? 1 : 0;
  }
  const auto is_kept = [&](Limb_reading reading, double least_evidence = 0.5) {
    return is_loop(loop, graph, reading, least_evidence);
  };
  CHECK(is_kept(Limb_reading::frame) == (radius < 1));
  CHECK(is_kept(Limb_reading::tree) == (radius < 1 - 2 * unseen));
  CHECK_FALSE(is_kept(Limb_reading::known_tree));
  CHECK_FALSE(is_kept(Limb_reading::frame, 0.95));
}

TEST_CASE("Between two loops are the edges of one of them, if they make a loop")
{
  const auto between = [](const Loop& a, const Loop& b) {
    Known_loops known;
    known.add(b);
    return known.beside(a);
  };
  const Loop square = {0, 1, 2, 3};
  CHECK(between(square, square).empty());
  CHECK(between(square, {4, 5, 6}).empty()); // nothing in common
  CHECK(between(square, {0, 4, 5}).empty()); // only a vertex
  CHECK(between({0, 1, 2, 3, 4, 5}, {0, 1, 6, 3, 4, 7}).empty()); // two squares
  const std::vector<Loop> found = between(square, {5, 4, 0, 1});
  REQUIRE(found.size() == 1);
  const std::vector<Skeleton_graph::Edge> expected = {{0, 3}, {0, 4}, {1, 2},
                                                      {1, 5}, {2, 3}, {4, 5}};
  CHECK(sorted_edges(found[0]) == expected);
}

TEST_CASE("Two ways through one limb around a hole are one loop, two limbs are two")
{
  constexpr std::size_t size = 40;
  for(const double inner : {0.95, 0.3}) { // of the second way, along half of the first
    CAPTURE(inner);
    Skeleton_graph graph = polygon(size, 1);
    const std::size_t from = size / 4, to = 3 * size / 4;
    std::size_t last = from;
    for(std::size_t v = from + 1; v < to; ++v) {
      graph.vertices.push_back({inner * graph.vertices[v].position});
      graph.vertices.back().evidence = 0.9;
      graph.edges.emplace_back(last, graph.vertices.size() - 1);
      last = graph.vertices.size() - 1;
    }
    graph.edges.emplace_back(last, to);
    for(auto& vertex : graph.vertices) {
      vertex.is_cross_section = true;
      vertex.radius = 0.2;
    }
    const Skeleton_graph opened = with_loops_opened(
      graph, evidence_of(graph), [&](const Loop& loop) { return room_for_hole(loop, graph) >= 1; });
    CHECK(graph.edges.size() - opened.edges.size() == (inner > 0.5 ? 1 : 0));
  }
}

TEST_CASE("Of two ways through one limb the one that is no more than a thread is opened")
{
  // Two vertices beside each other between 0 and 2. One of them has a single component.
  Surface_quotient quotient;
  quotient.graph = polygon(10, 0.8);
  quotient.graph.vertices.push_back(quotient.graph.vertices[1]);
  quotient.graph.vertices[1].evidence = 0.7;
  quotient.graph.edges.emplace_back(0, 10);
  quotient.graph.edges.emplace_back(10, 2);
  Patches patches(11);
  for(std::size_t v = 0; v < patches.size(); ++v) {
    quotient.graph.vertices[v].is_cross_section = true;
    quotient.members.push_back({v});
    patches[v].components = v == 10 ? 1 : 20;
  }
  const auto opened = [&] {
    return with_loops_opened(quotient.graph,
                             strengths(quotient.graph, components_of(quotient, patches), 6),
                             [](const Loop& loop) { return loop.size() > 4; });
  };
  CHECK(opened().edges.size() == 11);
  CHECK(has_edge(opened(), 0, 1));
  CHECK(has_edge(opened(), 1, 2));
  quotient.graph.vertices[10].is_on_line = true; // there, no limb has more
  CHECK(has_edge(opened(), 0, 10));
  CHECK(has_edge(opened(), 10, 2));
}

TEST_CASE("Points across, between limbs that were seen from all sides, close no loop")
{
  // Two limbs side by side; vertex 5 is between their ends, 11 between the other ones.
  Skeleton_graph graph;
  graph.vertices.resize(12);
  for(std::size_t k = 0; k < 5; ++k) {
    graph.vertices[k].position = {0, 4 - static_cast<double>(k), 0};
    graph.vertices[6 + k].position = {2, static_cast<double>(k), 0};
  }
  graph.vertices[5].position = {1, 0, 0};
  graph.vertices[11].position = {1, 4, 0};
  for(auto& vertex : graph.vertices)
    vertex.is_cross_section = true;
  Loop loop(graph.vertices.size());
  std::iota(loop.begin(), loop.end(), std::size_t(0));
  const std::vector<double> tube(graph.vertices.size(), 20), wire(graph.vertices.size(), 1);
  const Curve_options options;
  const auto is_row = [&](const Skeleton_graph& shape, const std::vector<double>& components) {
    return leads_through_row(loop, shape, components, options);
  };
  for(std::size_t start = 0; start < loop.size(); ++start) { // wherever the loop begins
    CAPTURE(loop.front());
    CHECK_FALSE(is_row(graph, tube));
    CHECK_FALSE(is_row(graph, wire)); // nothing tells a limb from what is between

    std::vector<double> components = tube;
    components[2] = 1; // the way along one limb
    CHECK_FALSE(is_row(graph, components));
    components = tube;
    components[5] = 3; // a strip
    CHECK_FALSE(is_row(graph, components));
    components[5] = 1;
    CHECK(is_row(graph, components));
    components[4] = components[6] = 3; // a longer row, a single point in the middle
    CHECK(is_row(graph, components));
    components[5] = 3;
    components[6] = 1; // at its end
    CHECK(is_row(graph, components));

    components = tube;
    components[5] = 1;
    Skeleton_graph other = graph;
    other.vertices[4].open = 1;
    CHECK(is_row(other, components));
    other.vertices[6].open = 1; // both limbs may have been seen in part only
    CHECK_FALSE(is_row(other, components));

    other = graph;
    other.vertices[5].is_on_line = true;
    CHECK_FALSE(is_row(other, components));
    other = graph;
    other.vertices[5].is_cross_section = false; // a piece may be small
    CHECK_FALSE(is_row(other, components));
    std::rotate(loop.begin(), loop.begin() + 1, loop.end());
  }
}

TEST_CASE("Of two loops with a common side each is judged alone, and all stays connected")
{
  // Vertices 0 to 9 around, and a path 0, 10, 5 across: the loop on the side of 1 to 4 is weak.
  Skeleton_graph graph = polygon(10, 1);
  graph.vertices.push_back(graph.vertices.front());
  graph.edges.emplace_back(0, 10);
  graph.edges.emplace_back(10, 5);
  for(std::size_t v = 1; v < 5; ++v)
    graph.vertices[v].evidence = 0.1;
  const Skeleton_graph opened = opened_below(graph, 0.8);
  CHECK(opened.edges.size() == graph.edges.size() - 1);
  for(std::size_t v = 5; v < 10; ++v)
    CHECK(has_edge(opened, v, (v + 1) % 10));
  Union_find parts(opened.vertices.size());
  for(const Skeleton_graph::Edge& e : opened.edges)
    parts.join(e.first, e.second);
  for(std::size_t v = 0; v < 11; ++v)
    CHECK(parts.find(v) == parts.find(0));
}

} // namespace open_loops_test
