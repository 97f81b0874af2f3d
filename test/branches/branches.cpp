// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Branches partition the edges, and their measures are those of known curves.

#include "catch2.h"

#include "graph_counts.h"
#include "shapes.h"

#include <CGAL/Curve_skeleton_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/extract_l1_medial_skeleton.h>
#include <CGAL/skeleton_branches.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/range/iterator_range.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <random>
#include <utility>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Skeleton = CGAL::Curve_skeleton_3<Kernel>;
using Branch = CGAL::Skeleton_branch_of<Skeleton>;
using Path = std::vector<std::size_t>;

namespace {

Skeleton make(const std::vector<Point>& points, const std::vector<std::pair<int, int>>& edges,
              double radius = 0.1)
{
  Skeleton skeleton;
  for(const Point& p : points) {
    const auto v = add_vertex(skeleton);
    skeleton[v].point = p;
    skeleton[v].radius = radius;
  }
  for(const auto& [v, w] : edges)
    add_edge(static_cast<std::size_t>(v), static_cast<std::size_t>(w), skeleton);
  return skeleton;
}

// A trunk 0-1-2-3 along z, a limb 1-4-5 along x with a twig 4-6 up, numbered from the top down.
Skeleton tree()
{
  return make({{0, 0, 0}, {0, 0, 2}, {0, 0, 4}, {0, 0, 8}, {1, 0, 2}, {3, 0, 2}, {1, 0, 3}},
              {{3, 2}, {1, 2}, {4, 1}, {0, 1}, {5, 4}, {4, 6}});
}

// Every edge in exactly one branch, parents first and ending where children start, measures that
// add up.
void check_branches(const Skeleton& skeleton, const std::vector<Branch>& branches)
{
  std::map<std::pair<std::size_t, std::size_t>, int> edges_left;
  for(const auto e : boost::make_iterator_range(edges(skeleton))) {
    const std::size_t s = source(e, skeleton), t = target(e, skeleton);
    ++edges_left[std::minmax(s, t)];
  }
  std::size_t closing = 0;
  for(std::size_t b = 0; b < branches.size(); ++b) {
    const Branch& branch = branches[b];
    double length = 0;
    for(std::size_t i = 1; i < branch.vertices.size(); ++i) {
      const std::size_t s = branch.vertices[i - 1], t = branch.vertices[i];
      REQUIRE(--edges_left[std::minmax(s, t)] >= 0);
      length += std::sqrt(CGAL::squared_distance(skeleton[s].point, skeleton[t].point));
    }
    CHECK(branch.length == Approx(length));
    CHECK(branch.chord <= Approx(branch.length));
    closing += branch.closes_cycle ? 1 : 0;
    if(branch.parent == Branch::none) {
      CHECK(branch.order == 0);
      CHECK(std::isnan(branch.angle));
      continue;
    }
    REQUIRE(branch.parent < b);
    const Branch& parent = branches[branch.parent];
    CHECK(parent.vertices.back() == branch.vertices.front());
    CHECK(!parent.closes_cycle);
    CHECK(branch.order == parent.order + (branch.axis == parent.axis ? 0 : 1));
  }
  for(const auto& edge : edges_left)
    CHECK(edge.second == 0);
  CHECK(CGAL::branch_of_vertices(branches).size() == num_vertices(skeleton));
  CHECK(closing == count_graph(skeleton).cycles);
}

} // namespace

TEST_CASE("branches of a tree, from its foot")
{
  const Skeleton skeleton = tree();
  const auto branches = CGAL::skeleton_branches(skeleton);
  check_branches(skeleton, branches);
  REQUIRE(branches.size() == 5);
  CHECK(branches[0].vertices == Path{0, 1});
  CHECK(branches[1].vertices == Path{1, 4});
  CHECK(branches[2].vertices == Path{4, 6});
  CHECK(branches[3].vertices == Path{4, 5});
  CHECK(branches[4].vertices == Path{1, 2, 3});
  const std::vector<std::size_t> orders{0, 1, 2, 1, 0}, axes{0, 1, 2, 1, 0};
  for(std::size_t b = 0; b < 5; ++b) {
    CHECK(branches[b].order == orders[b]);
    CHECK(branches[b].axis == axes[b]);
  }
  CHECK(branches[1].angle == Approx(90));
  CHECK(branches[2].angle == Approx(90));
  CHECK(branches[3].angle == Approx(0).margin(1e-9));
  CHECK(branches[4].angle == Approx(0).margin(1e-9));
  const auto branch_of = CGAL::branch_of_vertices(branches);
  CHECK(branch_of.at(1) == 0);
  CHECK(branch_of.at(4) == 1);
  CHECK(branch_of.at(2) == 4);
}

TEST_CASE("another root turns the branches around")
{
  const Skeleton skeleton = tree();
  const auto from_twig = CGAL::skeleton_branches(skeleton, {6});
  check_branches(skeleton, from_twig);
  CHECK(from_twig[0].vertices == Path{6, 4});
  CHECK(from_twig[0].parent == Branch::none);
  // A root inside a branch divides it; both parts start there.
  const auto from_inside = CGAL::skeleton_branches(skeleton, {2});
  check_branches(skeleton, from_inside);
  REQUIRE(from_inside.size() == 6);
  CHECK(from_inside[0].vertices == Path{2, 1});
  CHECK(from_inside[0].axis == 0);
  CHECK(std::count_if(from_inside.begin(), from_inside.end(), [](const Branch& branch) {
          return branch.vertices.front() == 2 && branch.parent == Branch::none;
        }) == 2);
}

TEST_CASE("the measures are those of a cone and of an arc")
{
  Skeleton cone = make({{0, 0, 0}, {0, 0, 1}, {0, 0, 3}}, {{0, 1}, {1, 2}});
  cone[0].radius = 3;
  cone[1].radius = 2;
  cone[2].radius = 0;
  const Branch branch = CGAL::skeleton_branches(cone).at(0);
  CHECK(branch.volume == Approx(CGAL_PI * 9 * 3 / 3));
  CHECK(branch.mean_radius == Approx(1.5));
  CHECK(branch.length == 3);

  Skeleton arc;
  const int n = 1000;
  for(int i = 0; i <= n; ++i)
    arc[add_vertex(arc)].point = Point(std::cos(i * CGAL_PI / n), 0, std::sin(i * CGAL_PI / n));
  for(std::size_t i = 0; i < n; ++i)
    add_edge(i, i + 1, arc);
  const Branch half_circle = CGAL::skeleton_branches(arc).at(0);
  CHECK(half_circle.length == Approx(CGAL_PI));
  CHECK(half_circle.chord == Approx(2));
}

TEST_CASE("an angle is measured outside the parent")
{
  // The limb leaves at 45 degrees, but its first edge inside the parent is square to it.
  Skeleton skeleton = make({{0, 0, 0}, {0, 0, 10}, {0, 0, 20}, {0.1, 0, 10}, {10.1, 0, 20}},
                           {{0, 1}, {1, 2}, {1, 3}, {3, 4}}, 1);
  for(const Branch& branch : CGAL::skeleton_branches(skeleton))
    if(branch.vertices.back() == 4)
      CHECK(branch.angle == Approx(45).margin(2));
}

TEST_CASE("an angle is measured where limbs that part sharply are free of each other")
{
  // At 10 degrees, the path of the trunk goes aside over the last six radii before the junction.
  Skeleton skeleton = make({{0, 0, 0}, {0, 0, 30}, {0.5, 0, 36}, {0, 0, 37}, {0, 0, 60},
                            {1.05, 0, 36.1}, {5.28, 0, 60}},
                           {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {2, 5}, {5, 6}}, 1);
  for(const Branch& branch : CGAL::skeleton_branches(skeleton))
    if(branch.parent != Branch::none)
      CHECK(branch.angle == Approx(branch.vertices.back() == 6 ? 10 : 0).margin(0.5));
}

TEST_CASE("the angles of limbs on a trunk are those they were made with")
{
  const unsigned int seed = 5;
  CAPTURE(seed);
  for(const double radius : {0.2, 0.35})
    for(const double angle : {15., 20., 30., 60., 90.}) {
      CAPTURE(radius, angle);
      const double a = angle * CGAL_PI / 180;
      const shapes::Vector start(0, 0, 4), along(std::sin(a), 0, std::cos(a));
      const shapes::Shape shape{{shapes::Vector(0, 0, 0), shapes::Vector(0, 0, 12), 0.5},
                                {start, start + 6 * along, radius}};
      Skeleton skeleton;
      CGAL::extract_l1_medial_skeleton(
          shapes::to_points<Kernel>(shapes::sample(shape, 40000, seed)), skeleton);
      const auto branches = CGAL::skeleton_branches(skeleton);
      REQUIRE(branches.size() == 3);
      for(const Branch& branch : branches)
        if(branch.parent != Branch::none) {
          const bool is_limb = skeleton[branch.vertices.back()].point.x() > 0.7;
          CHECK(branch.angle == Approx(is_limb ? angle : 0).margin(2.5));
        }
    }
}

TEST_CASE("a cycle is one closed branch, or is closed by one branch")
{
  const Skeleton ring =
      make({{1, 0, 0}, {0, 0, 1}, {-1, 0, 0}, {0, 0, -1}}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}});
  const auto branches = CGAL::skeleton_branches(ring);
  check_branches(ring, branches);
  REQUIRE(branches.size() == 1);
  CHECK(branches[0].closes_cycle);
  CHECK(branches[0].vertices.front() == 3);
  CHECK(branches[0].vertices.back() == 3);
  CHECK(branches[0].vertices.size() == 5);
  CHECK(branches[0].chord == 0);

  // A theta with a foot: of the three ways from 1 to 2, two close a cycle.
  const Skeleton theta = make({{0, 0, 0}, {0, 0, 1}, {0, 0, 3}, {1, 0, 2}, {-2, 0, 2}, {0, 0, 2}},
                              {{0, 1}, {1, 3}, {3, 2}, {1, 4}, {4, 2}, {1, 5}, {5, 2}});
  const auto ways = CGAL::skeleton_branches(theta);
  check_branches(theta, ways);
  REQUIRE(ways.size() == 4);
  CHECK(ways[1].vertices == Path{1, 5, 2});
  CHECK(!ways[1].closes_cycle);
  CHECK(ways[1].order == 0);
  for(std::size_t b : {2, 3}) {
    CHECK(ways[b].closes_cycle);
    CHECK(ways[b].vertices.front() == 1);
    CHECK(ways[b].parent == 0);
    CHECK(ways[b].order == 1);
  }
  // A loop at a junction.
  const Skeleton loop =
      make({{0, 0, 0}, {0, 0, 1}, {1, 0, 2}, {-1, 0, 2}}, {{0, 1}, {1, 2}, {2, 3}, {3, 1}});
  const auto two = CGAL::skeleton_branches(loop);
  check_branches(loop, two);
  REQUIRE(two.size() == 2);
  CHECK(two[1].closes_cycle);
  CHECK(two[1].vertices.size() == 4);
}

TEST_CASE("lone vertices, several components, nothing at all")
{
  CHECK(CGAL::skeleton_branches(Skeleton()).empty());
  const Skeleton skeleton = make({{5, 5, 5}, {0, 0, 1}, {0, 0, 0}, {1, 0, 0}}, {{1, 2}});
  const auto branches = CGAL::skeleton_branches(skeleton);
  check_branches(skeleton, branches);
  REQUIRE(branches.size() == 3);
  for(const Branch& branch : branches)
    CHECK(branch.parent == Branch::none);
  CHECK(CGAL::lowest_vertices(skeleton) == Path{0, 2, 3});
}

TEST_CASE("the lowest and the thickest vertices are ends")
{
  Skeleton skeleton = tree();
  CHECK(CGAL::lowest_vertices(skeleton) == Path{0});
  CHECK(CGAL::lowest_vertices(skeleton, 0) == Path{0});
  skeleton[2].radius = 9; // inside a branch
  skeleton[5].radius = 1;
  CHECK(CGAL::thickest_vertices(skeleton) == Path{5});
}

TEST_CASE("random graphs are divided into branches, whatever holds their vertices")
{
  const unsigned int seed = 7;
  CAPTURE(seed);
  std::mt19937 random(seed);
  for(int round = 0; round < 200; ++round) {
    const std::size_t n = 1 + random() % 30, m = random() % 40;
    Skeleton skeleton;
    for(std::size_t i = 0; i < n; ++i)
      skeleton[add_vertex(skeleton)].point =
          Point(double(random() % 9), double(random() % 9), double(random() % 9));
    for(std::size_t i = 0; i < m; ++i) {
      const std::size_t v = random() % n, w = random() % n;
      if(v != w && !edge(v, w, skeleton).second)
        add_edge(v, w, skeleton);
    }
    const auto branches = CGAL::skeleton_branches(skeleton);
    check_branches(skeleton, branches);

    using Lists = boost::adjacency_list<boost::listS, boost::listS, boost::undirectedS,
                                        CGAL::Curve_skeleton_vertex_3<Kernel>>;
    Lists lists;
    std::vector<Lists::vertex_descriptor> vertex;
    for(std::size_t v = 0; v < n; ++v)
      vertex.push_back(add_vertex(skeleton[v], lists));
    for(const auto e : boost::make_iterator_range(edges(skeleton)))
      add_edge(vertex[source(e, skeleton)], vertex[target(e, skeleton)], lists);
    CHECK(CGAL::skeleton_branches(lists).size() == branches.size());
  }
}
