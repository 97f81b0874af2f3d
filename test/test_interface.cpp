// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Ranges, property maps and named parameters of the free functions.

#include "catch2.h"
#include "shapes.h"
#include "skeleton_checks.h"

#include <CGAL/extract_l1_medial_skeleton.h>
#include <CGAL/fit_gaussian_mixture.h>
#include <CGAL/project_to_l1_medians.h>

#include <CGAL/Point_set_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/range/irange.hpp>
#include <boost/range/iterator_range.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

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
  static const Points points = shapes::to_points<Kernel>(shapes::sample(shapes::cylinder(), 1500, 31));
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
  const Skeleton published = skeleton_of(cloud(), parameters::as_published(true));

  CHECK(have_same_bits(
    published, skeleton_of(cloud(), parameters::as_published(
                                      true, parameters::point_map(map).callback(count)))));
  CHECK(calls > 0);
  CHECK(have_same_bits(
    published, skeleton_of(cloud(), parameters::as_published(true).random_seed(0).point_map(map))));
  CHECK(have_same_bits(expected(), skeleton_of(cloud(), parameters::as_published(false))));
  CHECK_FALSE(have_same_bits(expected(), published));
}

TEST_CASE("A mixture has the mass, mean and level sizes of its points")
{
  const auto mixture = CGAL::fit_gaussian_mixture(cloud());
  REQUIRE(!mixture.levels.empty());
  for(std::size_t k = 0; k < mixture.levels.size(); ++k) {
    CAPTURE(k);
    double mass = 0;
    shapes::Vector sum = shapes::Vector::Zero(), mean = shapes::Vector::Zero();
    for(const auto& c : mixture.levels[k]) {
      mass += c.weight;
      sum += c.weight * shapes::to_vector(c.mean);
    }
    for(const Point& p : cloud())
      mean += shapes::to_vector(p) / static_cast<double>(cloud().size());
    CHECK(mass == Approx(static_cast<double>(cloud().size())));
    CHECK((sum / mass - mean).norm() < 1e-12);
    if(k > 0)
      CHECK(mixture.levels[k].size() <= mixture.levels[k - 1].size());
  }
  CHECK(CGAL::fit_gaussian_mixture(Points()).levels.empty());
  const std::function<bool(double)> cancel = [](double) { return false; };
  CHECK(CGAL::fit_gaussian_mixture(cloud(), parameters::callback(cancel)).levels.empty());
}

TEST_CASE("Projected components move inwards from where they were")
{
  const auto mixture = CGAL::fit_gaussian_mixture(cloud());
  std::vector<CGAL::Medial_sample_3<Kernel>> samples(3);
  REQUIRE(CGAL::project_to_l1_medians(mixture, samples));
  REQUIRE(samples.size() == mixture.levels.front().size());
  const shapes::Shape shape = shapes::cylinder();
  std::size_t inside = 0;
  for(std::size_t i = 0; i < samples.size(); ++i) {
    const shapes::Vector mean = shapes::to_vector(mixture.levels.front()[i].mean);
    REQUIRE((shapes::to_vector(samples[i].origin) - mean).norm() < 1e-12);
    REQUIRE(samples[i].kernel_radius > 0);
    inside += shapes::distance_to_axes(shape, shapes::to_vector(samples[i].point)) < 0.03;
  }
  CHECK(inside > samples.size() * 9 / 10); // a tenth of the width around the axis

  const std::size_t size = samples.size();
  const std::function<bool(double)> cancel = [](double) { return false; };
  CHECK_FALSE(CGAL::project_to_l1_medians(mixture, samples, parameters::callback(cancel)));
  CHECK(samples.size() == size);
  CHECK(CGAL::project_to_l1_medians(CGAL::Gaussian_mixture_3<Kernel>(), samples));
  CHECK(samples.empty());
}
