// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Any kernel with inexact constructions gives the same skeleton, as far as its numbers go.

#include "catch2.h"
#include "shapes.h"
#include "skeleton_checks.h"

#include <CGAL/compute_medial_samples.h>
#include <CGAL/extract_l1_medial_skeleton.h>
#include <CGAL/fit_gaussian_mixture.h>
#include <CGAL/link_medial_samples.h>

#include <CGAL/Cartesian.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cstddef>
#include <vector>

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

} // namespace

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
