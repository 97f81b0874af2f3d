// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Sums of integers have the moments that points have, and no rounding.

#include "catch2.h"

#include <CGAL/Point_set_skeletonization_3/internal/core/Moments.h>
#include <CGAL/Point_set_skeletonization_3/internal/mixture/Exact_moments.h>

#include <Eigen/Core>

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace exact_moments_test {

using namespace CGAL::Point_set_skeletonization_3::internal;

namespace {

constexpr unsigned int seeds[] = {1, 2, 3};

// Far from the origin of the lattice compared to their extent.
std::vector<Vector3> cluster(unsigned int seed, double extent)
{
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-0.5, 0.5);
  const Vector3 center(uniform(generator), uniform(generator), uniform(generator));
  std::vector<Vector3> points;
  for(int i = 0; i < 1000; ++i)
    points.push_back(center + extent * Vector3(uniform(generator), uniform(generator), 0));
  return points;
}

bool have_same_bits(const Gaussian& a, const Gaussian& b)
{
  return a.weight == b.weight && a.mean == b.mean && a.covariance == b.covariance;
}

} // namespace

TEST_CASE("A place of the lattice is the nearest one")
{
  for(const double x : {0.0, 1.0, -1.0, 0.1, -0.3, 1e-13, -1e-13, 1e-300, 0.4999999999999999}) {
    CAPTURE(x);
    const Lattice_point p = lattice_point(Vector3(x, -x, 0));
    CHECK(std::abs(static_cast<double>(p[0]) / lattice_steps - x) <= 0.5 / lattice_steps);
    CHECK(p[1] == -p[0]);
    CHECK(p[2] == 0);
  }
}

TEST_CASE("The moments are those of the points, as exact as the lattice")
{
  for(const unsigned int seed : seeds)
    for(const double extent : {1.0, 1e-3, 1e-7}) {
      CAPTURE(seed, extent);
      const std::vector<Vector3> points = cluster(seed, extent);
      Exact_moments exact;
      Moments expected; // about a point in the middle of them
      for(const Vector3& p : points) {
        exact.add(lattice_point(p));
        expected.add(1, p - points.front());
      }
      const Gaussian found = exact.gaussian(), close = expected.gaussian(points.front());
      CHECK(found.weight == close.weight);
      CHECK((found.mean - close.mean).norm() < 1 / lattice_steps);
      CHECK((found.covariance - close.covariance).norm() < 2 * extent / lattice_steps);
      CHECK(found.covariance.row(2).norm() == 0); // a plane stays one
    }
}

TEST_CASE("Sums of parts have the same bits as the sum of all")
{
  for(const unsigned int seed : seeds) {
    CAPTURE(seed);
    std::mt19937 generator(seed);
    Exact_moments all;
    std::vector<Exact_moments> parts(7);
    for(const Vector3& p : cluster(seed, 1)) {
      all.add(lattice_point(p));
      parts[generator() % parts.size()].add(lattice_point(p));
    }
    Exact_moments forth, back;
    for(std::size_t i = 0; i < parts.size(); ++i) {
      forth.add(parts[i]);
      back.add(parts[parts.size() - 1 - i]);
    }
    CHECK(have_same_bits(forth.gaussian(), all.gaussian()));
    CHECK(have_same_bits(back.gaussian(), all.gaussian()));
  }
}

TEST_CASE("As many points as may ever be, in the corners of the box")
{
  const Vector3 corner(0.5, -0.5, 0.5);
  Exact_moments moments, others;
  moments.add(lattice_point(corner));
  others.add(lattice_point(-corner));
  for(int doubled = 0; doubled < 39; ++doubled) { // 2^40 points in all
    moments.add(Exact_moments(moments));
    others.add(Exact_moments(others));
  }
  moments.add(others);
  const Gaussian found = moments.gaussian();
  CHECK(found.weight == std::ldexp(1, 40));
  CHECK(found.mean == Vector3::Zero());
  CHECK(found.covariance == Matrix3(corner * corner.transpose()));
}

} // namespace exact_moments_test
