// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The steps of the class and what each of them leaves to be read.

#include "catch2.h"
#include "shapes.h"
#include "skeleton_checks.h"

#include <CGAL/L1_medial_skeletonization_3.h>
#include <CGAL/extract_l1_medial_skeleton.h>

#include <CGAL/Simple_cartesian.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Points = std::vector<Kernel::Point_3>;
using Skeletonization = CGAL::L1_medial_skeletonization_3<Kernel>;
using Skeleton = Skeletonization::Skeleton;
using CGAL::Projection_stop_reason;
using CGAL::parameters::as_published;

namespace {

Points cloud() { return shapes::to_points<Kernel>(shapes::sample(shapes::cylinder(), 1500, 41)); }

Skeleton extracted(const Skeletonization& steps)
{
  Skeleton skeleton;
  steps.extract_skeleton(skeleton);
  return skeleton;
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
  CHECK(steps.samples().empty());
  CHECK(steps.stop_reason() == Projection_stop_reason::empty);

  REQUIRE(steps.fit_mixture());
  const auto mixture = steps.mixture();
  REQUIRE(!mixture.levels.empty());
  for(const auto& level : mixture.levels)
    CHECK(mass(level) == Approx(static_cast<double>(points.size())));
  CHECK(steps.number_of_components() == mixture.levels.front().size());
  CHECK(steps.samples().empty());

  REQUIRE(steps.project());
  CHECK(!steps.samples().empty());
  CHECK(steps.samples().size() <= steps.number_of_components()); // outliers have none
  CHECK(steps.number_of_samples() == steps.samples().size());
  CHECK(steps.number_of_iterations() == 0); // the centres of medial balls
  CHECK(std::string(to_string(steps.stop_reason())) == "converged");
  for(const auto& s : steps.samples()) {
    REQUIRE(s.kernel_radius > 0);
    REQUIRE(s.radius >= 0);
    REQUIRE(s.frozen);
  }

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
  for(bool published : {false, true}) {
    CAPTURE(published);
    Skeletonization steps(points, as_published(published)), whole(points, as_published(published));
    REQUIRE((steps.fit_mixture() && steps.project() && steps.link()));
    REQUIRE(whole.run());
    Skeleton skeleton;
    REQUIRE(CGAL::extract_l1_medial_skeleton(points, skeleton, as_published(published)));
    CHECK(have_same_bits(extracted(steps), skeleton));
    CHECK(have_same_bits(extracted(whole), skeleton));
  }
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

TEST_CASE("The published method does a fixed number of iterations")
{
  const Points points = cloud();
  for(std::size_t iterations : {1u, 7u}) {
    Skeletonization steps(
      points, as_published(true, CGAL::parameters::number_of_iterations(iterations)));
    REQUIRE(steps.run());
    CHECK(steps.number_of_iterations() == iterations);
    CHECK(std::string(to_string(steps.stop_reason())) == "fixed_number");
    CHECK(steps.number_of_samples() < points.size());
  }
}

TEST_CASE("The default method keeps to a bound on its iterations")
{
  Skeletonization steps(cloud(), CGAL::parameters::number_of_iterations(std::size_t(1)));
  REQUIRE(steps.run());
  CHECK(steps.number_of_iterations() == 1);
}

TEST_CASE("The points may go away once the object is made")
{
  auto points = std::make_unique<Points>(cloud());
  Skeletonization steps(*points);
  points.reset();
  REQUIRE(steps.run());
  Skeleton skeleton;
  REQUIRE(CGAL::extract_l1_medial_skeleton(cloud(), skeleton));
  CHECK(have_same_bits(extracted(steps), skeleton));
}

TEST_CASE("A step may be repeated, also after it was cancelled")
{
  const Points points = cloud();
  for(bool published : {false, true}) {
    CAPTURE(published);
    int calls_left = 1000;
    const std::function<bool(double)> callback = [&](double) { return calls_left-- > 0; };
    Skeletonization steps(points, as_published(published, CGAL::parameters::callback(callback)));
    Skeletonization once(points, as_published(published));
    REQUIRE(once.run());
    const std::vector<std::function<bool()>> verbs{[&] { return steps.fit_mixture(); },
                                                   [&] { return steps.project(); },
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
}

TEST_CASE("An object cannot be copied or moved: its stages refer to its points")
{
  CHECK_FALSE(std::is_copy_constructible<Skeletonization>::value);
  CHECK_FALSE(std::is_move_constructible<Skeletonization>::value);
}
