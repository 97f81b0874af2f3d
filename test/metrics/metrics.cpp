// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The metrics of the benchmark, on skeletons of which they are known.

#include "axis_distance.h"
#include "catch2.h"
#include "graph_counts.h"
#include "inside_share.h"
#include "nearest_point_radii.h"
#include "skeleton_distance.h"
#include "spurs.h"
#include "unexplained_points.h"

#include <CGAL/Curve_skeleton_3.h>
#include <CGAL/Simple_cartesian.h>

#include <boost/graph/adjacency_list.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <limits>
#include <random>
#include <vector>

namespace metrics_test {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Skeleton = CGAL::Curve_skeleton_3<Kernel>;

namespace {

// Adds a branch from `start` through the points; returns its last vertex.
std::size_t add_branch(Skeleton& skeleton, std::size_t start, const std::vector<Point>& points,
                       double radius)
{
  for(const Point& p : points) {
    const std::size_t next = add_vertex(skeleton);
    skeleton[next].point = p;
    skeleton[next].radius = radius;
    add_edge(start, next, skeleton);
    start = next;
  }
  return start;
}

Skeleton path(const std::vector<Point>& points, double radius = 0.1)
{
  Skeleton skeleton(1);
  skeleton[0].point = points.front();
  skeleton[0].radius = radius;
  add_branch(skeleton, 0, {points.begin() + 1, points.end()}, radius);
  return skeleton;
}

// The axis of a tube with round caps, and places where limbs meet.
struct Axis_piece
{
  Point a, b;
  double radius_a, radius_b;
};

struct Junction
{
  Point position;
  double radius;
};

using Axis = std::vector<Axis_piece>;
const std::vector<Junction> no_junctions;

const Axis tube = {{Point(0, 0, 0), Point(1, 0, 0), 0.1, 0.1}};

} // namespace

TEST_CASE("Components, cycles, ends and junctions of a graph")
{
  Skeleton skeleton = path({Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0)});
  add_edge(3, 0, skeleton);                              // a square,
  add_branch(skeleton, 0, {Point(-1, 0, 0)}, 0.1);       // with a tail,
  skeleton[add_vertex(skeleton)].point = Point(5, 5, 5); // and a vertex on its own
  const Graph_counts counts = count_graph(skeleton);
  CHECK(counts.components == 2);
  CHECK(counts.cycles == 1);
  CHECK(counts.ends == 1);
  CHECK(counts.junctions == 1);
  CHECK(counts.length == Approx(5));
}

TEST_CASE("Samples of a skeleton stand for all of its length, and nothing else")
{
  Skeleton skeleton = path({Point(0, 0, 0), Point(3, 0, 0), Point(3, 4, 0)});
  const double step = GENERATE(0.01, 0.3, 100.);
  CAPTURE(step);
  double length = 0;
  for(const metrics::Skeleton_sample& sample : metrics::sample_skeleton(skeleton, step)) {
    length += sample.length;
    CHECK(sample.length <= step);
    CHECK(sample.direction.squared_length() == Approx(1));
    const Point& p = sample.point;
    CHECK(((p.y() == 0 && p.x() >= 0 && p.x() <= 3) || (p.x() == 3 && p.y() >= 0 && p.y() <= 4)));
  }
  CHECK(length == Approx(7));
}

TEST_CASE("Samples of a loop, and of a vertex on its own")
{
  Skeleton loop = path({Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0)});
  add_edge(3, 0, loop);
  double length = 0;
  for(const metrics::Skeleton_sample& sample : metrics::sample_skeleton(loop, 0.1))
    length += sample.length;
  CHECK(length == Approx(4));

  Skeleton alone(1);
  alone[0].point = Point(1, 2, 3);
  const auto samples = metrics::sample_skeleton(alone, 0.1);
  REQUIRE(samples.size() == 1);
  CHECK(samples[0].point == Point(1, 2, 3));
  CHECK(samples[0].length == 0.1);
}

TEST_CASE("The nearest of many segments, some of which are points")
{
  const unsigned int seed = GENERATE(1u, 2u, 3u);
  CAPTURE(seed);
  std::mt19937 generator(seed);
  const auto random_point = [&generator] {
    const auto coordinate = [&generator] { return static_cast<double>(generator()) / 4294967296.; };
    const double x = coordinate(), y = coordinate(), z = coordinate();
    return Point(x, y, z);
  };
  std::vector<metrics::Segment> segments;
  for(int i = 0; i < 100; ++i) {
    const Point a = random_point(), b = random_point();
    segments.emplace_back(a, i % 10 == 0 ? a : b);
  }
  const metrics::Segment_tree tree(segments);
  for(int i = 0; i < 100; ++i) {
    const Point p = random_point();
    double least = std::numeric_limits<double>::infinity();
    for(const metrics::Segment& segment : segments)
      least = std::min(least, std::sqrt(CGAL::squared_distance(p, segment)));
    const metrics::Nearest nearest = tree.nearest(p);
    CHECK(nearest.distance == Approx(least));
    const metrics::Segment& found = segments[nearest.segment];
    const Point place = found.source() + nearest.parameter * found.to_vector();
    CHECK(std::sqrt(CGAL::squared_distance(p, place)) == Approx(least));
  }
  CHECK(metrics::Segment_tree({}).nearest(Point(0, 0, 0)).distance ==
        std::numeric_limits<double>::infinity());
}

TEST_CASE("The axis of a tube is at no distance from it")
{
  const auto distance =
      metrics::axis_distance(path({Point(0, 0, 0), Point(1, 0, 0)}), tube, no_junctions);
  CHECK(distance.mean == Approx(0).margin(1e-12));
  CHECK(distance.maximum == Approx(0).margin(1e-12));
}

TEST_CASE("A line beside the axis is off by its offset in radii, whatever the unit")
{
  const double unit = GENERATE(1., 1e-3, 1e3);
  CAPTURE(unit);
  const Axis axis = {{Point(0, 0, 0), Point(unit, 0, 0), 0.1 * unit, 0.1 * unit}};
  const Skeleton skeleton = path(
      {Point(0, 0, 0.03 * unit), Point(0.4 * unit, 0, 0.03 * unit), Point(unit, 0, 0.03 * unit)});
  const auto distance = metrics::axis_distance(skeleton, axis, no_junctions);
  CHECK(distance.mean == Approx(0.3));
  CHECK(distance.maximum == Approx(0.3));
  CHECK(distance.centred == 1);
}

TEST_CASE("What is further than half a radius off the axis is not centred")
{
  const Skeleton skeleton = path({Point(0, 0.06, 0), Point(0.5, 0.06, 0), Point(0.5, 0, 0.04),
                                  Point(1, 0, 0.04)});
  CHECK(metrics::axis_distance(skeleton, tube, no_junctions).centred == Approx(0.5).margin(0.03));
}

TEST_CASE("The distance to the axis is relative to the radius at the place")
{
  const Axis cone = {{Point(0, 0, 0), Point(1, 0, 0), 0.1, 0.2}};
  const auto distance =
      metrics::axis_distance(path({Point(0, 0.05, 0), Point(1, 0.05, 0)}), cone, no_junctions);
  CHECK(distance.mean == Approx(0.05 * std::log(2.) / 0.1).epsilon(1e-3)); // of 0.05 / radius
  CHECK(distance.maximum == Approx(0.05 / 0.1).epsilon(0.05));
}

TEST_CASE("A skeleton may go on to the tip of a limb, and no further")
{
  const auto to_tip =
      metrics::axis_distance(path({Point(-0.1, 0, 0), Point(1.1, 0, 0)}), tube, no_junctions);
  CHECK(to_tip.maximum == Approx(0).margin(1e-12));
  const auto beyond =
      metrics::axis_distance(path({Point(0, 0, 0), Point(1.3, 0, 0)}), tube, no_junctions);
  CHECK(beyond.maximum == Approx(2).epsilon(0.1)); // a sample every quarter of a radius

  // Where the axis goes on there is no tip.
  const Axis bent = {{Point(0, 0, 0), Point(1, 0, 0), 0.1, 0.1},
                     {Point(1, 0, 0), Point(1, 1, 0), 0.1, 0.1}};
  const auto past_bend =
      metrics::axis_distance(path({Point(0, 0, 0), Point(1.1, 0, 0)}), bent, no_junctions);
  CHECK(past_bend.maximum == Approx(1).epsilon(0.2));
}

TEST_CASE("The distance to the axis is not asked for at junctions")
{
  const std::vector<Junction> junctions = {{Point(0.5, 0, 0), 0.1}};
  const Skeleton skeleton = path(
      {Point(0, 0, 0), Point(0.4, 0, 0), Point(0.5, 0.1, 0), Point(0.6, 0, 0), Point(1, 0, 0)});
  CHECK(metrics::axis_distance(skeleton, tube, no_junctions).maximum > 0.9);
  CHECK(metrics::axis_distance(skeleton, tube, junctions).maximum == Approx(0).margin(1e-12));
  const Skeleton all_there = path({Point(0.45, 0, 0), Point(0.55, 0, 0)});
  CHECK(std::isnan(metrics::axis_distance(all_there, tube, junctions).mean));
  CHECK(std::isnan(metrics::axis_distance(all_there, tube, junctions).maximum));
}

TEST_CASE("Half of a segment that sticks out half is inside")
{
  const auto inside = [](const metrics::Point& p) { return p.x() < 0.5; };
  CHECK(metrics::inside_share(path({Point(0, 0, 0), Point(1, 0, 0)}), inside, 0.01) ==
        Approx(0.5).margin(0.01));
  CHECK(metrics::inside_share(path({Point(0, 0, 0), Point(0.4, 0, 0)}), inside, 0.01) == 1);
  CHECK(metrics::inside_share(path({Point(0.6, 0, 0), Point(1, 0, 0)}), inside, 0.01) == 0);
  // By length, not by vertices.
  CHECK(metrics::inside_share(path({Point(0, 0, 0), Point(0.1, 0, 0), Point(0.2, 0, 0),
                                    Point(0.3, 0, 0), Point(1, 0, 0)}),
                              inside, 0.01) == Approx(0.5).margin(0.01));
  CHECK(metrics::inside_share(Skeleton(1), inside, 0.01) == 1);
  CHECK(std::isnan(metrics::inside_share(Skeleton(), inside, 0.01)));
}

TEST_CASE("Points of a limb without a branch are unexplained")
{
  constexpr double radius = 0.1;
  std::vector<Point> points;
  for(int i = 0; i < 10000; ++i) // on a tube around the x axis from 0 to 10
    points.emplace_back(10 * (i + 0.5) / 10000, radius * std::cos(i), radius * std::sin(i));

  const Skeleton whole = path({Point(0, 0, 0), Point(10, 0, 0)}, radius);
  CHECK(metrics::unexplained_points(points, whole) == 0);

  // A half explains its points, and those less than two radii from its end.
  const Skeleton half = path({Point(0, 0, 0), Point(5, 0, 0)}, radius);
  const double reach = std::sqrt(4 - 1) * radius;
  CHECK(metrics::unexplained_points(points, half) == Approx((5 - reach) / 10).margin(1e-3));

  // A radius that shrinks to nothing explains up to where it is half of the true one.
  Skeleton cone = whole;
  cone[1].radius = 0;
  CHECK(metrics::unexplained_points(points, cone) == Approx(0.5).margin(0.01));

  CHECK(metrics::unexplained_points(points, Skeleton()) == 1);
}

TEST_CASE("A branch that does not leave the ball of its junction is a spur")
{
  Skeleton skeleton = path({Point(0, 0, 0), Point(1, 0, 0)}, 0.3);
  add_branch(skeleton, 1, {Point(2, 0, 0)}, 0.3);
  CHECK(metrics::count_spurs(skeleton) == 0); // no junction
  add_branch(skeleton, 1, {Point(1, 0.2, 0), Point(1, 0.4, 0)}, 0.3);
  CHECK(metrics::count_spurs(skeleton) == 0); // long enough
  add_branch(skeleton, 1, {Point(1, -0.1, 0), Point(1, -0.2, 0)}, 0.3);
  CHECK(metrics::count_spurs(skeleton) == 1);
  skeleton[1].radius = 0.5;
  CHECK(metrics::count_spurs(skeleton) == 2);
}

TEST_CASE("Distances between two skeletons")
{
  const Skeleton line = path({Point(0, 0, 0), Point(1, 0, 0)});
  const auto none = metrics::two_way_distance(line, line, 0.01);
  CHECK(none.mean == Approx(0).margin(1e-12));
  CHECK(none.maximum == Approx(0).margin(1e-12));

  const auto beside =
      metrics::two_way_distance(line, path({Point(0, 0.2, 0), Point(1, 0.2, 0)}), 0.01);
  CHECK(beside.mean == Approx(0.2));
  CHECK(beside.maximum == Approx(0.2));

  // What only one of them has counts, whichever it is.
  const Skeleton longer = path({Point(0, 0, 0), Point(1, 0, 0), Point(2, 0, 0)});
  CHECK(metrics::one_way_distance(line, longer, 0.01).maximum == Approx(0).margin(1e-12));
  CHECK(metrics::one_way_distance(longer, line, 0.01).maximum == Approx(1).margin(0.01));
  CHECK(metrics::one_way_distance(longer, line, 0.01).mean == Approx(0.25).margin(0.01));
  for(const auto& distance : {metrics::two_way_distance(line, longer, 0.01),
                              metrics::two_way_distance(longer, line, 0.01)}) {
    CHECK(distance.mean == Approx(0.25).margin(0.01));
    CHECK(distance.maximum == Approx(1).margin(0.01));
  }
}

TEST_CASE("A radius is the distance to the nearest point")
{
  Skeleton skeleton = path({Point(0, 0, 0), Point(1, 0, 0)}, 0);
  metrics::set_nearest_point_radii(skeleton, std::vector<Point>{Point(0, 0.5, 0), Point(3, 0, 0)});
  CHECK(skeleton[0].radius == Approx(0.5));
  CHECK(skeleton[1].radius == Approx(std::sqrt(1.25)));
}

TEST_CASE("The metrics that need no radius apply to graphs that have none")
{
  struct Place
  {
    Point point;
  };
  boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, Place> skeleton(2);
  skeleton[1].point = Point(1, 0, 0);
  add_edge(0, 1, skeleton);
  CHECK(metrics::axis_distance(skeleton, tube, no_junctions).maximum == Approx(0).margin(1e-12));
  CHECK(metrics::one_way_distance(skeleton, skeleton, 0.1).maximum == Approx(0).margin(1e-12));
  CHECK(metrics::inside_share(
            skeleton, [](const metrics::Point&) { return true; }, 0.1) == 1);
}

} // namespace metrics_test
