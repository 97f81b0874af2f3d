// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What holds for any points: hundreds of random clouds of many kinds.

#include "both_methods.h"
#include "catch2.h"
#include "graph_counts.h"
#include "skeleton_checks.h"
#include "skeleton_invariants.h"

#include <CGAL/L1_medial_skeletonization_3.h>
#include <CGAL/Published_l1_medial_skeletonization_3.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace properties_test {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Points = std::vector<Point>;
using Skeleton = CGAL::Curve_skeleton_3<Kernel>;

namespace {

// Random numbers that are the same everywhere, as those of <random>'s distributions need not be.
class Source
{
public:
  explicit Source(unsigned int seed)
      : engine_(seed)
  {}

  double uniform(double least = 0, double greatest = 1)
  {
    return least + (greatest - least) * static_cast<double>(engine_()) / 4294967296.;
  }

  // About normal: by the central limit theorem.
  double normal(double deviation)
  {
    double sum = 0;
    for(int i = 0; i < 12; ++i)
      sum += uniform() - 0.5;
    return deviation * sum;
  }

  Vector in_cube() { return {uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)}; }

  Vector direction()
  {
    for(;;) {
      const Vector d = in_cube();
      if(const double length = d.squared_length(); length > 0.01 && length < 1)
        return d / std::sqrt(length);
    }
  }

  Vector noise(double deviation)
  {
    return {normal(deviation), normal(deviation), normal(deviation)};
  }

private:
  std::mt19937 engine_;
};

// A point on a tube around a curve.
Point on_tube(const Vector& centre, const Vector& along, double radius, double angle)
{
  const Vector some = std::abs(along.x()) < 0.7 * std::sqrt(along.squared_length())
                          ? Vector(1, 0, 0)
                          : Vector(0, 1, 0);
  Vector u = CGAL::cross_product(along, some);
  u = u / std::sqrt(u.squared_length());
  Vector v = CGAL::cross_product(along, u);
  v = v / std::sqrt(v.squared_length());
  return CGAL::ORIGIN + centre + radius * (std::cos(angle) * u + std::sin(angle) * v);
}

Point on_sphere(Source& source, const Vector& centre, double radius)
{
  return CGAL::ORIGIN + centre + radius * source.direction();
}

constexpr double turn = 6.283185307179586;

// A kind of clouds: its i-th point, of n.
struct Kind
{
  std::string name;
  std::function<Point(Source&, std::size_t, std::size_t)> point;
};

std::vector<Kind> kinds()
{
  const auto tube = [](Source& s, double noise) {
    const double z = s.uniform(-3, 3);
    return on_tube({0, 0, z}, {0, 0, 1}, 0.3, s.uniform(0, turn)) + s.noise(noise);
  };
  const auto ring = [](Source& s) {
    const double t = s.uniform(0, turn);
    return on_tube({std::cos(t), std::sin(t), 0}, {-std::sin(t), std::cos(t), 0}, 0.2,
                   s.uniform(0, turn));
  };
  return {
      {"ball",
       [](Source& s, auto, auto) {
         return on_sphere(s, {0, 0, 0}, std::cbrt(s.uniform()));
       }},
      {"sphere",
       [](Source& s, auto, auto) {
         return on_sphere(s, {0, 0, 0}, 1);
       }},
      {"cube", [](Source& s, auto, auto) { return CGAL::ORIGIN + s.in_cube(); }},
      {"tube", [=](Source& s, auto, auto) { return tube(s, 0); }},
      {"noisy tube", [=](Source& s, auto, auto) { return tube(s, 0.05); }},
      {"drowned tube", [=](Source& s, auto, auto) { return tube(s, 0.3); }},
      {"ring", [=](Source& s, auto, auto) { return ring(s); }},
      {"line", [](Source& s, auto, auto) { return CGAL::ORIGIN + s.uniform() * Vector(1, 2, 3); }},
      {"curve",
       [](Source& s, auto, auto) {
         const double t = s.uniform(0, turn);
         return Point(std::cos(t), std::sin(2 * t), std::sin(3 * t));
       }},
      {"plane", [](Source& s, auto, auto) { return Point(s.uniform(), s.uniform(), 0); }},
      {"wave",
       [](Source& s, auto, auto) {
         const double x = s.uniform(0, 9), y = s.uniform(0, 9);
         return Point(x, y, std::sin(x) * std::sin(y));
       }},
      {"same", [](Source&, auto, auto) { return Point(1, 2, 3); }},
      {"lattice",
       [](Source& s, auto, auto) {
         return Point(std::floor(s.uniform(0, 9)), std::floor(s.uniform(0, 9)),
                      std::floor(s.uniform(0, 9)));
       }},
      {"two",
       [](Source& s, auto, auto) {
         return on_sphere(s, {s.uniform() < 0.5 ? 0. : 9., 0, 0}, 1);
       }},
      {"clusters",
       [](Source& s, std::size_t i, auto) {
         const double t = static_cast<double>(i % 17);
         return Point(std::cos(3 * t), std::sin(5 * t), t / 5) + s.noise(0.01);
       }},
      {"outliers",
       [=](Source& s, auto, auto) {
         return s.uniform() < 0.05 ? CGAL::ORIGIN + 4 * s.in_cube() : ring(s);
       }},
      {"far",
       [=](Source& s, std::size_t i, std::size_t n) {
         return i < n / 1000 ? CGAL::ORIGIN + std::pow(10, s.uniform(1, 250)) * s.direction()
                             : ring(s);
       }},
      {"scales",
       [](Source& s, auto, auto) {
         return CGAL::ORIGIN + std::pow(10, s.uniform(-9, 0)) * s.direction();
       }},
      {"half scan",
       [=](Source& s, auto, auto) {
         const Point p = ring(s);
         return p.z() < 0 ? Point(p.x(), p.y(), -p.z()) : p;
       }},
      {"cross",
       [](Source& s, auto, auto) {
         const double t = s.uniform(-3, 3);
         const bool along_x = s.uniform() < 0.5;
         return on_tube(along_x ? Vector(t, 0, 0) : Vector(0, t, 0),
                        along_x ? Vector(1, 0, 0) : Vector(0, 1, 0), 0.2, s.uniform(0, turn));
       }},
      {"spiral",
       [](Source& s, auto, auto) {
         const double t = s.uniform(0, 4 * turn);
         return on_tube({t * std::cos(t), t * std::sin(t), 0},
                        {std::cos(t) - t * std::sin(t), std::sin(t) + t * std::cos(t), 0.01}, 1,
                        s.uniform(0, turn));
       }},
      {"largest",
       [](Source& s, auto, auto) {
         const double t = s.uniform(0, turn);
         return Point(1.7e308 * std::cos(t), 1.7e308 * std::sin(t), 1.7e308 * s.uniform(-1, 1));
       }},
      {"denormal", [](Source& s, auto, auto) { return CGAL::ORIGIN + 1e-318 * s.in_cube(); }},
      {"UTM", [=](Source& s, auto, auto) { return ring(s) + Vector(512345.25, 5412345.5, 312); }},
  };
}

Points cloud(const Kind& kind, std::size_t size, unsigned int seed)
{
  Source source(seed);
  Points points;
  for(std::size_t i = 0; i < size; ++i)
    points.push_back(kind.point(source, i, size));
  return points;
}

std::size_t number_of_indices(const Skeleton& skeleton)
{
  std::size_t result = 0;
  for(const auto v : boost::make_iterator_range(vertices(skeleton)))
    result += skeleton[v].indices.size();
  return result;
}

struct Result
{
  Skeleton skeleton;
  std::size_t outliers = 0;
};

using Default_method = CGAL::L1_medial_skeletonization_3<Kernel>;
using Published_method = CGAL::Published_l1_medial_skeletonization_3<Kernel>;

template <typename Method = Default_method>
Result result_of(const Points& points)
{
  Result result;
  Method steps(points);
  steps.run();
  steps.extract_skeleton(result.skeleton);
  result.outliers = steps.number_of_outliers();
  return result;
}

std::vector<std::size_t> topology(const Points& points)
{
  const Graph_counts counts = count_graph(result_of(points).skeleton);
  return {counts.components, counts.cycles, counts.ends, counts.junctions};
}

} // namespace

TEST_CASE("Any points have a possible skeleton, the same for any number of threads")
{
  for(const Kind& kind : kinds())
    for(const std::size_t size : {0u, 1u, 2u, 3u, 10u, 100u, 300u, 1000u, 1500u, 3000u})
      for(unsigned int repetition = 0; repetition < (size > 500 ? 1u : 3u); ++repetition) {
        const auto seed = static_cast<unsigned int>(1000 * repetition + size);
        CAPTURE(kind.name, size, seed);
        const Points points = cloud(kind, size, seed);
        const Result result = result_of(points);
        CHECK(wrong_with(result.skeleton, points) == "");
        CHECK((num_vertices(result.skeleton) > 0) == (size > 0));
        CHECK(number_of_indices(result.skeleton) + result.outliers == size);
        using Parallel =
          CGAL::L1_medial_skeletonization_3<Kernel, CGAL::Parallel_if_available_tag>;
        CHECK(have_same_bits(result.skeleton, result_of<Parallel>(points).skeleton));
      }
}

TEST_CASE("Any points have a possible skeleton by the published method")
{
  for(const Kind& kind : kinds())
    for(const std::size_t size : {1u, 3u, 50u, 600u}) {
      CAPTURE(kind.name, size);
      const Points points = cloud(kind, size, 7);
      Skeleton skeleton;
      CHECK(extract(true, points, skeleton));
      CHECK(wrong_with(skeleton, points) == "");
    }
}

TEST_CASE("Order, place and unit of the points do not change the topology")
{
  // Clouds in general position, that have one.
  for(const Kind& kind : kinds())
    if(kind.name == "tube" || kind.name == "ring" || kind.name == "two" || kind.name == "cross")
      for(unsigned int seed = 1; seed <= 5; ++seed) {
        CAPTURE(kind.name, seed);
        const Points points = cloud(kind, 4000, seed);
        const std::vector<std::size_t> expected = topology(points);
        Points shuffled = points;
        std::mt19937 engine(seed);
        for(std::size_t i = shuffled.size(); i > 1; --i)
          std::swap(shuffled[i - 1], shuffled[engine() % i]);
        CHECK(topology(shuffled) == expected);
        for(const double unit : {1e-250, 1. / 1024, 3., 1e250}) {
          CAPTURE(unit);
          Points scaled;
          for(const Point& p : points)
            scaled.emplace_back(unit * p.x(), unit * p.y(), unit * p.z());
          CHECK(topology(scaled) == expected);
        }
        Points moved;
        for(const Point& p : points)
          moved.push_back(p + Vector(1024, -4096, 512));
        CHECK(topology(moved) == expected);
      }
}

TEMPLATE_TEST_CASE("Far points change nothing but the number of outliers", "", Default_method,
                   Published_method)
{
  const auto all = kinds();
  for(const Kind& kind : all)
    if(kind.name == "noisy tube" || kind.name == "ring" || kind.name == "cross" ||
       kind.name == "UTM") {
      const Points points = cloud(kind, 5000, 11);
      const Result expected = result_of<TestType>(points);
      CHECK(number_of_indices(expected.skeleton) + expected.outliers == points.size());
      for(const double distance : {40., 1e3, 1e9, 1e100, 1e308})
        for(const std::size_t far : {1u, 5u})
          for(const bool in_one_place : {false, true}) {
            CAPTURE(kind.name, distance, far, in_one_place);
            Source source(3);
            Points more = points;
            const Vector place = distance * source.direction();
            while(more.size() < points.size() + far)
              more.push_back(CGAL::ORIGIN + (in_one_place ? place : distance * source.direction()));
            if(kind.name == "UTM" && distance < 1e8)
              continue; // its points are that far from the origin themselves
            const Result found = result_of<TestType>(more);
            CHECK(have_same_bits(found.skeleton, expected.skeleton));
            CHECK(found.outliers == expected.outliers + far);
          }
    }
}

TEST_CASE("The indices of points are those of the input, whatever lies far away between them")
{
  const auto all = kinds();
  const Kind& tube = *std::find_if(all.begin(), all.end(),
                                   [](const Kind& kind) { return kind.name == "tube"; });
  const Points points = cloud(tube, 3000, 2);
  Points more = points;
  more.insert(more.begin() + 1000, Point(1e9, 0, 0));
  more.insert(more.begin(), Point(0, -1e9, 0));
  const Result expected = result_of<Published_method>(points),
               found = result_of<Published_method>(more);
  REQUIRE(found.outliers == 2);
  REQUIRE(num_vertices(found.skeleton) == num_vertices(expected.skeleton));
  for(const auto v : boost::make_iterator_range(vertices(found.skeleton))) {
    auto shifted = expected.skeleton[v].indices;
    for(auto& index : shifted)
      index += index < 1000 ? 1 : 2;
    CHECK(found.skeleton[v].indices == shifted);
  }
}

TEST_CASE("A mast of few points is no outlier")
{
  Source source(5);
  Points points;
  for(int i = 0; i < 100000; ++i) {
    const double t = source.uniform(0, turn);
    points.push_back(on_tube({std::cos(t), std::sin(t), 0}, {-std::sin(t), std::cos(t), 0}, 0.2,
                             source.uniform(0, turn)));
  }
  for(int i = 0; i < 100; ++i)
    points.emplace_back(1 + 0.05 * i, 0.001 * source.normal(1), 0);
  CGAL::L1_medial_skeletonization_3<Kernel> steps(points);
  REQUIRE(steps.fit_mixture());
  CHECK(steps.mixture().bbox.xmax() == points.back().x());
}

TEST_CASE("Limits: what comes out is defined")
{
  // A point of each kind that has no curve skeleton is a vertex.
  const auto all = kinds();
  const auto of = [&all](const std::string& name) {
    return *std::find_if(all.begin(), all.end(), [&](const Kind& k) { return k.name == name; });
  };
  const Result same = result_of(cloud(of("same"), 100000, 1));
  REQUIRE(num_vertices(same.skeleton) == 1);
  CHECK(same.skeleton[0].point == Point(1, 2, 3));
  CHECK(same.skeleton[0].radius == 0);
  CHECK(number_of_indices(same.skeleton) == 100000);

  // No part of these is long compared with its thickness.
  for(const std::string name : {"sphere", "plane", "ball", "cube"}) {
    CAPTURE(name);
    const Skeleton skeleton = result_of(cloud(of(name), 20000, 1)).skeleton;
    CHECK(num_vertices(skeleton) == 1);
    CHECK(num_edges(skeleton) == 0);
  }

  // The second of two parts, with its rows of points: less than a hundredth is dropped.
  Source source(1);
  Points two = cloud(of("tube"), 20000, 1);
  const std::size_t tube = two.size();
  for(std::size_t i = 0; i < 150; ++i)
    two.push_back(on_sphere(source, {3, 0, 0}, 0.1));
  const Result one = result_of(two);
  CHECK(count_graph(one.skeleton).components == 1);
  CHECK(one.outliers >= two.size() - tube);
}

TEST_CASE("The running time can be limited")
{
  const Points points = cloud(kinds().back(), 20000, 1);
  for(const bool published : {false, true}) {
    Skeleton skeleton(3);
    CHECK_FALSE(extract(published, points, skeleton, CGAL::parameters::maximum_running_time(1e-6)));
    CHECK(num_vertices(skeleton) == 3);
    CHECK(extract(published, points, skeleton, CGAL::parameters::maximum_running_time(1e6)));
    CHECK(num_vertices(skeleton) > 3);
  }
}

} // namespace properties_test
