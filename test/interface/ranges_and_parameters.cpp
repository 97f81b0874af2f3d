// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Ranges, property maps and named parameters of the free functions.

#include "catch2.h"
#include "graph_counts.h"
#include "shapes.h"
#include "skeleton_checks.h"

#include <CGAL/extract_l1_medial_skeleton.h>
#include <CGAL/extract_published_l1_medial_skeleton.h>

#include <CGAL/Point_set_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/range/irange.hpp>
#include <boost/range/iterator_range.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace ranges_and_parameters_test {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Skeleton = CGAL::Curve_skeleton_3<Kernel>;
using Points = std::vector<Point>;
namespace parameters = CGAL::parameters;

namespace {

// The points of an index, for ranges of indices.
struct Point_of_index
{
  using key_type = std::size_t;
  using value_type = Point;
  using reference = const Point&;
  using category = boost::readable_property_map_tag;

  const Points* points;
  friend const Point& get(const Point_of_index& map, std::size_t i) { return (*map.points)[i]; }
};

const Points& cloud()
{
  static const Points points =
    shapes::to_points<Kernel>(shapes::sample(shapes::cylinder(), 1500, 31));
  return points;
}

template <typename Range, typename NamedParameters>
Skeleton skeleton_of(const Range& range, const NamedParameters& np)
{
  Skeleton skeleton;
  REQUIRE(CGAL::extract_l1_medial_skeleton(range, skeleton, np));
  check_valid(skeleton, cloud().size());
  return skeleton;
}

// What a vertex of a graph of one's own may be.
struct Bare_vertex
{
  Kernel::Point_3 point{0, 0, 0};
  double radius = 0;
};

template <typename Index>
struct Vertex_of_points : Bare_vertex
{
  std::vector<Index> indices;
};

template <typename Vertex>
using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, Vertex>;

const Skeleton& expected()
{
  static const Skeleton skeleton = skeleton_of(cloud(), parameters::default_values());
  return skeleton;
}

} // namespace

TEST_CASE("A vector of points needs no parameter and is not changed")
{
  const Points copy = cloud();
  Skeleton skeleton;
  CHECK(CGAL::extract_l1_medial_skeleton(copy, skeleton));
  CHECK(copy == cloud());
  CHECK(num_vertices(skeleton) > 0);
  CHECK(have_same_bits(skeleton, expected()));
}

TEST_CASE("A point set hands its maps over")
{
  CGAL::Point_set_3<Point> points;
  for(const Point& p : cloud())
    points.insert(p);
  CHECK(have_same_bits(skeleton_of(points, points.parameters()), expected()));
}

TEST_CASE("Pairs of a point and something else")
{
  std::vector<std::pair<Point, int>> pairs;
  for(const Point& p : cloud())
    pairs.emplace_back(p, static_cast<int>(pairs.size()));
  const CGAL::First_of_pair_property_map<std::pair<Point, int>> map;
  CHECK(have_same_bits(skeleton_of(pairs, parameters::point_map(map)), expected()));
}

TEST_CASE("A range of indices, which has no points of its own")
{
  const auto indices = boost::irange(std::size_t(0), cloud().size());
  const Point_of_index map{&cloud()};
  const auto np = parameters::point_map(map).geom_traits(Kernel());
  CHECK(have_same_bits(skeleton_of(indices, np), expected()));
}

TEST_CASE("An output that is not empty is replaced")
{
  Skeleton skeleton(1000);
  add_edge(3, 4, skeleton);
  CHECK(CGAL::extract_l1_medial_skeleton(cloud(), skeleton));
  CHECK(have_same_bits(skeleton, expected()));
}

TEST_CASE("A graph whose vertices have no indices, or narrow ones")
{
  Graph<Bare_vertex> bare;
  Graph<Vertex_of_points<std::uint16_t>> narrow;
  REQUIRE(CGAL::extract_l1_medial_skeleton(cloud(), bare));
  REQUIRE(CGAL::extract_l1_medial_skeleton(cloud(), narrow));
  Skeleton from_bare(num_vertices(bare)), from_narrow(num_vertices(narrow));
  REQUIRE(num_vertices(bare) == num_vertices(expected()));
  REQUIRE(num_vertices(narrow) == num_vertices(expected()));
  for(const auto v : boost::make_iterator_range(vertices(expected()))) {
    from_bare[v] = {bare[v].point, bare[v].radius, expected()[v].indices};
    from_narrow[v] = {narrow[v].point, narrow[v].radius,
                      {narrow[v].indices.begin(), narrow[v].indices.end()}};
  }
  for(const auto e : boost::make_iterator_range(edges(bare)))
    add_edge(source(e, bare), target(e, bare), from_bare);
  for(const auto e : boost::make_iterator_range(edges(narrow)))
    add_edge(source(e, narrow), target(e, narrow), from_narrow);
  CHECK(have_same_bits(from_bare, expected()));
  CHECK(have_same_bits(from_narrow, expected()));
}

TEST_CASE("Indices that are too narrow for the points")
{
  const auto indices_fit = [](std::size_t size) {
    const Points points(cloud().begin(), cloud().begin() + static_cast<std::ptrdiff_t>(size));
    Graph<Vertex_of_points<std::int8_t>> graph(1);
    graph[0].radius = 7;
    try {
      CGAL::extract_l1_medial_skeleton(points, graph);
    } catch(const std::length_error& error) {
      CHECK(std::string(error.what()).find("129 points") != std::string::npos);
      CHECK((num_vertices(graph) == 1 && graph[0].radius == 7));
      return false;
    }
    return true;
  };
  CHECK(indices_fit(128));
  CHECK(!indices_fit(129));
}

TEST_CASE("Named parameters chain, the package's own in front")
{
  std::size_t calls = 0;
  const std::function<bool(double)> count = [&](double) { return ++calls > 0; };
  const CGAL::Identity_property_map<Point> map;
  const Points two_parts =
    shapes::to_points<Kernel>(shapes::sample(shapes::two_parts(), 3000, 32));
  const auto of_two_parts = [&](const auto& np) {
    Skeleton skeleton;
    REQUIRE(CGAL::extract_l1_medial_skeleton(two_parts, skeleton, np));
    return skeleton;
  };
  const Skeleton single = of_two_parts(parameters::single_component(true));
  CHECK(have_same_bits(single, of_two_parts(parameters::single_component(
                                 true, parameters::point_map(map).callback(count)))));
  CHECK(calls > 0);
  CHECK(have_same_bits(single,
                       of_two_parts(parameters::single_component(true).point_map(map))));
  const Skeleton apart = of_two_parts(parameters::default_values());
  CHECK(have_same_bits(apart, of_two_parts(parameters::single_component(false))));
  CHECK_FALSE(have_same_bits(apart, single));
}

TEST_CASE("A shape known to be a tree becomes one")
{
  const auto corner = [](int k) {
    return shapes::Vector(std::cos(k * shapes::pi / 3), std::sin(k * shapes::pi / 3), 0);
  };
  shapes::Shape hexagon;
  for(int k = 0; k < 6; ++k)
    hexagon.push_back({corner(k), corner(k + 1), 0.1});
  const Points points = shapes::to_points<Kernel>(shapes::sample(hexagon, 6000, 32));
  Skeleton as_seen, tree;
  REQUIRE(CGAL::extract_l1_medial_skeleton(points, as_seen));
  REQUIRE(CGAL::extract_l1_medial_skeleton(
    points, tree, parameters::single_component(true, parameters::is_tree(true))));
  CHECK(count_graph(as_seen).cycles > 0);
  CHECK(count_graph(tree).cycles == 0);
  CHECK(count_graph(tree).components == 1);
}

TEST_CASE("The parameters of the published method chain as well, and each changes the result")
{
  const auto published = [](const auto& np) {
    Skeleton skeleton;
    REQUIRE(CGAL::extract_published_l1_medial_skeleton(cloud(), skeleton, np));
    check_valid(skeleton, cloud().size());
    return skeleton;
  };
  const CGAL::Identity_property_map<Point> map;
  const Skeleton by_default = published(parameters::default_values());
  const auto defaults = parameters::number_of_iterations(30).random_seed(0).point_map(map);
  CHECK(have_same_bits(by_default, published(defaults)));
  CHECK_FALSE(have_same_bits(by_default, published(parameters::random_seed(1))));
  CHECK_FALSE(have_same_bits(by_default, published(parameters::number_of_iterations(3))));

  using namespace parameters::published;
  const auto seed = parameters::random_seed(0);
  const auto explicitly =
    mu(0.2, delta_h(0.5, alpha(2.2, levels(3, flatness(0.3, sample_flatness(0.3, seed))))));
  CHECK(have_same_bits(by_default, published(explicitly)));
  CHECK(have_same_bits(by_default, published(alpha_min(90, b_min(5, d_max(0.15, seed))))));
  CHECK(have_same_bits(by_default, published(mu(std::nullopt, tuned(false, halt(false))))));
  CHECK(have_same_bits(by_default,
                       published(samples(500, h_0(2 / std::cbrt(double(cloud().size())))))));
  const auto check_changes = [&](const auto& np) {
    CHECK_FALSE(have_same_bits(by_default, published(np)));
  };
  check_changes(mu(0.4));
  check_changes(h_0(0.3));
  check_changes(delta_h(0.1));
  check_changes(halt(true));
  check_changes(samples(200));
  check_changes(alpha(1.5));
  check_changes(levels(2));
  check_changes(flatness(0.1));
  check_changes(sample_flatness(0.02));
  check_changes(alpha_min(170));
  check_changes(b_min(20));
  check_changes(d_max(0.01));
  check_changes(tuned(true));
  CHECK(have_same_bits(
    published(tuned(true)),
    published(delta_h(
      1.0 / 3, sample_flatness(0.05, alpha_min(120, parameters::number_of_iterations(60)))))));
}

TEST_CASE("The merging links of the published method are marked, where a graph has a place for it")
{
  // Two cylinders apart: one link, much longer than the edges of the branches.
  const Points points =
    shapes::to_points<Kernel>(shapes::sample(shapes::two_parts(), 3000, 32));
  Skeleton skeleton, by_default;
  REQUIRE(CGAL::extract_published_l1_medial_skeleton(points, skeleton));
  double longest = 0, longest_bridge = 0;
  std::size_t bridges = 0;
  for(const auto e : boost::make_iterator_range(edges(skeleton))) {
    const double squared = CGAL::squared_distance(skeleton[source(e, skeleton)].point,
                                                  skeleton[target(e, skeleton)].point);
    bridges += skeleton[e].is_bridge ? 1 : 0;
    double& greatest = skeleton[e].is_bridge ? longest_bridge : longest;
    greatest = std::max(greatest, squared);
  }
  CHECK(bridges >= 1);
  CHECK(bridges < num_edges(skeleton));
  CHECK(longest_bridge > 4 * longest);
  REQUIRE(CGAL::extract_l1_medial_skeleton(points, by_default));
  for(const auto e : boost::make_iterator_range(edges(by_default)))
    CHECK_FALSE(by_default[e].is_bridge);
}

TEST_CASE("The published method takes any range with a point map, and any graph")
{
  std::vector<std::pair<Point, int>> pairs;
  for(const Point& p : cloud())
    pairs.emplace_back(p, 7);
  Skeleton plain;
  Graph<Bare_vertex> bare;
  REQUIRE(CGAL::extract_published_l1_medial_skeleton(cloud(), plain));
  REQUIRE(CGAL::extract_published_l1_medial_skeleton(
    pairs, bare,
    parameters::point_map(CGAL::First_of_pair_property_map<std::pair<Point, int>>())));
  REQUIRE(num_vertices(bare) == num_vertices(plain));
  for(const auto v : boost::make_iterator_range(vertices(plain)))
    CHECK(bare[v].point == plain[v].point);
}

} // namespace ranges_and_parameters_test
