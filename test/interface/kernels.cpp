// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Any kernel with inexact constructions gives the same skeleton, as far as its numbers go, and all
// points of results are constructed by the traits.

#include "catch2.h"
#include "shapes.h"
#include "skeleton_checks.h"

#include <CGAL/compute_medial_samples.h>
#include <CGAL/extract_l1_medial_skeleton.h>
#include <CGAL/extract_published_l1_medial_skeleton.h>
#include <CGAL/fit_gaussian_mixture.h>
#include <CGAL/link_medial_samples.h>

#include <CGAL/Cartesian.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Origin.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace kernels_test {

using shapes::Vector;

namespace {

// Coordinates that a float holds, so that every kernel gets the same points.
std::vector<Vector> cloud()
{
  std::vector<Vector> points = shapes::sample(shapes::y_junction(), 3000, 29);
  for(Vector& p : points)
    p = p.cast<float>().cast<double>();
  return points;
}

template <typename Kernel>
CGAL::Curve_skeleton_3<Kernel> skeleton_of(const std::vector<Vector>& points)
{
  CGAL::Curve_skeleton_3<Kernel> skeleton;
  REQUIRE(CGAL::extract_l1_medial_skeleton(shapes::to_points<Kernel>(points), skeleton));
  check_valid(skeleton, points.size());
  return skeleton;
}

template <typename Skeleton, typename OtherSkeleton>
void check_equal(const Skeleton& a, const OtherSkeleton& b, double tolerance)
{
  REQUIRE(num_vertices(a) == num_vertices(b));
  REQUIRE(num_edges(a) == num_edges(b));
  double worst = 0;
  for(const auto v : boost::make_iterator_range(vertices(a))) {
    const Vector offset = shapes::to_vector(a[v].point) - shapes::to_vector(b[v].point);
    worst = std::max({worst, offset.norm(), std::abs(double(a[v].radius) - double(b[v].radius))});
    CHECK(a[v].indices == b[v].indices);
  }
  CHECK(worst <= tolerance);
  for(const auto e : boost::make_iterator_range(edges(a)))
    CHECK(edge(source(e, a), target(e, a), b).second);
}

// Traits without a constructor of points of three numbers. They mark the points that an object
// constructs: only `geom_traits` marks with 2.
struct Marking_traits
{
  using FT = double;

  class Point_3
  {
  public:
    double x() const { return xyz_[0]; }
    double y() const { return xyz_[1]; }
    double z() const { return xyz_[2]; }
    int mark() const { return mark_; }

  private:
    Point_3(const Vector& xyz, int mark) : xyz_(xyz), mark_(mark) {}

    Vector xyz_;
    int mark_;

    friend struct Marking_traits;
  };

  class Construct_point_3
  {
  public:
    explicit Construct_point_3(int mark = 0) : mark_(mark) {}
    Point_3 operator()(double x, double y, double z) const { return {Vector(x, y, z), mark_}; }
    Point_3 operator()(CGAL::Origin) const { return {Vector::Zero(), 0}; }

  private:
    int mark_;
  };

  Construct_point_3 construct_point_3_object() const { return Construct_point_3(mark); }

  int mark = 1;
};

using Marked_point = Marking_traits::Point_3;

std::vector<Marked_point> marked_points(const std::vector<Vector>& points)
{
  std::vector<Marked_point> result;
  for(const Vector& p : points)
    result.push_back(Marking_traits::Construct_point_3()(p.x(), p.y(), p.z()));
  return result;
}

void check_marks(const CGAL::Curve_skeleton_3<Marking_traits>& skeleton, int mark)
{
  REQUIRE(num_vertices(skeleton) > 0);
  for(const auto v : boost::make_iterator_range(vertices(skeleton)))
    CHECK(skeleton[v].point.mark() == mark);
}

} // namespace

TEST_CASE("The traits object of a call constructs the points of its results")
{
  const std::vector<Vector> points = cloud();
  Marking_traits traits;
  traits.mark = 2;
  const auto np = CGAL::parameters::geom_traits(traits);
  CGAL::Curve_skeleton_3<Marking_traits> skeleton;
  REQUIRE(CGAL::extract_l1_medial_skeleton(marked_points(points), skeleton, np));
  check_marks(skeleton, 2);
  check_equal(skeleton, skeleton_of<CGAL::Simple_cartesian<double>>(points), 0);

  REQUIRE(CGAL::extract_published_l1_medial_skeleton(marked_points(points), skeleton, np));
  check_marks(skeleton, 2);
}

TEST_CASE("Each stage constructs points by its traits")
{
  Marking_traits traits;
  traits.mark = 2;
  const auto np = CGAL::parameters::geom_traits(traits);
  const auto mixture = CGAL::fit_gaussian_mixture(marked_points(cloud()), np);
  REQUIRE(!mixture.levels.empty());
  for(const auto& component : mixture.levels.front())
    CHECK(component.mean.mark() == 2);

  CGAL::Medial_samples_3<Marking_traits> samples;
  REQUIRE(CGAL::compute_medial_samples(mixture, samples));
  REQUIRE(!samples.samples.empty());
  for(const auto& sample : samples.samples) {
    CHECK(sample.patch.mean.mark() == 1);
    CHECK(sample.point.mark() == 1);
  }
  for(const auto& point : samples.surface) {
    CHECK(point.point.mark() == 1);
    CHECK(point.denoised.mark() == 1);
  }

  CGAL::Curve_skeleton_3<Marking_traits> skeleton;
  REQUIRE(CGAL::link_medial_samples(samples, skeleton));
  check_marks(skeleton, 1);
}

TEST_CASE("Kernels agree")
{
  const std::vector<Vector> points = cloud();
  const auto expected = skeleton_of<CGAL::Simple_cartesian<double>>(points);
  check_equal(skeleton_of<CGAL::Cartesian<double>>(points), expected, 0);
  check_equal(skeleton_of<CGAL::Exact_predicates_inexact_constructions_kernel>(points), expected,
              0);
  check_equal(skeleton_of<CGAL::Simple_cartesian<float>>(points), expected, 1e-6);
}

TEST_CASE("The stages work with numbers of single precision, too")
{
  using Kernel = CGAL::Simple_cartesian<float>;
  const auto mixture = CGAL::fit_gaussian_mixture(shapes::to_points<Kernel>(cloud()));
  CGAL::Medial_samples_3<Kernel> samples;
  REQUIRE(CGAL::compute_medial_samples(mixture, samples));
  CGAL::Curve_skeleton_3<Kernel> skeleton;
  REQUIRE(CGAL::link_medial_samples(samples, skeleton));
  check_valid(skeleton, samples.samples.size());
  CHECK(num_edges(skeleton) + 1 == num_vertices(skeleton));
}

} // namespace kernels_test
