// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What is pruned, on random graphs: the same as if all branches were measured anew for each that is
// removed.

#include "catch2.h"

#include <CGAL/Point_set_skeletonization_3/internal/core/Union_find.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Curve_options.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Skeleton_graph.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Spur_pruning.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Surface_parts.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/branches.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/prune.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/surface_quotient.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch_graph.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <set>
#include <vector>

namespace spur_pruning_test {

using namespace CGAL::Point_set_skeletonization_3::internal;

namespace {

using Points = std::vector<std::vector<Vector3>>;

/// A graph without parallel edges whose branches are short, and points around its vertices.
struct Random_graph
{
  explicit Random_graph(unsigned int seed)
  {
    std::mt19937 random(seed);
    const auto below = [&](std::size_t end) {
      return std::uniform_int_distribution<std::size_t>(0, end - 1)(random);
    };
    std::normal_distribution<double> normal;
    const auto vector = [&] { return Vector3(normal(random), normal(random), normal(random)); };
    constexpr std::size_t size = 60;
    std::set<Skeleton_graph::Edge> edges;
    const auto add = [&](std::size_t v, std::size_t w) {
      if(v != w && edges.insert(std::minmax(v, w)).second)
        graph.edges.emplace_back(v, w);
    };
    for(std::size_t v = 0; v < size; ++v) {
      const std::size_t kind = below(8); // no cross-section, one, or one on a line
      graph.vertices.push_back({vector(), 1, 0.1, kind > 2, kind > 5});
      points.emplace_back();
      for(std::size_t k = below(9); k > 0; --k)
        points.back().push_back(graph.vertices[v].position + vector());
      if(v > 0 && below(20) != 0) // chains and forks of a few parts
        add(below(3) == 0 ? below(v) : v - 1, v);
    }
    for(std::size_t k = below(12); k > 0; --k)
      add(below(size), below(size));
    std::shuffle(graph.edges.begin(), graph.edges.end(), random);
  }

  Skeleton_graph graph;
  Points points;
};

/// From the `k`-th vertex of a branch to the points of it and of those before `end`.
std::vector<Vector3> offsets(const Random_graph& input, const Branch& branch, std::size_t k,
                             std::size_t end)
{
  std::vector<Vector3> result;
  for(std::size_t l = k; l < end; ++l)
    for(const Vector3& p : input.points[branch[l]])
      result.push_back(p - input.graph.vertices[branch[k]].position);
  return result;
}

double slenderness(const Random_graph& input, const Branch& branch, double least_points)
{
  double result = 0;
  for(std::size_t k = 1; k < branch.size(); ++k) {
    const Skeleton_graph::Vertex& vertex = input.graph.vertices[branch[k]];
    if(!vertex.is_cross_section || input.points[branch[k]].empty())
      continue;
    const std::vector<Vector3> beyond = offsets(input, branch, k, branch.size());
    Vector3 sum = Vector3::Zero();
    for(const Vector3& p : beyond)
      sum += p;
    const Vector3 way = vertex.position - input.graph.vertices[branch[k - 1]].position;
    const Vector3 axis = (way + sum / static_cast<double>(beyond.size())).normalized();
    std::vector<double> lengths;
    for(const Vector3& p : beyond)
      lengths.push_back(p.norm());
    std::sort(lengths.begin(), lengths.end());
    double width = half_a_spacing * vertex.resolution;
    const std::vector<Vector3> ring = offsets(input, branch, k, k + 1);
    const bool is_plane = static_cast<double>(ring.size()) >= least_points;
    for(const Vector3& p : ring)
      width = std::max(width, is_plane ? p.norm() : p.cross(axis).norm());
    const std::size_t last = lengths.size() - 1;
    const std::size_t outliers = vertex.is_on_line ? 1 : 2;
    const std::size_t furthest = std::min(last, std::max(outliers, last / 20));
    result = std::max(result, lengths[last - furthest] / width);
  }
  return result;
}

/// The graph without the vertices that were removed, and the inside of a branch.
std::size_t number_of_components(const Skeleton_graph& graph, const Branch& without = {})
{
  Union_find sets(graph.vertices.size());
  std::size_t result = graph.vertices.size();
  for(const Skeleton_graph::Edge& e : graph.edges) {
    const auto is_inside = [&](std::size_t v) {
      return !without.empty() &&
             std::find(without.begin() + 1, without.end() - 1, v) != without.end() - 1;
    };
    if(!is_inside(e.first) && !is_inside(e.second))
      result -= sets.join(e.first, e.second) ? 1 : 0;
  }
  return result;
}

std::vector<bool> spurs_one_by_one(const Random_graph& input, const Curve_options& options)
{
  std::vector<bool> removed(input.graph.vertices.size(), false);
  for(;;) {
    Skeleton_graph rest = input.graph;
    rest.edges.clear();
    for(const Skeleton_graph::Edge& e : input.graph.edges)
      if(!removed[e.first] && !removed[e.second])
        rest.edges.push_back(e);
    const auto adjacency = rest.adjacency();
    double least = options.slenderness;
    Branch spur;
    for(Branch branch : branches(rest)) {
      if(adjacency[branch.front()].size() == 1)
        std::reverse(branch.begin(), branch.end());
      if(adjacency[branch.front()].size() < 3)
        continue;
      const bool has_tip = adjacency[branch.back()].size() == 1;
      std::size_t points = 0;
      bool is_on_line = false;
      for(std::size_t k = 1; k + (has_tip ? 0 : 1) < branch.size(); ++k) {
        points += input.points[branch[k]].size();
        is_on_line = is_on_line || input.graph.vertices[branch[k]].is_on_line;
      }
      const std::size_t at_ends =
        std::min(input.points[branch.front()].size(), input.points[branch.back()].size());
      const Skeleton_graph::Vertex &first = input.graph.vertices[branch.front()],
                                   &last = input.graph.vertices[branch.back()];
      const double in_row = // points of a row between the ends
        2 * (first.position - last.position).norm() / (first.resolution + last.resolution);
      const bool is_thin = !is_on_line &&
                           static_cast<double>(points) < options.least_points &&
                           (has_tip || (points < at_ends && static_cast<double>(points) < in_row));
      // Without the inside of a bridge, that is isolated and the rest in one part more.
      const std::size_t inside = branch.size() - 2;
      if(!has_tip &&
         (!is_thin || inside == 0 ||
          number_of_components(rest, branch) != number_of_components(rest) + inside))
        continue;
      const double s = is_thin ? 0 : slenderness(input, branch, options.least_points);
      if(s < least) {
        least = s;
        spur = branch;
      }
    }
    if(spur.empty())
      return removed;
    for(std::size_t k = 1; k < spur.size(); ++k)
      removed[spur[k]] = adjacency[spur[k]].size() < 3;
  }
}

} // namespace

TEST_CASE("The same branches are pruned as one by one, the least slender of all first")
{
  std::size_t removed = 0, kept = 0, opened = 0;
  for(unsigned int seed = 1; seed <= 300; ++seed) {
    CAPTURE(seed);
    const Random_graph input(seed);
    Curve_options options;
    options.least_points = seed % 2 == 0 ? 6 : 12;
    const std::vector<bool> expected = spurs_one_by_one(input, options);
    const std::vector<bool> spurs = Spur_pruning(input.graph, input.points, options).spurs();
    REQUIRE(spurs == expected);
    const auto number = static_cast<std::size_t>(std::count(spurs.begin(), spurs.end(), true));
    removed += number;
    kept += spurs.size() - number;
    // Junctions of both ends stay where a cycle is opened.
    for(const Branch& branch : branches(input.graph))
      opened += branch.size() > 2 && spurs[branch[1]] && !spurs[branch.front()] &&
                !spurs[branch.back()];
  }
  CHECK(removed > 0);
  CHECK(kept > 0);
  CHECK(opened > 0);
}

TEST_CASE("A few points between two limbs are a part of a limb if these have no more, or in a row")
{
  constexpr std::size_t length = 12, joint = 6;
  const auto is_kept = [&](std::size_t points_of_limbs, double gap) {
    Skeleton_graph graph; // two limbs side by side, and a vertex between their middles
    for(std::size_t k = 0; k < 2 * length + 1; ++k) {
      const double x = static_cast<double>(k % length);
      graph.vertices.push_back({Vector3(x, k < length ? 0 : gap, 0), 1, 1, true});
      if(k % length != 0)
        graph.edges.emplace_back(k - 1, k);
    }
    const std::size_t between = 2 * length;
    graph.vertices[between].position = Vector3(joint, gap / 2, 0);
    graph.edges.emplace_back(joint, between);
    graph.edges.emplace_back(between, length + joint);
    graph.edges.emplace_back(0, length); // a detour: without it, nothing is removed
    Points points;
    for(const Skeleton_graph::Vertex& vertex : graph.vertices)
      points.emplace_back(points_of_limbs, vertex.position + Vector3(0, 0, 0.5));
    points[between].resize(std::min<std::size_t>(3, points_of_limbs));
    return !Spur_pruning(graph, points, Curve_options()).spurs()[between];
  };
  CHECK(is_kept(2, 4));
  CHECK(is_kept(3, 4));
  CHECK_FALSE(is_kept(4, 4)); // three points, four spacings from middle to middle
  CHECK_FALSE(is_kept(12, 4));
  CHECK(is_kept(4, 2));
  CHECK(is_kept(12, 2));
}

TEST_CASE("A twig of single points is a limb if it is long compared with their distance")
{
  const auto is_kept = [](double step) {
    Skeleton_graph graph; // a limb with rings of six points, and a twig in its middle
    Points points;
    constexpr std::size_t length = 13, joint = 6, twig = 8;
    constexpr double spacing = 1, fifth_neighbor = 2.5;
    for(std::size_t k = 0; k < length; ++k) {
      graph.vertices.push_back({Vector3(static_cast<double>(k), 0, 0), 1, spacing, true});
      points.emplace_back(6, graph.vertices.back().position + Vector3(0, 0, 0.5));
      if(k > 0)
        graph.edges.emplace_back(k - 1, k);
    }
    for(std::size_t k = 0; k < twig; ++k) {
      const Vector3 place(joint, 1 + step * static_cast<double>(k), 0);
      graph.vertices.push_back({place, 0, fifth_neighbor, true});
      points.push_back({place});
      graph.edges.emplace_back(k == 0 ? joint : length + k - 1, length + k);
    }
    return !Spur_pruning(graph, points, Curve_options()).spurs()[length + twig / 2];
  };
  CHECK(is_kept(1));
  CHECK_FALSE(is_kept(0.1)); // all of them within half a spacing
}

TEST_CASE("A twig of three points is a limb, also where none of them shows a line")
{
  const auto is_kept = [](std::size_t twig, bool are_single, bool is_line_seen) {
    Skeleton_graph graph; // two twigs of many points, and one in their middle
    Points points;
    constexpr std::size_t length = 13, joint = 6;
    const auto add = [&](const Vector3& place, std::size_t from, bool is_cross_section) {
      const std::size_t v = graph.vertices.size();
      graph.vertices.push_back({place, 0, 2.5, is_cross_section || are_single, are_single});
      points.push_back({place});
      if(v > 0)
        graph.edges.emplace_back(from, v);
    };
    for(std::size_t k = 0; k < length; ++k)
      add(Vector3(static_cast<double>(k), 0, 0), k - 1, true);
    for(std::size_t k = 0; k < twig; ++k)
      add(Vector3(joint, static_cast<double>(k) + 1, 0), k == 0 ? joint : length + k - 1,
          is_line_seen && k == twig / 2);
    return !Spur_pruning(graph, points, Curve_options()).spurs()[length];
  };
  for(const bool is_line_seen : {true, false}) {
    CHECK(is_kept(3, true, is_line_seen));
    CHECK_FALSE(is_kept(2, true, is_line_seen)); // one of them may be an outlier
    CHECK_FALSE(is_kept(3, false, is_line_seen)); // fewer than go around a limb
  }
}

TEST_CASE("A ring of a few points counts by its width across the limb, one of many by any")
{
  const auto is_kept = [](double width, int points_a_side) {
    Skeleton_graph graph; // a limb along x, and another one along y in its middle
    Points points;
    constexpr std::size_t length = 13, joint = 6, across = 2;
    for(std::size_t k = 0; k < length; ++k) {
      graph.vertices.push_back({Vector3(static_cast<double>(k), 0, 0), 1, 1, true});
      points.emplace_back(6, graph.vertices.back().position + Vector3(0, 0, 0.5));
      if(k > 0)
        graph.edges.emplace_back(k - 1, k);
    }
    for(std::size_t k = 0; k < across; ++k) {
      const Vector3 middle(joint, 2 * static_cast<double>(k) + 1, 0);
      graph.vertices.push_back({middle, 1, 1, true});
      points.emplace_back();
      for(int n = 0; n < points_a_side; ++n)
        for(const double side : {-1., 1.})
          points.back().push_back(middle + Vector3(0, n % 2 == 0 ? -10 : 10, side * width));
      graph.edges.emplace_back(k == 0 ? joint : length, length + k);
    }
    return !Spur_pruning(graph, points, Curve_options()).spurs()[length];
  };
  CHECK(is_kept(0.2, 2));
  CHECK_FALSE(is_kept(20, 2)); // wider than long
  CHECK_FALSE(is_kept(0.2, 4));
}

TEST_CASE("Of twigs of one place, what sticks out of the limb is kept, not what is along it")
{
  constexpr unsigned int seed = 7;
  CAPTURE(seed);
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  for(int turn = 0; turn < 20; ++turn) { // rounding does not decide
    CAPTURE(turn);
    const Eigen::Quaterniond rotation =
      Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random))
        .normalized();
    const auto is_kept = [&](const Vector3& direction) {
      Skeleton_graph graph; // a limb of single points, and in its middle a place of three
      Points points;
      constexpr std::size_t length = 13, joint = 6;
      for(std::size_t k = 0; k < length; ++k) {
        graph.vertices.push_back(
          {rotation * Vector3(static_cast<double>(k), 0, 0), 0, 1, true, true});
        points.push_back({graph.vertices.back().position});
        if(k > 0)
          graph.edges.emplace_back(k - 1, k);
      }
      const Vector3 middle(joint, 1, 0);
      graph.vertices.push_back({rotation * middle, 0, 1, true, true});
      points.emplace_back();
      for(const double side : {-1., 0., 1.})
        points.back().push_back(rotation * (middle + side * direction));
      graph.edges.emplace_back(joint, length);
      return !Spur_pruning(graph, points, Curve_options()).spurs()[length];
    };
    CHECK(is_kept(Vector3(0, 0.7, 0)));
    CHECK_FALSE(is_kept(Vector3(0.7, 0, 0)));
    CHECK_FALSE(is_kept(Vector3(0, 0, 0.7)));
  }
}

TEST_CASE("A stub is a spur, unless it is all that is left of a part of the surface")
{
  constexpr std::size_t length = 20, none = Surface_parts::none;
  const auto ring_around = [](const Vector3& middle, double radius) {
    std::vector<Vector3> result;
    for(int k = 0; k < 12; ++k)
      result.push_back(middle + radius * Vector3(0, std::cos(k), std::sin(k)));
    return result;
  };
  Skeleton_graph graph;
  Points points;
  const auto add = [&](const Vector3& place, double radius, std::size_t before) {
    graph.vertices.push_back({place, radius, 0.1, true});
    points.push_back(ring_around(place, radius));
    if(before != none)
      graph.edges.emplace_back(before, graph.vertices.size() - 1);
  };
  for(std::size_t k = 0; k < length; ++k)
    add(Vector3(static_cast<double>(k), 0, 0), 1, k == 0 ? none : k - 1);
  const std::size_t joint = length / 2, stub = length;
  add(graph.vertices[joint].position + Vector3(0, 1.5, 0), 1, joint);
  add(graph.vertices[joint].position + Vector3(0, 1.6, 0), 1, stub);
  const auto is_kept = [&](const std::vector<std::size_t>& parts_of_stub) {
    std::vector<std::size_t> part(length, 0);
    part.insert(part.end(), parts_of_stub.begin(), parts_of_stub.end());
    return !Spur_pruning(graph, points, Curve_options(), {}, Surface_parts(part)).spurs()[stub];
  };
  CHECK_FALSE(is_kept({0, 0}));
  CHECK_FALSE(is_kept({none, none}));
  CHECK(is_kept({1, 1}));
  CHECK(is_kept({0, 1}));
  CHECK(is_kept({1, none}));
}

TEST_CASE("Adjacent patches are in one part of the surface, those of few points in none")
{
  constexpr std::uint32_t size = 12;
  Patches patches(size);
  Surface_quotient quotient;
  quotient.graph.vertices.resize(size);
  std::vector<Patch_pair> pairs;
  std::uint32_t begin = 0;
  for(const std::uint32_t end : {6u, 10u, size}) { // of the parts
    for(std::uint32_t i = begin; i < end; ++i) {
      patches[i].weight = end == size ? 1 : 50;
      quotient.vertex_of_patch.push_back(i);
      if(i > begin)
        pairs.push_back({i - 1, i});
    }
    begin = end;
  }
  Surface_parts parts = surface_parts(quotient, patches, pairs, 0.01);
  CHECK(parts.are_last({6, 7, 8, 9}));
  CHECK_FALSE(parts.are_last({0, 1, 6, 7, 8}));
  CHECK_FALSE(parts.are_last({10, 11}));
  for(const std::size_t v : {6, 7})
    parts.remove(v);
  CHECK(parts.are_last({8, 9, 10}));
  CHECK(surface_parts(quotient, patches, pairs, 0.005).are_last({10, 11}));
}

TEST_CASE("A cap is removed, unless it is all of a part of the surface")
{
  Skeleton_graph graph;
  for(const bool is_cross_section : {true, true, false})
    graph.vertices.push_back({Vector3::Zero(), 1, 1, is_cross_section});
  graph.edges = {{0, 1}, {1, 2}};
  for(const std::size_t part : {0, 1}) {
    std::vector<bool> removed(3, false);
    mark_caps(graph, Surface_parts({0, 0, part}), removed);
    CHECK(removed == std::vector<bool>({false, false, part == 0}));
  }
}

TEST_CASE("Of two caps that are all of a part of the surface, one is left")
{
  Skeleton_graph graph;
  for(const bool is_cross_section : {false, true, true, false})
    graph.vertices.push_back({Vector3::Zero(), 1, 1, is_cross_section});
  graph.edges = {{0, 1}, {1, 2}, {2, 3}};
  std::vector<bool> removed(4, false);
  mark_caps(graph, Surface_parts({1, 0, 0, 1}), removed);
  CHECK(std::count(removed.begin(), removed.end(), true) == 1);
}

TEST_CASE("A graph without edges has no spurs")
{
  Skeleton_graph graph;
  graph.vertices.resize(3);
  CHECK(Spur_pruning(graph, Points(3), Curve_options()).spurs() == std::vector<bool>(3, false));
  CHECK(Spur_pruning(Skeleton_graph(), Points(), Curve_options()).spurs().empty());
}

} // namespace spur_pruning_test
