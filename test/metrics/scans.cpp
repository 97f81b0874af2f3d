// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What is found of a known skeleton, and what of ours has no points around it.

#include "catch2.h"
#include "radius_factor.h"
#include "share_within.h"
#include "trunk_curves.h"
#include "unsupported_share.h"

#include <CGAL/Curve_skeleton_3.h>
#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace scans_test {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Skeleton = CGAL::Curve_skeleton_3<Kernel>;

namespace {

Skeleton path(const std::vector<Point>& points)
{
  Skeleton skeleton(points.size());
  for(std::size_t i = 0; i < points.size(); ++i) {
    skeleton[i].point = points[i];
    if(i > 0)
      add_edge(i - 1, i, skeleton);
  }
  return skeleton;
}

/// Points around the z axis from `begin` to `end`, on the first `degrees` of a tube of radius 1.
std::vector<metrics::Point> tube(double begin, double end, int degrees)
{
  std::vector<metrics::Point> points;
  for(double z = begin; z <= end; z += 0.05)
    for(int angle = 0; angle <= degrees; angle += 5)
      points.emplace_back(std::cos(angle * CGAL_PI / 180), std::sin(angle * CGAL_PI / 180), z);
  return points;
}

const Skeleton axis = path({Point(0, 0, 0), Point(0, 0, 10)});

double unsupported(const std::vector<metrics::Point>& points, double near)
{
  return metrics::unsupported_share(axis, metrics::Point_tree(points), near);
}

} // namespace

TEST_CASE("The share of a skeleton that another one is near")
{
  constexpr double distance = 0.1, step = 0.01;
  const Skeleton corner = path({Point(0, 0, 0), Point(3, 0, 0), Point(3, 1, 0)});
  const Skeleton line = path({Point(-5, 0.05, 0), Point(5, 0.05, 0)});
  const auto share = [&](const Skeleton& a, const Skeleton& b) {
    return metrics::share_within(
        distance, a, b, [](const metrics::Point&) { return true; }, step);
  };
  CHECK(share(corner, line) == Approx((3 + 0.15) / 4).margin(step));
  CHECK(share(line, corner) == Approx(0.3).margin(2 * distance / 10));
  CHECK(share(line, line) == 1);
  CHECK(share(line, Skeleton()) == 0);
  CHECK(std::isnan(share(Skeleton(), line)));

  const auto is_up = [](const metrics::Point& p) { return p.y() > 0; };
  CHECK(metrics::share_within(distance, corner, line, is_up, step) == Approx(0.15).margin(step));
}

TEST_CASE("The nearest point, and those within a distance")
{
  const metrics::Point_tree tree(
      std::vector<Point>{Point(0, 0, 0), Point(1, 0, 0), Point(3, 0, 0)});
  CHECK(tree.distance({2.5, 0, 0}) == 0.5);
  CHECK(tree.within(1.5, {0.1, 0, 0}).size() == 2);
  CHECK(tree.within(0.5, {2, 0, 0}).empty());
  const metrics::Point_tree empty(std::vector<Point>{});
  CHECK(empty.distance({0, 0, 0}) == std::numeric_limits<double>::infinity());
}

TEST_CASE("A skeleton is supported within a tube, of which a half is enough")
{
  CHECK(unsupported(tube(-1, 11, 360), 0.15) == 0);
  CHECK(unsupported(tube(-1, 11, 180), 0.15) == 0);
  CHECK(unsupported(tube(-1, 11, 120), 0.15) == 1);
}

TEST_CASE("A skeleton is supported by points that are near, wherever they are")
{
  CHECK(unsupported(tube(-1, 11, 0), 1.1) == 0);
  CHECK(unsupported(tube(-1, 11, 0), 0.9) == 1);
}

TEST_CASE("A skeleton from one limb to another is not supported between them")
{
  std::vector<metrics::Point> points = tube(-1, 2, 360);
  for(const metrics::Point& p : tube(8, 11, 360))
    points.push_back(p);
  // Beside the middle, points are more before and behind than beside.
  CHECK(unsupported(points, 0.15) == Approx(0.4).margin(0.03));
}

TEST_CASE("A skeleton without a cloud is not supported")
{
  CHECK(unsupported({}, 0.15) == 1);
  Skeleton alone(1);
  alone[0].point = Point(0, 0, 0);
  const metrics::Point_tree tree(tube(-1, 1, 360));
  CHECK(metrics::unsupported_share(alone, tree, 0.15) == 1); // it has no direction
  CHECK(metrics::unsupported_share(alone, tree, 1.1) == 0);
}

TEST_CASE("Curves in a trunk, of which half was seen and beside which something grows")
{
  const metrics::Vector up(1, 0, 1);
  const auto slanted = [](double x, double z) { return Point(x + z, 0.5, z - x); };
  const auto line = [&](double x, double from) {
    return path({slanted(x, from), slanted(x, 4), slanted(0, 10)});
  };
  const double radius = 0.1 * std::sqrt(2); // across the trunk
  std::vector<Point> trunk;
  for(const metrics::Point& p : tube(0, 10, 180)) {
    trunk.push_back(slanted(p.x() / 10, p.z()) + Kernel::Vector_3(0, radius * p.y(), 0));
    if(p.x() > 0.9)
      trunk.push_back(slanted(p.x(), p.z()));
  }
  const auto curves = [&](const Skeleton& skeleton) {
    return metrics::trunk_curves(skeleton, trunk, up);
  };
  CHECK(curves(line(0, 0)).single == 3);
  CHECK(curves(line(0, 0)).off < 0.1);
  CHECK(curves(line(0.05, 0)).single == 3);
  CHECK(curves(line(0.05, 0)).off == Approx(0.5).margin(0.1));
  CHECK(curves(line(0.15, 0)).single == 0);
  CHECK(curves(line(0.15, 0)).off == Approx(1.5).margin(0.1));
  CHECK(curves(line(0, 0.6)).single == 2);
  CHECK(curves(line(0, 0.8)).single == 1);
  CHECK(curves(line(0, 1)).single == 0);
  CHECK(std::isnan(curves(line(0, 1)).off));
  CHECK(curves(Skeleton()).single == 0);
  Skeleton two = line(0, 0);
  const auto beside = add_vertex(two);
  two[beside].point = slanted(0.05, 0);
  add_edge(1, beside, two);
  CHECK(curves(two).single == 0);
  two[beside].point = slanted(3, 0);
  CHECK(curves(two).single == 3);
}

TEST_CASE("The factor by which radii are wrong is that of half of the length near the axis")
{
  struct Piece
  {
    Point a, b;
    double radius_a, radius_b;
  };
  const std::vector<Piece> cone = {{Point(0, 0, 0), Point(0, 0, 10), 1, 3}};
  constexpr double near = 0.5;
  Skeleton skeleton = path({Point(0, 0, 0), Point(0, 0, 5), Point(0, 0, 10), Point(5, 0, 10)});
  const double exact[] = {1, 2, 3, 100}; // the last is not near
  for(std::size_t v = 0; v < 4; ++v)
    skeleton[v].radius = exact[v];
  CHECK(metrics::radius_factor(skeleton, cone, near) == Approx(1));
  for(const double factor : {0.5, 2.}) {
    for(std::size_t v = 0; v < 3; ++v)
      skeleton[v].radius = factor * exact[v];
    CHECK(metrics::radius_factor(skeleton, cone, near) == Approx(2));
  }
  skeleton[1].radius = skeleton[2].radius = 0;
  CHECK(metrics::radius_factor(skeleton, cone, near) == std::numeric_limits<double>::infinity());
  skeleton[2].radius = 3; // at five eighths of the length, with the edge that leaves the axis
  CHECK(metrics::radius_factor(skeleton, cone, near) == Approx(2));
  CHECK(std::isnan(metrics::radius_factor(Skeleton(), cone, near)));
}

} // namespace scans_test
