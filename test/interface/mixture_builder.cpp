// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Points that come in chunks give what they give all at once.

#include "catch2.h"
#include "generator/Random.h"
#include "shapes.h"
#include "skeleton_checks.h"

#include <CGAL/Bulk_bbox_3.h>
#include <CGAL/Gaussian_mixture_builder_3.h>
#include <CGAL/L1_medial_skeletonization_3.h>
#include <CGAL/extract_l1_medial_skeleton.h>
#include <CGAL/fit_gaussian_mixture.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/bounding_box.h>
#include <CGAL/property_map.h>

#include <boost/graph/connected_components.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace mixture_builder_test {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Points = std::vector<Point>;
using Builder = CGAL::Gaussian_mixture_builder_3<Kernel>;
using Mixture = CGAL::Gaussian_mixture_3<Kernel>;
using Component = Mixture::Component;
using Skeleton = CGAL::Curve_skeleton_3<Kernel>;

namespace {

// Far from the origin, to be harder. Its cells outnumber any bound, so that they are merged again
// and again; more points than are added up at a time.
Points full_box()
{
  constexpr std::size_t size = 300000;
  shapes::Random random(3);
  Points points;
  while(points.size() < size) {
    const shapes::Vector p = random.uniform_vector();
    points.emplace_back(500000 + 40 * p.x(), 5e6 + 30 * p.y(), std::pow(p.z(), 3));
  }
  return points;
}

const Points& points()
{
  static const Points result = full_box();
  return result;
}

CGAL::Bbox_3 box_of(const Points& cloud)
{
  return CGAL::bbox_3(cloud.begin(), cloud.end());
}

Builder built(const Points& cloud, std::size_t chunk_size)
{
  Builder builder(box_of(cloud));
  for(auto begin = cloud.begin(); begin != cloud.end();) {
    const auto rest = static_cast<std::size_t>(cloud.end() - begin);
    const auto end = begin + static_cast<std::ptrdiff_t>(std::min(rest, chunk_size));
    builder.insert(CGAL::make_range(begin, end));
    begin = end;
  }
  return builder;
}

// Every point goes to one of `parts` builders, by chance.
std::vector<Builder> scattered(const Points& cloud, std::size_t parts, std::uint32_t seed)
{
  std::mt19937 generator(seed);
  std::vector<Points> share(parts);
  for(const Point& p : cloud)
    share[generator() % parts].push_back(p);
  std::vector<Builder> builders(parts, Builder(box_of(cloud)));
  for(std::size_t i = 0; i < parts; ++i)
    builders[i].insert(share[i]);
  return builders;
}

Builder sum(Builder a, const Builder& b)
{
  a.merge(b);
  return a;
}

void check_same_bits(const Mixture& a, const Mixture& b)
{
  REQUIRE(a.levels.size() == b.levels.size());
  for(std::size_t k = 0; k < a.levels.size(); ++k) {
    REQUIRE(a.levels[k].size() == b.levels[k].size());
    for(std::size_t i = 0; i < a.levels[k].size(); ++i) {
      const Component &c = a.levels[k][i], &d = b.levels[k][i];
      REQUIRE((c.weight == d.weight && c.mean == d.mean && c.covariance == d.covariance));
    }
  }
}

// How far two means, and the roots of two covariances, are apart. Coordinates of 5e6 are rounded to
// 1e-9, and covariances are differences of squares of at most a few units.
constexpr double rounding = 1e-8;

// Weight, mean and covariance of a union of components, straight from their definition.
Component total(const std::vector<Component>& parts)
{
  constexpr std::pair<int, int> entries[] = {{0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 2}};
  Component result;
  Kernel::Vector_3 offset(0, 0, 0);
  const Point origin = parts.front().mean;
  for(const Component& c : parts) {
    result.weight += c.weight;
    offset += c.weight * (c.mean - origin);
  }
  result.mean = origin + offset / result.weight;
  for(const Component& c : parts)
    for(std::size_t k = 0; k < 6; ++k) {
      const Kernel::Vector_3 d = c.mean - result.mean;
      const double spread = d[entries[k].first] * d[entries[k].second] + c.covariance[k];
      result.covariance[k] += c.weight / result.weight * spread;
    }
  return result;
}

Component total(const Points& cloud)
{
  std::vector<Component> parts;
  for(const Point& p : cloud)
    parts.push_back({1, p, {}});
  return total(parts);
}

Points branching(std::size_t size)
{
  return shapes::to_points<Kernel>(shapes::sample(shapes::y_junction(), size, 5));
}

// The same graph, bit for bit, but for the indices, of which a streamed one has none.
template <typename Curve_skeleton>
void check_equal(const Curve_skeleton& streamed, const Curve_skeleton& expected)
{
  REQUIRE(num_vertices(streamed) == num_vertices(expected));
  for(const auto v : CGAL::make_range(vertices(expected))) {
    REQUIRE(streamed[v].point == expected[v].point);
    REQUIRE(streamed[v].radius == expected[v].radius);
    REQUIRE(streamed[v].indices.empty());
  }
  REQUIRE(num_edges(streamed) == num_edges(expected));
  auto f = edges(expected).first;
  for(const auto e : CGAL::make_range(edges(streamed))) {
    REQUIRE(source(e, streamed) == source(*f, expected));
    REQUIRE(target(e, streamed) == target(*f, expected));
    ++f;
  }
}

// The message of what `insert()` throws.
std::string complaint(Builder& builder, const Points& cloud)
{
  try {
    builder.insert(cloud);
  } catch(const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

} // namespace

TEST_CASE("Chunks of any size give the same bits, and the moments of all points at once")
{
  const Mixture expected = CGAL::fit_gaussian_mixture(built(points(), points().size()));
  for(std::size_t chunk_size : {1u, 1009u, 290000u}) {
    CAPTURE(chunk_size);
    const Builder builder = built(points(), chunk_size);
    CHECK(builder.number_of_points() == points().size());
    check_same_bits(CGAL::fit_gaussian_mixture(builder), expected);
  }
  check_same_bits(expected, CGAL::fit_gaussian_mixture<CGAL::Parallel_if_available_tag>(points()));
}

TEST_CASE("Chunks of random sizes give the same bits, and so does any order of the points")
{
  const Mixture expected = CGAL::fit_gaussian_mixture(built(points(), points().size()));
  for(const unsigned int seed : {1u, 2u}) {
    CAPTURE(seed);
    std::mt19937 generator(seed);
    Builder chunked(box_of(points()));
    for(auto begin = points().begin(); begin != points().end();) {
      const auto rest = static_cast<std::size_t>(points().end() - begin);
      const std::size_t size = std::min<std::size_t>(rest, generator() % 50000); // 0 as well
      const auto end = begin + static_cast<std::ptrdiff_t>(size);
      chunked.insert(CGAL::make_range(begin, end));
      begin = end;
    }
    check_same_bits(CGAL::fit_gaussian_mixture(chunked), expected);

    Points shuffled = points();
    std::shuffle(shuffled.begin(), shuffled.end(), generator);
    check_same_bits(CGAL::fit_gaussian_mixture(built(shuffled, 10007)), expected);
  }
}

TEST_CASE("It does not matter which builder gets which points, nor how builders are merged")
{
  const Mixture at_once = CGAL::fit_gaussian_mixture(points());
  const std::vector<Builder> b = scattered(points(), 3, 1);
  const Builder left = sum(sum(b[0], b[1]), b[2]);
  const Builder right = sum(b[0], sum(b[1], b[2]));
  const Builder reversed = sum(sum(b[2], b[1]), b[0]);
  CHECK(left.number_of_points() == points().size());
  check_same_bits(CGAL::fit_gaussian_mixture(left), at_once);
  check_same_bits(CGAL::fit_gaussian_mixture(right), at_once);
  check_same_bits(CGAL::fit_gaussian_mixture(reversed), at_once);
}

TEST_CASE("A builder merged into goes on taking points")
{
  const auto middle = points().begin() + 270000;
  Builder first(box_of(points())), second(box_of(points()));
  first.insert(CGAL::make_range(points().begin(), points().begin() + 100000));
  second.insert(CGAL::make_range(points().begin() + 100000, middle));
  first.merge(second);
  first.merge(Builder(box_of(points()))); // empty
  first.insert(CGAL::make_range(middle, points().end()));
  check_same_bits(CGAL::fit_gaussian_mixture(first), CGAL::fit_gaussian_mixture(points()));
}

TEST_CASE("Merging cells keeps weight, mean and covariance of all points")
{
  const Component expected = total(points());
  const CGAL::Bbox_3 tight = box_of(points());
  for(double margin : {0., 1e4, 1e6}) { // a large box: few cells, merged less often
    CAPTURE(margin);
    const CGAL::Bbox_3 box(tight.xmin() - margin, tight.ymin() - margin, tight.zmin() - margin,
                           tight.xmax() + margin, tight.ymax() + margin, tight.zmax() + margin);
    Builder builder(box);
    builder.insert(points());
    const Mixture mixture = CGAL::fit_gaussian_mixture(builder);
    REQUIRE(mixture.levels.size() == 3);
    for(const Mixture::Level& level : mixture.levels) {
      const Component got = total(level);
      const double unit = std::max(1., margin); // of the coordinates that are rounded
      CHECK(got.weight == expected.weight);
      CHECK(std::sqrt(CGAL::squared_distance(got.mean, expected.mean)) < unit * rounding);
      for(std::size_t k = 0; k < 6; ++k)
        CHECK(std::abs(got.covariance[k] - expected.covariance[k]) < unit * rounding);
    }
  }
}

TEST_CASE("The number of cells is bounded at any time")
{
  namespace internal = CGAL::Point_set_skeletonization_3::internal;
  constexpr std::size_t bound = 100;
  internal::Moment_grid grid(bound);
  shapes::Random random(4);
  for(int i = 0; i < 2000; ++i) {
    grid.add(internal::lattice_point(internal::Vector3(
        random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5))));
    REQUIRE(grid.cells().size() <= bound);
  }
}

TEST_CASE("A streamed skeleton is that of the points, without their indices")
{
  const Points cloud = branching(20000);
  Skeleton expected;
  CGAL::L1_medial_skeletonization_3<Kernel> from_points(cloud);
  REQUIRE(from_points.run());
  from_points.extract_skeleton(expected);

  const Builder builder = built(cloud, 777);
  Skeleton streamed;
  REQUIRE(CGAL::extract_l1_medial_skeleton(builder, streamed));
  check_equal(streamed, expected);

  CGAL::L1_medial_skeletonization_3<Kernel> from_builder(builder);
  REQUIRE(from_builder.run());
  CHECK(from_builder.number_of_outliers() == from_points.number_of_outliers());
  CHECK(from_builder.number_of_components() == from_points.number_of_components());
}

TEST_CASE("Any range with a point map, of floats as well")
{
  using Float_kernel = CGAL::Simple_cartesian<float>;
  using Labelled = std::pair<Float_kernel::Point_3, int>;
  std::vector<Labelled> labelled;
  std::vector<Float_kernel::Point_3> plain;
  for(const auto& p : shapes::sample(shapes::ring(), 3000, 6)) {
    plain.push_back(shapes::to_points<Float_kernel>({p}).front());
    labelled.emplace_back(plain.back(), 1);
  }
  CGAL::Gaussian_mixture_builder_3<Float_kernel> builder(
      CGAL::bbox_3(plain.begin(), plain.end()));
  builder.insert(labelled,
                 CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Labelled>()));
  CGAL::Curve_skeleton_3<Float_kernel> streamed, expected;
  REQUIRE(CGAL::extract_l1_medial_skeleton(builder, streamed));
  REQUIRE(CGAL::extract_l1_medial_skeleton(plain, expected));
  check_equal(streamed, expected);
}

TEST_CASE("Bad points are named, the others stay")
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Builder builder(CGAL::Bbox_3(0, 0, 0, 1, 1, 1));
  builder.insert(Points{{0, 0, 0}, {1, 1, 1}});
  CHECK(complaint(builder, {{0.5, 0, 0}, {0, nan, 0}}).find("point 3 ") == 0);
  CHECK(complaint(builder, {{0, 0, infinity}}).find("point 3 ") == 0);
  CHECK(complaint(builder, {{0, 0, 0}, {0, 1.0001, 0}}).find("point 4 is outside") == 0);
  CHECK(complaint(builder, {{-1e-300, 0, 0}}).find("point 4 is outside") == 0);
  CHECK(builder.number_of_points() == 4);
  CHECK(total(CGAL::fit_gaussian_mixture(builder).levels.front()).weight == 4);
  CHECK_THROWS_AS(Builder(CGAL::Bbox_3(0, 0, 0, infinity, 1, 1)), std::invalid_argument);
  CHECK_THROWS_AS(Builder(CGAL::Bbox_3(0, nan, 0, 1, nan, 1)), std::invalid_argument);
  CHECK_THROWS_AS(Builder(CGAL::Bbox_3(1, nan, 0, 0, nan, 1)), std::invalid_argument);
  CHECK_THROWS_AS(Builder(CGAL::Bbox_3(1, 0, 0, 0, 1, 1)), std::invalid_argument);
}

TEST_CASE("Points far from the bulk are counted, and change nothing")
{
  const Points near = shapes::to_points<Kernel>(shapes::sample(shapes::y_junction(), 5000, 43));
  Points all = near;
  for(int i = 0; i < 5; ++i)
    all.emplace_back(std::pow(1e60, i), -i, 3e7);
  CGAL::Bulk_bbox_3<Kernel> bulk, other;
  bool is_found = false;
  while(!is_found) {
    for(std::size_t i = 0; i < all.size(); ++i)
      (i % 2 ? bulk : other).insert(all[i]);
    bulk.merge(other);
    is_found = bulk.end_pass();
    other = bulk; // of the passes before, without points of this one
  }
  CHECK(bulk.bbox() == box_of(near));
  CHECK(bulk.number_of_far_points() == 5);

  Builder builder(bulk), expected(box_of(near));
  builder.insert(all);
  expected.insert(near);
  CHECK(builder.number_of_points() == all.size());
  CGAL::L1_medial_skeletonization_3<Kernel> steps(builder);
  REQUIRE(steps.run());
  Skeleton found, skeleton;
  steps.extract_skeleton(found);
  REQUIRE(CGAL::extract_l1_medial_skeleton(expected, skeleton));
  CHECK(have_same_bits(found, skeleton));
  CHECK(steps.number_of_outliers() >= 5);
}

TEST_CASE("No points, one, many equal ones")
{
  Skeleton skeleton;
  Builder none{CGAL::Bbox_3()};
  CHECK(complaint(none, {{0, 0, 0}}).find("point 0 is outside") == 0);
  REQUIRE(CGAL::extract_l1_medial_skeleton(none, skeleton));
  CHECK(num_vertices(skeleton) == 0);
  CHECK(CGAL::fit_gaussian_mixture(none).levels.empty());

  const Point p(3, 4, 5);
  for(std::size_t size : {1u, 1000u}) {
    Builder equal(p.bbox());
    equal.insert(Points(size, p));
    REQUIRE(CGAL::extract_l1_medial_skeleton(equal, skeleton));
    REQUIRE(num_vertices(skeleton) == 1);
    CHECK(skeleton[0].point == p);
    CHECK(skeleton[0].indices.empty());
  }
}

TEST_CASE("The number of cells can be chosen, of a builder and of points")
{
  const Points cloud = branching(20000);
  Builder builder(box_of(cloud), 3000);
  builder.insert(cloud);
  const Mixture coarse = CGAL::fit_gaussian_mixture(builder);
  CHECK(coarse.levels.front().size() <= 3000);
  CHECK(CGAL::fit_gaussian_mixture(cloud).levels.front().size() > 3000);
  CGAL::L1_medial_skeletonization_3<Kernel> steps(cloud, CGAL::parameters::maximum_cells(3000));
  REQUIRE(steps.fit_mixture());
  check_same_bits(steps.mixture(), coarse);
}

TEST_CASE("The smallest feature can be chosen, of a builder and of points")
{
  const Points cloud = branching(20000);
  const Builder builder = built(cloud, 1000);
  const auto feature = [](std::optional<double> length) {
    return CGAL::parameters::smallest_feature(length);
  };
  const Mixture fine = CGAL::fit_gaussian_mixture(cloud);
  check_same_bits(CGAL::fit_gaussian_mixture(cloud, feature(1e-300)), fine);
  check_same_bits(CGAL::fit_gaussian_mixture(cloud, feature(std::nullopt)), fine);
  const CGAL::Bbox_3 box = box_of(cloud);
  const double length = 0.06 * (box.xmax() - box.xmin());
  const Mixture coarse = CGAL::fit_gaussian_mixture(cloud, feature(length));
  CHECK(coarse.levels.front().size() < fine.levels.front().size());
  check_same_bits(CGAL::fit_gaussian_mixture(builder, feature(length)), coarse);
  Skeleton at_once, in_chunks;
  REQUIRE(CGAL::extract_l1_medial_skeleton(cloud, at_once, feature(length)));
  REQUIRE(CGAL::extract_l1_medial_skeleton<CGAL::Parallel_if_available_tag>(builder, in_chunks,
                                                                             feature(length)));
  check_equal(in_chunks, at_once);
}

TEST_CASE("Parts that do not touch are split, the largest first, and strays are left out")
{
  Points cloud = branching(6000);
  const CGAL::Bbox_3 box = box_of(cloud);
  const double side = box.xmax() - box.xmin();
  for(const Point& p : branching(20000))
    cloud.emplace_back(p.x() + 1.5 * side, p.y(), p.z());
  cloud.emplace_back(box.xmin(), box.ymin() - side, box.zmin()); // a stray
  const Builder builder = built(cloud, 1000);
  const std::vector<Builder> parts = builder.split();
  REQUIRE(parts.size() == 2);
  CHECK(parts[0].number_of_points() == 20000);
  CHECK(parts[1].number_of_points() == 6000);
  for(const Builder& part : parts) {
    Skeleton skeleton;
    REQUIRE(CGAL::extract_l1_medial_skeleton(part, skeleton));
    std::vector<std::size_t> component(num_vertices(skeleton));
    CHECK(boost::connected_components(skeleton, component.data()) == 1);
  }
  Points shuffled = cloud;
  std::shuffle(shuffled.begin(), shuffled.end(), std::mt19937(1));
  const std::vector<Builder> same = built(shuffled, 1000).split();
  REQUIRE(same.size() == 2);
  for(std::size_t i = 0; i < 2; ++i)
    check_same_bits(CGAL::fit_gaussian_mixture(same[i]), CGAL::fit_gaussian_mixture(parts[i]));
  CHECK(Builder().split().empty());
}

TEST_CASE("A small cloud is split into its parts, not into its points")
{
  Points cloud = branching(500);
  CHECK(built(cloud, 100).split().size() == 1);
  const CGAL::Bbox_3 box = box_of(cloud);
  const double side = box.xmax() - box.xmin();
  for(const Point& p : branching(300))
    cloud.emplace_back(p.x() + 3 * side, p.y(), p.z());
  const std::vector<Builder> parts = built(cloud, 100).split();
  REQUIRE(parts.size() == 2);
  CHECK(parts[0].number_of_points() == 500);
  CHECK(parts[1].number_of_points() == 300);
}

TEST_CASE("A point read once more finds the vertex that it has in memory")
{
  Points cloud = branching(20000);
  cloud.emplace_back(1e9, 0, 0); // far away
  CGAL::Bulk_bbox_3<Kernel> bulk;
  do
    for(const Point& p : cloud)
      bulk.insert(p);
  while(!bulk.end_pass());
  Builder builder(bulk);
  builder.insert(cloud);
  CGAL::L1_medial_skeletonization_3<Kernel> steps(builder);
  REQUIRE(steps.run());
  const CGAL::Point_assignment_3<Kernel> assignment = steps.point_assignment();

  Skeleton skeleton;
  REQUIRE(CGAL::extract_l1_medial_skeleton(cloud, skeleton));
  std::vector<std::size_t> expected(cloud.size(), assignment.none);
  for(const auto v : CGAL::make_range(vertices(skeleton)))
    for(const std::size_t i : skeleton[v].indices)
      expected[i] = v;
  std::size_t differences = 0;
  for(std::size_t i = 0; i < cloud.size(); ++i)
    differences += assignment(cloud[i]) != expected[i];
  CHECK(differences == 0);
  CHECK(assignment(cloud.back()) == assignment.none);
  CHECK(CGAL::Point_assignment_3<Kernel>()(cloud.front()) == assignment.none);
}

} // namespace mixture_builder_test
