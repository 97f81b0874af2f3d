// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The shapes whose skeleton is known: that it is what they say, and their clouds.

#include "catch2.h"
#include "generator/Axis_graph.h"
#include "generator/Random.h"
#include "generator/Round_cone.h"
#include "generator/Rounded_box.h"
#include "generator/Solid.h"
#include "generator/Voxels.h"
#include "generator/branching_tree.h"
#include "generator/check_counts.h"
#include "generator/clouds.h"
#include "generator/families.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace known_shapes_test {

using namespace shapes;

namespace {

/// Calls `check` with shapes of every family.
template <typename Check>
void for_shapes(unsigned seeds, const Check& check)
{
  for(const std::string& family : family_names())
    for(unsigned seed = 0; seed < seeds; ++seed) {
      CAPTURE(family, seed);
      check(known_shape(family, seed));
    }
}

double diagonal(const Known_shape& shape)
{
  return shape.solid.bounding_box().diagonal().norm();
}

bool is_near_junction(const Known_shape& shape, const Vector& p)
{
  return std::any_of(shape.junctions.begin(), shape.junctions.end(),
                     [&](const Junction& j) { return (p - j.position).norm() < 1.3 * j.radius; });
}

/// Calls `visit` with points along the axis and the radius there.
template <typename Visit>
void for_axis_points(const Known_shape& shape, const Visit& visit)
{
  for(const Axis_segment& s : shape.axis)
    for(double t : {0.0, 0.25, 0.5, 0.75})
      visit(Vector(s.a + t * (s.b - s.a)), s.radius_a + t * (s.radius_b - s.radius_a));
}

/// From an end to the next junction or, if there is none, to the other end.
struct Free_limb
{
  std::size_t foot;
  double length;
};

Free_limb free_limb(const Axis_graph& graph, std::size_t end)
{
  Free_limb limb = {end, 0};
  std::size_t previous = end;
  do {
    auto next = adjacent_vertices(limb.foot, graph).first;
    if(*next == previous && limb.foot != end)
      ++next;
    previous = limb.foot;
    limb.foot = *next;
    limb.length += (graph[limb.foot].position - graph[previous].position).norm();
  } while(out_degree(limb.foot, graph) == 2);
  return limb;
}

} // namespace

TEST_CASE("The axis has the counts that its family states")
{
  for_shapes(40, check_counts);
}

TEST_CASE("A branching tree has two to the power of its levels ends, far apart")
{
  for(const int levels : {1, 2, 5}) {
    CAPTURE(levels);
    const Known_shape tree = branching_tree(levels, 1);
    check_counts(tree);
    CHECK(tree.ends == std::size_t(1) << levels);
    CHECK(tree.junctions.size() == tree.ends - 2);
    if(levels > 1)
      CHECK(narrowest_gap(tree) > 3);
    CHECK(branching_tree(levels, 2).axis.front().b != tree.axis.front().b);
  }
}

TEST_CASE("A family that does not exist is refused")
{
  CHECK(family_names().size() >= 12);
  CHECK_THROWS_AS(known_shape("dragon", 0), std::invalid_argument);
}

TEST_CASE("The solid has the topology of its axis, even when limbs have grown into the gaps")
{
  for_shapes(8, [&](const Known_shape& shape) {
    const double radius = least_radius(shape);
    const long expected = static_cast<long>(shape.components) - static_cast<long>(shape.cycles);
    const Voxels grown(shape.solid, 0.4 * radius, 0.25 * radius);
    CHECK(grown.euler_number() == expected);
  });
}

TEST_CASE("Between limbs that do not meet there is a gap")
{
  for_shapes(8, [](const Known_shape& shape) { CHECK(narrowest_gap(shape) >= 0.99); });
}

TEST_CASE("The axis is as deep inside as its radius says")
{
  for_shapes(20, [&](const Known_shape& shape) {
    std::size_t too_shallow = 0, too_deep = 0;
    for_axis_points(shape, [&](const Vector& p, double radius) {
      const double depth = -shape.solid.signed_distance(p);
      too_shallow += depth < 0.99 * radius;
      too_deep += depth > 1.05 * radius && !is_near_junction(shape, p);
    });
    CHECK(too_shallow == 0);
    CHECK(too_deep == 0);
  });
}

TEST_CASE("Limbs are thick enough for noise, and free ends stick out")
{
  for_shapes(100, [&](const Known_shape& shape) {
    CHECK(least_radius(shape) >= 0.025 * diagonal(shape));
    const Axis_graph graph = axis_graph(shape);
    for(std::size_t v = 0; v < num_vertices(graph); ++v)
      if(out_degree(v, graph) == 1) {
        const Free_limb limb = free_limb(graph, v);
        CHECK(limb.length + graph[v].radius >= (1 + 2.5) * graph[limb.foot].radius);
      }
  });
}

TEST_CASE("The distance to a solid is 1-Lipschitz and zero on its surface")
{
  for_shapes(3, [&](const Known_shape& shape) {
    Random random(shape.seed);
    const double size = diagonal(shape);
    double farthest = 0, steepest = 0;
    for(int i = 0; i < 1000; ++i) {
      const Vector p = shape.solid.random_point(random);
      const Vector q = p + 0.05 * size * random.normal_vector();
      const double at_p = shape.solid.signed_distance(p), at_q = shape.solid.signed_distance(q);
      farthest = std::max(farthest, std::abs(at_p));
      steepest = std::max(steepest, std::abs(at_q - at_p) / (q - p).norm());
    }
    CHECK(farthest < 1e-9);
    CHECK(steepest < 1 + 1e-9);
  });
}

TEST_CASE("The surface is sampled uniformly by area")
{
  constexpr int size = 40000;
  Random random(1);
  SECTION("of a round cone: the height of a point on a ball, and the radius along a cone")
  {
    // The balls have radii 1 and 0.5, the sine of the cone's slope is 0.25.
    const Round_cone cone(Vector::Zero(), Vector(2, 0, 0), 1, 0.5);
    const double cap_a = full_turn * 1.25, cap_b = full_turn * 0.25 * 0.75;
    const double side = full_turn / 2 * 1.5 * 2 * (1 - 0.0625);
    CHECK(cone.area() == Approx(cap_a + cap_b + side));
    int below = 0, on_cap_b = 0, on_thick_half = 0;
    for(int i = 0; i < size; ++i) {
      const double x = cone.random_point(random).x();
      below += x < 0; // half of a ball
      on_cap_b += x > 2 + 0.5 * 0.25;
      on_thick_half += x > 0.25 && x < 1.1875; // of the side, which has the radii 1, 0.75, 0.5
    }
    CHECK(below / double(size) == Approx(full_turn / cone.area()).epsilon(0.05));
    CHECK(on_cap_b / double(size) == Approx(cap_b / cone.area()).epsilon(0.1));
    CHECK(on_thick_half / double(size) == Approx(side * 1.75 / 3 / cone.area()).epsilon(0.05));
  }
  SECTION("of a rounded box: faces, edges and corners")
  {
    const Rounded_box box(Vector::Zero(), Eigen::Matrix3d::Identity(), Vector(1, 0.6, 0.4), 0.2);
    const Vector core(0.8, 0.4, 0.2);
    int on_faces[3] = {0, 0, 0}, on_corners = 0;
    for(int i = 0; i < size; ++i) {
      const Vector p = box.random_point(random).cwiseAbs();
      for(int axis = 0; axis < 3; ++axis)
        on_faces[axis] += std::abs(p[axis] - core[axis] - 0.2) < 1e-12;
      on_corners += (p - core).minCoeff() > 0;
    }
    for(int axis = 0; axis < 3; ++axis)
      CHECK(on_faces[axis] / double(size) ==
            Approx(8 * core.prod() / core[axis] / box.area()).epsilon(0.1));
    CHECK(on_corners / double(size) == Approx(2 * full_turn * 0.04 / box.area()).epsilon(0.1));
  }
  SECTION("of a union: without what is inside")
  {
    // Two balls through each other's centres: three quarters of each are outside.
    Solid solid;
    solid.add(Round_cone(Vector::Zero(), Vector(0.001, 0, 0), 1, 1));
    solid.add(Round_cone(Vector(1, 0, 0), Vector(1.001, 0, 0), 1, 1));
    CHECK(solid.area(random) == Approx(0.75 * 4 * full_turn).epsilon(0.02));
  }
  SECTION("of a union: no point inside, none counted twice where primitives coincide")
  {
    // A cylinder in two pieces is the same cylinder.
    Solid solid;
    solid.add(Round_cone(Vector(-1, 0, 0), Vector::Zero(), 0.5, 0.5));
    solid.add(Round_cone(Vector::Zero(), Vector(1, 0, 0), 0.5, 0.5));
    int in_the_middle = 0;
    for(int i = 0; i < size; ++i)
      in_the_middle += std::abs(solid.random_point(random).x()) < 0.5;
    CHECK(in_the_middle / double(size) == Approx(1 / 3.0).epsilon(0.05));
  }
}

TEST_CASE("A cloud has the size that was asked for and depends on the seeds alone")
{
  constexpr std::size_t size = 1234;
  for_shapes(2, [&](const Known_shape& shape) {
    const Known_shape again = known_shape(shape.family, shape.seed);
    const Known_shape other = known_shape(shape.family, shape.seed + 1000);
    for(Variant variant : all_variants()) {
      CAPTURE(to_string(variant));
      const std::vector<Vector> points = sample(shape, variant, size, 1);
      CHECK(points.size() == size);
      CHECK(points == sample(again, variant, size, 1));
      CHECK(points != sample(shape, variant, size, 2));
      CHECK(points != sample(other, variant, size, 1));
    }
  });
}

TEST_CASE("Clean points are on the surface, outliers are not")
{
  constexpr std::size_t size = 3000;
  for_shapes(2, [&](const Known_shape& shape) {
    const auto count_off_surface = [&](const std::vector<Vector>& points) {
      return std::count_if(points.begin(), points.end(), [&](const Vector& p) {
        return std::abs(shape.solid.signed_distance(p)) > 1e-9;
      });
    };
    CHECK(count_off_surface(sample(shape, Variant::clean, size, 3)) == 0);
    const std::vector<Vector> points = sample(shape, Variant::outliers, size, 3);
    CHECK(count_off_surface(points) == size / 50);
    const Eigen::AlignedBox3d box = shape.solid.bounding_box();
    for(const Vector& p : points)
      CHECK(((p - box.center()).cwiseAbs().array() <= 0.6 * box.diagonal().array()).all());
  });
}

TEST_CASE("Noise has the standard deviation it is named after")
{
  constexpr std::size_t size = 5000;
  for_shapes(1, [&](const Known_shape& shape) {
    // The same seed: the same points, moved.
    const std::vector<Vector> clean = sample(shape, Variant::clean, size, 4);
    const auto deviation = [&](Variant variant) {
      const std::vector<Vector> noisy = sample(shape, variant, size, 4);
      double sum = 0;
      for(std::size_t i = 0; i < size; ++i)
        sum += (noisy[i] - clean[i]).squaredNorm();
      return std::sqrt(sum / (3 * size)) / diagonal(shape);
    };
    CHECK(deviation(Variant::noise_half_percent) == Approx(0.005).epsilon(0.03));
    CHECK(deviation(Variant::noise_one_percent) == Approx(0.01).epsilon(0.03));
  });
}

TEST_CASE("Holes are empty and cut no limb through")
{
  constexpr std::size_t size = 20000;
  for_shapes(2, [&](const Known_shape& shape) {
    const unsigned seed = shape.seed + 5;
    Random random(seed); // as sample() does
    const std::vector<Ball> holes = random_holes(shape, random);
    const std::vector<Vector> clean = sample(shape, Variant::clean, size, seed);
    const std::vector<Vector> points = sample(shape, Variant::holes, size, seed);
    const auto count = [](const std::vector<Vector>& cloud, const Ball& ball) {
      return std::count_if(cloud.begin(), cloud.end(),
                           [&](const Vector& p) { return ball.contains(p); });
    };
    CHECK(holes.size() >= 4); // as many as there is room for
    CHECK(holes.size() <= 10);
    for(const Ball& hole : holes) {
      CHECK(count(clean, hole) > 10);
      CHECK(count(points, hole) == 0);
    }
    for_axis_points(shape, [&](const Vector& p, double radius) {
      const Ball around = {p, 1.3 * radius};
      if(!is_near_junction(shape, p))
        CHECK(3 * count(points, around) > count(clean, around));
    });
  });
}

TEST_CASE("The density falls by a factor of eight")
{
  constexpr std::size_t size = 20000;
  for_shapes(1, [&](const Known_shape& shape) {
    constexpr unsigned seed = 6;
    Random random(seed); // as sample() does
    const Vector direction = random.direction();
    std::vector<double> clean, falling;
    for(const Vector& p : sample(shape, Variant::clean, size, seed))
      clean.push_back(p.dot(direction));
    for(const Vector& p : sample(shape, Variant::falling_density, size, seed))
      falling.push_back(p.dot(direction));
    const auto [low, high] = std::minmax_element(clean.begin(), clean.end());
    // The falling density relative to the clean one, in a slice from `begin` to `end` of the
    // extent.
    const auto density = [&, from = *low, extent = *high - *low](double begin, double end) {
      const auto count = [&](const std::vector<double>& places) {
        return static_cast<double>(std::count_if(places.begin(), places.end(), [&](double place) {
          return place >= from + begin * extent && place < from + end * extent;
        }));
      };
      return count(falling) / count(clean);
    };
    const double first = density(0, 0.1), last = density(0.9, 1), middle = density(0.45, 0.55);
    CHECK(first / last > 5);
    CHECK(first / last < 10);
    CHECK(first / middle == Approx(middle / last).epsilon(0.35)); // smoothly
  });
}

} // namespace known_shapes_test
