// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The steps of the class and what each of them leaves to be read.

#include "catch2.h"
#include "shapes.h"
#include "skeleton_checks.h"

#include <CGAL/L1_medial_skeletonization_3.h>
#include <CGAL/Published_l1_medial_skeletonization_3.h>
#include <CGAL/extract_l1_medial_skeleton.h>
#include <CGAL/extract_published_l1_medial_skeleton.h>

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace steps_test {

using Kernel = CGAL::Simple_cartesian<double>;
using Points = std::vector<Kernel::Point_3>;
using Skeletonization = CGAL::L1_medial_skeletonization_3<Kernel>;
using Published = CGAL::Published_l1_medial_skeletonization_3<Kernel>;
using Skeleton = Skeletonization::Skeleton;

namespace {

Points cloud() { return shapes::to_points<Kernel>(shapes::sample(shapes::cylinder(), 1500, 41)); }

template <typename Steps>
Skeleton extracted(const Steps& steps)
{
  Skeleton skeleton;
  steps.extract_skeleton(skeleton);
  return skeleton;
}

// Skeletons of a cloud that has to come out as `expected`: step by step and at once.
template <typename Steps>
void check_all_ways(const Points& points, const Skeleton& expected)
{
  Steps steps(points), whole(points);
  REQUIRE((steps.fit_mixture() && steps.project() && steps.link()));
  REQUIRE(whole.run());
  CHECK(have_same_bits(extracted(steps), expected));
  CHECK(have_same_bits(extracted(whole), expected));
}

// Every step is cancelled, done and repeated.
template <typename Steps>
void check_repeated(const Points& points)
{
  int calls_left = 1000;
  const std::function<bool(double)> callback = [&](double) { return calls_left-- > 0; };
  Steps steps(points, CGAL::parameters::callback(callback));
  Steps once(points);
  REQUIRE(once.run());
  const std::vector<std::function<bool()>> verbs{
    [&] { return steps.fit_mixture(); }, [&] { return steps.project(); },
    [&] { return steps.link(); }};
  for(const auto& verb : verbs) {
    calls_left = 1;
    CHECK_FALSE(verb());
    calls_left = 1000;
    CHECK(verb());
    CHECK(verb());
  }
  CHECK(steps.mixture().levels.size() == once.mixture().levels.size());
  CHECK(have_same_bits(extracted(steps), extracted(once)));
}

double mass(const Skeletonization::Mixture::Level& level)
{
  double sum = 0;
  for(const auto& c : level)
    sum += c.weight;
  return sum;
}

} // namespace

TEST_CASE("Every step leaves what the next one reads")
{
  const Points points = cloud();
  Skeletonization steps(points);
  CHECK(steps.mixture().levels.empty());
  CHECK(steps.samples().samples.empty());

  REQUIRE(steps.fit_mixture());
  const auto mixture = steps.mixture();
  REQUIRE(!mixture.levels.empty());
  for(const auto& level : mixture.levels)
    CHECK(mass(level) == Approx(static_cast<double>(points.size())));
  CHECK(mixture.cell_size > 0);
  CHECK(steps.number_of_components() == mixture.levels.front().size());
  CHECK(steps.samples().samples.empty());

  REQUIRE(steps.project());
  const auto samples = steps.samples();
  CHECK(!samples.samples.empty());
  CHECK(samples.samples.size() <= steps.number_of_components()); // outliers have none
  CHECK(steps.number_of_samples() == samples.samples.size());
  REQUIRE(samples.noise.size() == 1);
  CHECK((samples.noise[0] >= 0 && samples.noise[0] <= 1));
  double weight = 0;
  for(const auto& s : samples.samples) {
    REQUIRE(s.radius >= 0);
    weight += s.patch.weight;
  }
  CHECK(weight <= Approx(static_cast<double>(points.size())));
  for(const auto& p : samples.surface)
    REQUIRE(p.sample < samples.samples.size());

  REQUIRE(steps.link());
  const Skeleton skeleton = extracted(steps);
  check_valid(skeleton, points.size());
  std::size_t assigned = 0;
  for(const auto v : boost::make_iterator_range(vertices(skeleton)))
    assigned += skeleton[v].indices.size();
  CHECK(assigned + steps.number_of_outliers() == points.size());
}

TEST_CASE("Step by step, at once and through the free function is the same")
{
  const Points points = cloud();
  Skeleton skeleton, published;
  REQUIRE(CGAL::extract_l1_medial_skeleton(points, skeleton));
  REQUIRE(CGAL::extract_published_l1_medial_skeleton(points, published));
  check_all_ways<Skeletonization>(points, skeleton);
  check_all_ways<Published>(points, published);
}

TEST_CASE("What is used up gives the skeleton that it would have given, also of a large cloud")
{
  // More points than what is kept of them is given back at once.
  const Points points =
    shapes::to_points<Kernel>(shapes::sample(shapes::y_junction(), 2'300'000, 42));
  Skeletonization steps(points);
  REQUIRE(steps.run());
  const Skeleton before = extracted(steps), again = extracted(steps);
  Skeleton last;
  std::move(steps).extract_skeleton(last);
  check_valid(last, points.size());
  CHECK(have_same_bits(before, again));
  CHECK(have_same_bits(before, last));
}

TEST_CASE("Every step of the published method leaves what the next one reads")
{
  const Points points = cloud();
  for(std::size_t iterations : {1u, 7u}) {
    CAPTURE(iterations);
    Published steps(points, CGAL::parameters::number_of_iterations(iterations));
    REQUIRE(steps.fit_mixture());
    REQUIRE(!steps.mixture().levels.empty());
    CHECK(steps.mixture().cell_size == 0); // its components are not the points of cells
    CHECK(steps.number_of_components() == steps.mixture().levels.back().size());
    CHECK(steps.samples().empty());
    CHECK(steps.number_of_iterations() == 0);
    REQUIRE(steps.project());
    CHECK(steps.number_of_iterations() == iterations);
    CHECK(steps.number_of_samples() == steps.samples().size());
    CHECK(!steps.samples().empty());
    CHECK(steps.number_of_samples() < points.size());
    for(const auto& s : steps.samples()) {
      const auto is_origin = [&](const Kernel::Point_3& p) {
        return CGAL::squared_distance(p, s.origin) < 1e-24;
      };
      REQUIRE(std::any_of(points.begin(), points.end(), is_origin));
      REQUIRE(s.kernel_radius > 0);
      REQUIRE(s.radius >= 0);
    }
    REQUIRE(steps.link());
    check_valid(extracted(steps), points.size());
  }
}

TEST_CASE("The points are read by the first step, not before, and not after")
{
  Points points = cloud(), other = points;
  Skeletonization steps(points);
  points.front() = Kernel::Point_3(std::numeric_limits<double>::infinity(), 0, 0);
  CHECK_THROWS_AS(steps.fit_mixture(), std::invalid_argument);
  points = other; // which may be where it was
  REQUIRE(steps.fit_mixture());
  std::fill(points.begin(), points.end(), Kernel::Point_3(7, 7, 7));
  REQUIRE((steps.project() && steps.link()));
  Skeleton skeleton;
  REQUIRE(CGAL::extract_l1_medial_skeleton(other, skeleton));
  CHECK(have_same_bits(extracted(steps), skeleton));
}

TEST_CASE("A step may be repeated, also after it was cancelled")
{
  const Points points = cloud();
  check_repeated<Skeletonization>(points);
  check_repeated<Published>(points);
}

TEST_CASE("An object may be moved between its steps, but not copied")
{
  CHECK_FALSE(std::is_copy_constructible<Skeletonization>::value);
  CHECK_FALSE(std::is_copy_constructible<Published>::value);
  const Points points = cloud();
  Skeletonization first(points);
  Skeletonization second = std::move(first);
  REQUIRE(second.fit_mixture());
  Skeletonization third = std::move(second);
  REQUIRE((third.project() && third.link()));
  Skeleton skeleton;
  REQUIRE(CGAL::extract_l1_medial_skeleton(points, skeleton));
  CHECK(have_same_bits(extracted(third), skeleton));
}

} // namespace steps_test
