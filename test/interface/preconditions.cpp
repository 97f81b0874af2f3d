// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Programming mistakes are told from data: they violate preconditions, as everywhere in CGAL.

#include "catch2.h"
#include "shapes.h"

#include <CGAL/Gaussian_mixture_builder_3.h>
#include <CGAL/L1_medial_skeletonization_3.h>
#include <CGAL/Point_set_skeletonization_3/internal/mixture/Grid_mixture.h>
#include <CGAL/Point_set_skeletonization_3/internal/pipeline/Options.h>
#include <CGAL/Point_set_skeletonization_3/internal/published/Published_options.h>
#include <CGAL/Published_l1_medial_skeletonization_3.h>
#include <CGAL/link_medial_samples.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/assertions_behaviour.h>
#include <CGAL/exceptions.h>

#include <limits>
#include <set>
#include <string>
#include <vector>

namespace preconditions_test {

#ifdef CGAL_NO_PRECONDITIONS
#error "This test needs preconditions."
#endif

using Kernel = CGAL::Simple_cartesian<double>;
using Points = std::vector<Kernel::Point_3>;
using Skeletonization = CGAL::L1_medial_skeletonization_3<Kernel>;

namespace {

// The exception is enough: nothing is printed besides.
void print_nothing(const char*, const char*, const char*, int, const char*) {}

struct Silence
{
  CGAL::Failure_function before = CGAL::set_error_handler(print_nothing);
  ~Silence() { CGAL::set_error_handler(before); }
};

Points cloud() { return shapes::to_points<Kernel>(shapes::sample(shapes::cylinder(), 500, 43)); }

} // namespace

TEST_CASE("Steps out of order violate a precondition")
{
  const Silence silence;
  const Points points = cloud();
  Skeletonization steps(points);
  Skeletonization::Skeleton skeleton(1);
  CHECK_THROWS_AS(steps.project(), CGAL::Precondition_exception);
  CHECK_THROWS_AS(steps.link(), CGAL::Precondition_exception);
  REQUIRE(steps.fit_mixture());
  CHECK_THROWS_AS(steps.link(), CGAL::Precondition_exception);
  CHECK_THROWS_AS(steps.extract_skeleton(skeleton), CGAL::Precondition_exception);
  REQUIRE(steps.project());
  CHECK_THROWS_AS(steps.extract_skeleton(skeleton), CGAL::Precondition_exception);
  CHECK(num_vertices(skeleton) == 1);
  REQUIRE(steps.link());
  CHECK_NOTHROW(steps.extract_skeleton(skeleton));
}

TEST_CASE("Repeating a step makes those after it out of date")
{
  const Silence silence;
  const Points points = cloud();
  Skeletonization steps(points);
  Skeletonization::Skeleton skeleton;
  REQUIRE(steps.run());
  REQUIRE(steps.project());
  CHECK_THROWS_AS(steps.extract_skeleton(skeleton), CGAL::Precondition_exception);
  REQUIRE(steps.link());
  CHECK_NOTHROW(steps.extract_skeleton(skeleton));
  REQUIRE(steps.fit_mixture());
  CHECK_THROWS_AS(steps.link(), CGAL::Precondition_exception);
}

TEST_CASE("The same of the published method")
{
  using Published = CGAL::Published_l1_medial_skeletonization_3<Kernel>;
  const Silence silence;
  const Points points = cloud();
  Published steps(points);
  Published::Skeleton skeleton;
  CHECK_THROWS_AS(steps.project(), CGAL::Precondition_exception);
  REQUIRE(steps.fit_mixture());
  CHECK_THROWS_AS(steps.link(), CGAL::Precondition_exception);
  REQUIRE(steps.project());
  CHECK_THROWS_AS(steps.extract_skeleton(skeleton), CGAL::Precondition_exception);
  REQUIRE(steps.link());
  CHECK_NOTHROW(steps.extract_skeleton(skeleton));
}

TEST_CASE("Options out of their range violate a precondition")
{
  using namespace CGAL::Point_set_skeletonization_3::internal;
  const Silence silence;
  const auto check_refused = [](const auto& change) {
    Published_options published = Published_options::tuned();
    CHECK_NOTHROW(published.check());
    change(published);
    CHECK_THROWS_AS(published.check(), CGAL::Precondition_exception);
  };
  check_refused([](Published_options& o) { o.projection.repulsion = 0.5; });
  check_refused([](Published_options& o) { o.projection.kernel_growth = -1; });
  check_refused([](Published_options& o) { o.projection.initial_kernel_radius = 0; });
  check_refused([](Published_options& o) { o.projection.number_of_samples = 0; });
  check_refused([](Published_options& o) { o.points.neighbors = 0; });
  check_refused([](Published_options& o) { o.points.flatness = 0; });
  check_refused([](Published_options& o) { o.samples.flatness = -1; });
  check_refused([](Published_options& o) { o.em.alpha = 0; });
  check_refused([](Published_options& o) { o.branches.alpha_min = 180; });
  check_refused([](Published_options& o) { o.branches.b_min = 1; });
  check_refused([](Published_options& o) { o.branches.d_max = 0; });
  Grid_options grid;
  grid.minimum_cells = 7;
  CHECK_THROWS_AS(grid.check(), CGAL::Precondition_exception);
}

TEST_CASE("The smallest feature is a length")
{
  const Silence silence;
  const Points points = cloud();
  const CGAL::Gaussian_mixture_builder_3<Kernel> builder(CGAL::Bbox_3(0, 0, 0, 1, 1, 1));
  const auto check_refused = [](const auto& from, double length) {
    CAPTURE(length);
    CHECK_THROWS_AS(Skeletonization(from, CGAL::parameters::smallest_feature(length)),
                    CGAL::Precondition_exception);
  };
  using Limits = std::numeric_limits<double>;
  for(const double length : {0., -1., Limits::infinity(), Limits::quiet_NaN()}) {
    check_refused(points, length);
    check_refused(builder, length);
  }
  for(const double length : {Limits::denorm_min(), Limits::max()}) {
    Skeletonization steps(points, CGAL::parameters::smallest_feature(length));
    CHECK(steps.run());
  }
}

TEST_CASE("Every option has a range, in which its default is")
{
  using namespace CGAL::Point_set_skeletonization_3::internal;
  const Silence silence;
  const auto check = [](const Options& options) {
    options.mixture.check();
    options.scene.check();
    options.medial.consolidation.check();
    options.medial.surface.check();
    options.medial.samples.check();
    options.linking.check();
  };
  CHECK_NOTHROW(check(Options()));
  std::set<std::string> names;
  Options().visit([&](const std::string& name, double) { CHECK(names.insert(name).second); });
  CHECK(!names.empty());
  const auto is_refused = [&](const std::string& name, double value) {
    Options options;
    options.visit([&](const std::string& visited, double& option) {
      if(visited == name)
        option = value;
    });
    try {
      check(options);
    } catch(const CGAL::Precondition_exception&) {
      return true;
    }
    return false;
  };
  for(const std::string& name : names) {
    CAPTURE(name);
    CHECK(is_refused(name, std::numeric_limits<double>::quiet_NaN()));
    CHECK((is_refused(name, -1e9) || is_refused(name, 1e9)));
  }
}

TEST_CASE("Samples that cannot be violate a precondition")
{
  const Silence silence;
  CGAL::Medial_samples_3<Kernel> samples;
  samples.samples.resize(2);
  Skeletonization::Skeleton skeleton;
  samples.noise = {0, 1.5};
  CHECK_THROWS_AS(CGAL::link_medial_samples(samples, skeleton), CGAL::Precondition_exception);
  samples.noise = {0};
  samples.samples.back().object = 2; // there are no more objects than samples
  CHECK_THROWS_AS(CGAL::link_medial_samples(samples, skeleton), CGAL::Precondition_exception);
  samples.samples.back().object = 0;
  samples.surface.resize(2); // none of the second sample
  CHECK_THROWS_AS(CGAL::link_medial_samples(samples, skeleton), CGAL::Precondition_exception);
  samples.surface.back().sample = 2; // of a sample that is not there
  CHECK_THROWS_AS(CGAL::link_medial_samples(samples, skeleton), CGAL::Precondition_exception);
}

TEST_CASE("A builder has room for at least a thousand components")
{
  using Builder = CGAL::Gaussian_mixture_builder_3<Kernel>;
  const Silence silence;
  const CGAL::Bbox_3 box(0, 0, 0, 1, 1, 1);
  CHECK_THROWS_AS(Builder(box, 999), CGAL::Precondition_exception);
  CHECK_NOTHROW(Builder(box, 1000));
}

} // namespace preconditions_test
