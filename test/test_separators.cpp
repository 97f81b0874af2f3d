// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What makes a loop: air that a rubber band in the solid does not cross, and limbs that are joined
// rather than only touch.

#include "catch2.h"
#include "generator/Random.h"
#include "graph_counts.h"
#include "shapes.h"

#include <CGAL/Point_set_skeletonization_3/internal/separators/Closed_curve.h>
#include <CGAL/Point_set_skeletonization_3/internal/separators/Separator_test.h>
#include <CGAL/Point_set_skeletonization_3/internal/separators/Ball_overlaps.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Winding_number.h>
#include <CGAL/extract_l1_medial_skeleton.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

using namespace CGAL::Point_set_skeletonization_3::internal;

namespace {

constexpr unsigned int seeds[] = {1, 2, 3};
constexpr double ring_radius = 1, tube_radius = 0.25;

Vector3 around(double angle)
{
  return Vector3(std::cos(angle), std::sin(angle), 0);
}

constexpr int along = 60, across = 18; // patches of a torus

std::size_t index(int i, int j)
{
  return static_cast<std::size_t>((i + along) % along * across + (j + across) % across);
}

// Patches of a torus around the z axis, with outward normals.
std::vector<Patch> torus()
{
  std::vector<Patch> patches;
  for(int i = 0; i < along; ++i)
    for(int j = 0; j < across; ++j) {
      const Vector3 radial = around(2 * CGAL_PI * i / along);
      const double angle = 2 * CGAL_PI * j / across;
      Patch patch;
      patch.normal = std::cos(angle) * radial + std::sin(angle) * Vector3::UnitZ();
      patch.mean = ring_radius * radial + tube_radius * patch.normal;
      patch.spacing = 2 * CGAL_PI * tube_radius / across;
      patch.area = 2 * CGAL_PI / along * (ring_radius + tube_radius * std::cos(angle)) *
                   patch.spacing;
      patch.planarity = 1;
      patch.neighbors = {index(i - 1, j), index(i, j - 1), index(i, j + 1), index(i + 1, j)};
      std::sort(patch.neighbors.begin(), patch.neighbors.end());
      patches.push_back(patch);
    }
  return patches;
}

// A sample in the middle of the tube for every patch of the torus.
std::vector<Sample> torus_samples(const std::vector<Patch>& patches)
{
  std::vector<Sample> samples(patches.size());
  for(std::size_t i = 0; i < patches.size(); ++i) {
    samples[i].origin = patches[i].mean;
    samples[i].position = patches[i].mean - tube_radius * patches[i].normal;
    samples[i].radius = tube_radius;
  }
  return samples;
}

// The patches of a cross-section of the torus, from one angle to another.
Local_separator torus_separator(int i, int first, int last)
{
  Local_separator result;
  for(int j = first; j < last; ++j) {
    result.patches.push_back(index(i, j));
    result.sides[0].push_back(index(i - 1, j));
    result.sides[1].push_back(index(i + 1, j));
  }
  return result;
}

// A torus with its winding number.
struct Solid_torus
{
  std::vector<Patch> patches = torus();
  Box_tree tree{patches.size(), [&](std::size_t i) { return patches[i].mean; }};
  Winding_number winding_number{patches, tree};

  Closed_curve band(const std::vector<Vector3>& curve) const
  {
    return Closed_curve(curve, patches.front().spacing, winding_number);
  }
};

bool shrinks(const std::vector<Vector3>& curve) { return Solid_torus().band(curve).shrinks(); }

// A part of the torus along a circle in its plane, from one angle to another.
std::vector<Vector3> arc(double radius, double from, double to)
{
  std::vector<Vector3> result;
  for(int i = 0; i < 20; ++i)
    result.push_back(radius * around(from + i * (to - from) / 20));
  return result;
}

// The skeleton of 10 000 points with cycles and ends counted.
template <typename Vectors>
Graph_counts counts_of(const Vectors& points)
{
  using Kernel = CGAL::Simple_cartesian<double>;
  CGAL::Curve_skeleton_3<Kernel> skeleton;
  REQUIRE(CGAL::extract_l1_medial_skeleton(shapes::to_points<Kernel>(points), skeleton));
  return count_graph(skeleton);
}

} // namespace

TEST_CASE("A rubber band around the hole of a torus stays")
{
  std::vector<Vector3> curve;
  for(int i = 0; i < 20; ++i)
    curve.push_back((ring_radius + (i % 2 == 0 ? 0.1 : -0.1)) * around(2 * CGAL_PI * i / 20));
  CHECK_FALSE(shrinks(curve));
}

TEST_CASE("A rubber band that goes there and back in a bent limb shrinks to a point")
{
  std::vector<Vector3> curve;
  for(int i = 0; i <= 20; ++i) // three quarters of the torus
    curve.push_back((ring_radius + 0.1) * around(1.5 * CGAL_PI * i / 20));
  for(int i = 20; i >= 0; --i)
    curve.push_back((ring_radius - 0.1) * around(1.5 * CGAL_PI * i / 20));
  CHECK(shrinks(curve));
}

TEST_CASE("A rubber band becomes another on the same way, wherever and whichever way it starts")
{
  const Solid_torus solid;
  const Closed_curve band = solid.band(arc(ring_radius, 0, 2 * CGAL_PI));
  CHECK(band.can_become(band));
  CHECK(band.can_become(solid.band(arc(ring_radius + 0.1, 1, 1 + 2 * CGAL_PI))));
  CHECK(band.can_become(solid.band(arc(ring_radius - 0.1, 2, 2 - 2 * CGAL_PI))));
  // There and back in three quarters of the torus.
  std::vector<Vector3> bent = arc(ring_radius, 0, 1.5 * CGAL_PI);
  const std::vector<Vector3> back(bent.rbegin(), bent.rend());
  bent.insert(bent.end(), back.begin(), back.end());
  CHECK_FALSE(band.can_become(solid.band(bent)));
}

TEST_CASE("A ring around a limb is a separator, an arc of it is none")
{
  const Solid_torus solid;
  const std::vector<Patch>& patches = solid.patches;
  const Winding_number& winding_number = solid.winding_number;
  const std::vector<Sample> samples = torus_samples(patches);
  const Ball_overlaps joints(patches, samples, 0);
  Separator_test<> way_around(patches, samples, joints, winding_number);
  const auto cuts = [&](const Local_separator& separator) {
    return way_around.cuts(separator, way_around.evidence({&separator}).front());
  };
  CHECK_FALSE(cuts(torus_separator(10, 0, across / 2)));
  CHECK(cuts(torus_separator(10, 0, across)));
  CHECK(cuts(torus_separator(30, 0, across)));
  CHECK_FALSE(cuts(torus_separator(30, 3, across - 3)));
}

TEST_CASE("Joints of balls: whole within a limb, nothing between limbs that touch")
{
  const Medial_ball ball{Vector3(0, 0, 0), 1};
  CHECK(relative_overlap(ball, ball) == 1);
  CHECK(relative_overlap(ball, {Vector3(0.1, 0, 0), 1}) > 0.99);
  CHECK(relative_overlap(ball, {Vector3(2, 0, 0), 1}) == 0);
  CHECK(relative_overlap(ball, {Vector3(50, 0, 0), 1}) == 0);
  // A small limb that leaves a large one.
  CHECK(relative_overlap(ball, {Vector3(0.9, 0, 0), 0.1}) == 1);
  // The circle where two unit balls at distance d meet has the radius sqrt(1 - d^2 / 4).
  CHECK(relative_overlap(ball, {Vector3(0, 1.6, 0), 1}) == Approx(0.6));
  CHECK(relative_overlap({Vector3(0, 1.6, 0), 1}, ball) == Approx(0.6));
}

TEST_CASE("A limb that is inside out is turned around")
{
  std::vector<Patch> patches = torus();
  std::size_t turned = 0;
  for(Patch& patch : patches)
    if(patch.mean.x() > 0.2 && ++turned)
      patch.normal = -patch.normal;
  REQUIRE(turned > patches.size() / 4);
  const Box_tree tree(patches.size(), [&](std::size_t i) { return patches[i].mean; });
  settle_orientation<CGAL::Sequential_tag>(patches, tree);
  const std::vector<Patch> right = torus();
  std::size_t wrong = 0;
  for(std::size_t i = 0; i < patches.size(); ++i)
    wrong += patches[i].normal.dot(right[i].normal) < 0;
  CHECK(wrong < turned / 10); // the seam
}

TEST_CASE("Turns of a spring that nearly touch make no loops")
{
  constexpr double r = 0.1, coil = 0.5, pitch = 2.7 * r, turns = 3;
  constexpr int sides = 24; // of a turn
  const auto at = [&](int i) {
    const double turn = static_cast<double>(i) / sides;
    return Vector3(coil * around(2 * CGAL_PI * turn) + pitch * turn * Vector3::UnitZ());
  };
  shapes::Shape spring;
  for(int i = 0; i < turns * sides; ++i)
    spring.push_back({at(i), at(i + 1), r});
  for(const unsigned int seed : seeds) {
    CAPTURE(seed);
    const Graph_counts counts = counts_of(shapes::sample(spring, 20000, seed));
    CHECK(counts.components == 1);
    CHECK(counts.cycles == 0);
    CHECK(counts.ends == 2);
  }
}

TEST_CASE("A screw hole in a plate is a loop")
{
  // A plate of 4 x 2 x 0.4 with a hole of radius 0.25.
  const double length = 4, width = 2, height = 0.4, radius = 0.25;
  const Vector3 hole(1, 1, 0);
  for(const unsigned int seed : seeds) {
    CAPTURE(seed);
    shapes::Random random(seed);
    std::vector<Vector3> points;
    const double faces = length * width, sides = length * height, ends = width * height;
    const double wall = 2 * CGAL_PI * radius * height;
    while(points.size() < 10000) {
      const double choice = random.uniform() * (2 * (faces + sides + ends) + wall);
      const double u = random.uniform(), v = random.uniform(), side = std::floor(2 * random.uniform());
      Vector3 p;
      if(choice < 2 * faces)
        p = Vector3(length * u, width * v, height * side);
      else if(choice < 2 * (faces + sides))
        p = Vector3(length * u, width * side, height * v);
      else if(choice < 2 * (faces + sides + ends))
        p = Vector3(length * side, width * u, height * v);
      else
        p = hole + radius * around(2 * CGAL_PI * u) + height * v * Vector3::UnitZ();
      if((p - hole).head<2>().norm() > 0.999 * radius)
        points.push_back(p);
    }
    const Graph_counts counts = counts_of(points);
    CHECK(counts.components == 1);
    CHECK(counts.cycles == 1);
  }
}
