// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// How far off the centre of the cross-sections of a mesh a skeleton is.

#include "catch2.h"
#include "off_centre.h"

#include <CGAL/Curve_skeleton_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace off_centre_test {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Skeleton = CGAL::Curve_skeleton_3<Kernel>;

namespace {

constexpr double height = 10;

// Adds a tube along the y axis, of 120 sides: nearly round.
void add_tube(Mesh& mesh, double x, double radius)
{
  Mesh tube;
  CGAL::make_regular_prism(120, tube, Point(x, 0, 0), height, radius, true);
  mesh.join(tube);
}

// Parallel to the y axis, away from the lids.
std::vector<double> ratios_at(const Mesh& mesh, double x)
{
  Skeleton skeleton(2);
  skeleton[0].point = Point(x, 1, 0);
  skeleton[1].point = Point(x, height - 1, 0);
  add_edge(0, 1, skeleton);
  return metrics::off_centre_ratios(skeleton, mesh, 0.5);
}

void check_all(const std::vector<double>& ratios, double expected)
{
  REQUIRE(ratios.size() == 16);
  for(const double ratio : ratios)
    CHECK(ratio == Approx(expected).margin(1e-3));
}

} // namespace

TEST_CASE("Off the centre of a round tube by a share of its radius")
{
  Mesh mesh;
  add_tube(mesh, 0, 2);
  REQUIRE(CGAL::is_closed(mesh));
  check_all(ratios_at(mesh, 0), 0);
  check_all(ratios_at(mesh, 0.6), 0.3);
  for(const double ratio : ratios_at(mesh, 2.1))
    CHECK(ratio == std::numeric_limits<double>::infinity());
}

TEST_CASE("Only the limb around the skeleton counts")
{
  Mesh mesh;
  add_tube(mesh, 0, 2);
  add_tube(mesh, 5, 1);
  check_all(ratios_at(mesh, 0.6), 0.3);
  check_all(ratios_at(mesh, 5.3), 0.3);
  for(const double ratio : ratios_at(mesh, 3))
    CHECK(ratio == std::numeric_limits<double>::infinity());
}

TEST_CASE("A hole is no part of the cross-section, and what is in a hole is another part")
{
  Mesh mesh;
  add_tube(mesh, 0, 3);
  add_tube(mesh, 0.5, 1.5);                                    // the hole
  const double area = 9 - 2.25, centroid = -0.5 * 2.25 / area; // in units of pi
  check_all(ratios_at(mesh, -2), std::abs(-2 - centroid) / std::sqrt(area));
  for(const double ratio : ratios_at(mesh, 0.5))
    CHECK(ratio == std::numeric_limits<double>::infinity());
  add_tube(mesh, 0.5, 0.5); // something in it
  check_all(ratios_at(mesh, -2), std::abs(-2 - centroid) / std::sqrt(area));
  check_all(ratios_at(mesh, 0.7), 0.2 / 0.5);
}

TEST_CASE("A skeleton askew to the limb is as centred as its points are")
{
  Mesh mesh;
  add_tube(mesh, 0, 1);
  Skeleton skeleton(2);
  skeleton[0].point = Point(-0.5, 4.5, 0);
  skeleton[1].point = Point(0.5, 5.5, 0);
  add_edge(0, 1, skeleton);
  // The cut is an ellipse with half axes 1 and sqrt(2), centred on the axis.
  const std::vector<double> ratios = metrics::off_centre_ratios(skeleton, mesh, 0.1);
  REQUIRE(!ratios.empty());
  const double furthest = *std::max_element(ratios.begin(), ratios.end());
  const double last = 0.5 - 0.5 / static_cast<double>(ratios.size()); // its x
  CHECK(furthest == Approx(last * std::sqrt(2.) / std::pow(2., 0.25)).margin(1e-3));
}

} // namespace off_centre_test
