// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The scanner: what it sees, and what it makes of it.

#include "catch2.h"
#include "generator/Drop_outs.h"
#include "generator/Random.h"
#include "generator/Ray.h"
#include "generator/Round_cone.h"
#include "generator/Rounded_box.h"
#include "generator/Triangle.h"
#include "generator/check_counts.h"
#include "generator/scanned_families.h"
#include "generator/scanner.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace scanner_test {

using namespace shapes;

namespace {

constexpr unsigned seed = 1;

/// A ray that often meets something near the origin.
Ray random_ray(Random& random)
{
  const Vector origin = 5 * random.direction();
  const Vector target = 0.7 * random.normal_vector();
  return {origin, (target - origin).normalized()};
}

/// The ray meets the primitive first where it says.
template <typename Primitive>
void check_first_hit(const Primitive& primitive)
{
  Random random(seed);
  int hits = 0;
  for(int i = 0; i < 1000; ++i) {
    const Ray ray = random_ray(random);
    const double hit = first_hit(primitive, ray);
    double least = no_hit;
    for(double place = 0; place < std::min(10.0, hit - 0.001); place += 0.01)
      least = std::min(least, primitive.signed_distance(ray.at(place)));
    CHECK(least > 0);
    if(hit < no_hit) {
      ++hits;
      CHECK(std::abs(primitive.signed_distance(ray.at(hit))) < 1e-5);
    }
  }
  CHECK(hits > 300);
  CHECK(hits < 700);
}

/// Two squares, the nearer one hiding a half of the other: all that is seen is on one of them.
Known_shape two_squares()
{
  Known_shape shape;
  for(const double x : {0.0, 1.0}) {
    const Vector corner(x, x, 0), along(0, 2, 0), up(0, 0, 2);
    shape.sheets.push_back({corner, corner + along, corner + up});
    shape.sheets.push_back({corner + along + up, corner + along, corner + up});
  }
  return shape;
}

double distance_to_surface(const Known_shape& shape, const Vector& p)
{
  return std::abs(shape.solid.signed_distance(p));
}

Scan_options with_points(std::size_t points, int places)
{
  Scan_options options;
  options.points = points;
  options.places = places;
  return options;
}

} // namespace

TEST_CASE("A ray meets a primitive where it enters")
{
  SECTION("a round cone")
  {
    check_first_hit(Round_cone(Vector(-1, 0, 0.2), Vector(0.5, 0.5, 0), 0.6, 0.3));
  }
  SECTION("a rounded box")
  {
    check_first_hit(
        Rounded_box(Vector(0.1, 0, 0), Random(seed).rotation(), Vector(1, 0.5, 0.4), 0.1));
  }
}

TEST_CASE("A ray meets a triangle from both sides, and only inside")
{
  const Triangle triangle = {Vector(0, 0, 1), Vector(2, 0, 1), Vector(0, 2, 3)};
  const auto from = [&](double z, double x, double y) {
    return first_hit(triangle, {Vector(x, y, z), Vector(0, 0, z < 0 ? 1 : -1)});
  };
  CHECK(from(-1, 0.5, 0.5) == Approx(2.5));
  CHECK(from(5, 0.5, 0.5) == Approx(3.5));
  CHECK(from(-1, 0.1, 1.8) == Approx(3.8));
  CHECK(from(-1, 1.1, 1) == no_hit);
  CHECK(from(-1, -0.1, 1) == no_hit);
  CHECK(from(-1, 1, -0.1) == no_hit);
  CHECK(first_hit(triangle, {Vector(0.5, 0.5, 4), Vector::UnitZ()}) == no_hit); // behind
}

TEST_CASE("The axis of a scanned shape has the counts that its family states")
{
  for(const std::string& family : scanned_family_names())
    for(unsigned s = 0; s < 10; ++s) {
      CAPTURE(family, s);
      check_counts(scanned_shape(family, s));
    }
  CHECK_THROWS_AS(scanned_shape("dragon", 0), std::invalid_argument);
}

TEST_CASE("Limbs of a scanned shape that do not meet do not touch")
{
  for(const char* family : {"crown_in_leaf", "lattice", "leafy_plant", "tube_frame", "wire_frame"}) {
    CAPTURE(family, seed);
    CHECK(narrowest_gap(scanned_shape(family, seed)) > 0);
  }
}

TEST_CASE("A scan has about as many points as were asked for, and depends on the seeds alone")
{
  for(const char* family : {"tree", "leafy_plant", "wire_frame", "hand"})
    for(const int places : {1, 3, 6}) {
      CAPTURE(family, places, seed);
      const Known_shape shape = scanned_shape(family, seed);
      const Scan_options options = with_points(5000, places);
      const Scan first = scan(shape, options, seed);
      CHECK(first.places.size() == static_cast<std::size_t>(places));
      CHECK(static_cast<double>(first.points.size()) == Approx(5000).epsilon(0.2));
      CHECK(first.points == scan(scanned_shape(family, seed), options, seed).points);
      CHECK(first.points != scan(shape, options, seed + 1).points);
    }
}

TEST_CASE("A clean scan is within the width of a pulse of what the scanner sees")
{
  for(const char* family : {"tree", "hand", "theta"}) {
    CAPTURE(family, seed);
    const Known_shape shape = scanned_shape(family, seed);
    const Scan seen = scan(shape, with_points(2000, 1), seed);
    double farthest = 0, deepest = 0; // in spacings
    for(const Vector& p : seen.points) {
      farthest = std::max(farthest, distance_to_surface(shape, p) / seen.spacing);
      for(double share = 0.6; share < 1; share += 0.01) { // of the way from the scanner
        const Vector q = seen.places.front() + share * (p - seen.places.front());
        if((p - q).norm() > 4 * seen.spacing)
          deepest = std::max(deepest, -shape.solid.signed_distance(q) / seen.spacing);
      }
    }
    CHECK(farthest < 1.2);
    CHECK(deepest < 1.2);
  }
}

TEST_CASE("From all around, all of a tree is seen")
{
  const Known_shape shape = scanned_shape("tree", seed);
  const Scan seen = scan(shape, with_points(20000, 6), seed);
  int hidden = 0;
  for(const Axis_segment& piece : shape.axis) {
    const double near = std::max(piece.radius_a, piece.radius_b) + 2 * seen.spacing;
    hidden += std::none_of(seen.points.begin(), seen.points.end(), [&](const Vector& p) {
      return (p - (piece.a + piece.b) / 2).norm() < near;
    });
  }
  CHECK(hidden < static_cast<int>(shape.axis.size() / 100));
}

TEST_CASE("A wire that is thinner than a pulse is a line of points")
{
  const Known_shape shape = scanned_shape("wire_frame", seed);
  const Scan seen = scan(shape, with_points(1500, 3), seed);
  CHECK(2 * least_radius(shape) < 0.6 * seen.spacing);
  int lost = 0;
  for(const Axis_segment& piece : shape.axis)
    lost += std::none_of(seen.points.begin(), seen.points.end(), [&](const Vector& p) {
      return (p - (piece.a + piece.b) / 2).norm() < 3 * seen.spacing;
    });
  CHECK(lost == 0);
}

TEST_CASE("Range noise is along the pulses, with the standard deviation that was asked for")
{
  const Known_shape shape = scanned_shape("hand", seed);
  Scan_options options = with_points(5000, 1);
  const Scan clean = scan(shape, options, seed);
  options.range_noise = 0.01;
  const Scan noisy = scan(shape, options, seed);
  REQUIRE(noisy.points.size() == clean.points.size());
  double sum = 0, aside = 0;
  for(std::size_t i = 0; i < clean.points.size(); ++i) {
    const Vector along = (clean.points[i] - clean.places.front()).normalized();
    const Vector moved = noisy.points[i] - clean.points[i];
    sum += moved.squaredNorm();
    aside = std::max(aside, moved.cross(along).norm());
  }
  const double deviation = std::sqrt(sum / static_cast<double>(clean.points.size()));
  CHECK(deviation == Approx(0.01 * bounding_box(shape).diagonal().norm()).epsilon(0.05));
  CHECK(aside < 1e-9);
}

TEST_CASE("Mixed pixels lie between what is before and what is behind")
{
  const Known_shape shape = two_squares();
  Scan_options options = with_points(5000, 3);
  const auto count_between = [&](unsigned s) {
    const Scan seen = scan(shape, options, s);
    return std::count_if(seen.points.begin(), seen.points.end(), [&](const Vector& p) {
      return p.x() > 2 * seen.spacing && p.x() < 1 - 2 * seen.spacing;
    });
  };
  for(unsigned s = 0; s < 5; ++s) {
    CAPTURE(s);
    options.mixed = 0;
    CHECK(count_between(s) == 0);
    options.mixed = 1;
    CHECK(count_between(s) > 5);
  }
}

TEST_CASE("Pulses are lost in runs")
{
  constexpr double share = 0.3;
  constexpr int pulses = 100000;
  Random random(seed);
  Drop_outs drop_outs(share);
  int lost = 0, runs = 0;
  bool before = false;
  for(int i = 0; i < pulses; ++i) {
    const bool is_lost = drop_outs.next(random);
    lost += is_lost;
    runs += is_lost && !before;
    before = is_lost;
  }
  CHECK(lost / double(pulses) == Approx(share).epsilon(0.05));
  CHECK(lost / double(runs) == Approx(5).epsilon(0.05));

  const Known_shape shape = scanned_shape("hand", seed);
  Scan_options options = with_points(5000, 3);
  const double all = static_cast<double>(scan(shape, options, seed).points.size());
  options.lost = share;
  CHECK(static_cast<double>(scan(shape, options, seed).points.size()) ==
        Approx((1 - share) * all).epsilon(0.1));
}

TEST_CASE("Of few beams as many points, in rows that are further apart than the points of a row")
{
  const Known_shape shape = scanned_shape("hand", seed);
  Scan_options options = with_points(5000, 3);
  const Scan even = scan(shape, options, seed);
  options.beams = 4;
  const Scan rows = scan(shape, options, seed);
  CHECK(static_cast<double>(rows.points.size()) ==
        Approx(static_cast<double>(even.points.size())).epsilon(0.1));
  CHECK(rows.spacing == Approx(even.spacing / 2).epsilon(0.1));
}

} // namespace scanner_test
