// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Densities, repulsion and growth of the samples against the sums that they stand for.

#include "catch2.h"

#include <CGAL/Point_set_skeletonization_3/internal/published/densities.h>
#include <CGAL/Point_set_skeletonization_3/internal/published/kernel_growth.h>
#include <CGAL/Point_set_skeletonization_3/internal/published/repulsion.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace surroundings_test {

using namespace CGAL::Point_set_skeletonization_3::internal;
using Points = std::vector<Vector3>;

namespace {

Vector3 random_vector(std::mt19937& generator, double half_width)
{
  std::uniform_real_distribution<double> uniform(-half_width, half_width);
  const double x = uniform(generator), y = uniform(generator), z = uniform(generator);
  return Vector3(x, y, z);
}

// Samples along curves with some scatter, one place taken twice, and their kernels in the order of
// the tree.
struct Samples
{
  explicit Samples(unsigned int seed) : tree(positions(seed)), packet_tree(tree)
  {
    std::mt19937 generator(seed + 1);
    kernels.places = tree.positions();
    for(std::size_t i = 0; i < kernels.places.size(); ++i)
      kernels.radii.push_back(0.05 * std::exp(1 + random_vector(generator, 1).x()));
  }

  static Points positions(unsigned int seed)
  {
    std::mt19937 generator(seed);
    Points result;
    for(int i = 0; i < 301; ++i) {
      const double t = random_vector(generator, 1).x();
      result.push_back(Vector3(0.5 * t, 0.3 * std::sin(3 * t), i % 2 * 0.1) +
                       random_vector(generator, 0.01));
    }
    result.push_back(result.front());
    return result;
  }

  Box_tree tree;
  Packet_tree packet_tree;
  Kernels kernels;
};

// nu of Eq. 11 for the first of the points, with the same kernel for all.
double growth_factor_of_first(const Points& points, double h)
{
  const Box_tree tree(points);
  const Kernels kernels{tree.positions(), std::vector<double>(points.size(), h)};
  std::vector<double> factors;
  for(const Surroundings& s :
      surroundings(Packet_tree(tree), kernels, Concurrency::sequential))
    factors.push_back(s.growth_factor());
  return tree.by_index(factors).front();
}

} // namespace

TEST_CASE("Density, neighbours and anisotropy are those of Eq. 8, 11 and 12")
{
  const unsigned int seed = GENERATE(1u, 2u, 3u);
  CAPTURE(seed);
  const Samples samples(seed);
  const Points& x = samples.kernels.places;
  const std::vector<Surroundings> around =
    surroundings(samples.packet_tree, samples.kernels, Concurrency::sequential);
  REQUIRE(around.size() == x.size());
  for(std::size_t i = 0; i < x.size(); ++i) {
    const double h = samples.kernels.radii[i];
    double density = 1, neighbors = 0;
    Matrix3 covariance = Matrix3::Zero();
    for(std::size_t j = 0; j < x.size(); ++j) {
      const Vector3 d = x[i] - x[j];
      const double weight = theta(d.squaredNorm(), h);
      if(j == i || d.norm() > h)
        continue;
      density += weight;
      ++neighbors;
      covariance += weight * d * d.transpose();
    }
    CAPTURE(i, h);
    CHECK(around[i].density == Approx(density).epsilon(1e-3));
    CHECK(around[i].neighbors == neighbors);
    CHECK(around[i].anisotropy == Approx(Surroundings(1, 0, covariance).anisotropy).margin(1e-3));
  }
}

TEST_CASE("The repulsion is that of Eq. 4 with the weights of Eq. 6 and 8")
{
  const unsigned int seed = GENERATE(4u, 5u, 6u);
  CAPTURE(seed);
  const Samples samples(seed);
  const Points& x = samples.kernels.places;
  const std::vector<Surroundings> around =
    surroundings(samples.packet_tree, samples.kernels, Concurrency::sequential);
  const Points fast =
    repulsion(samples.packet_tree, samples.kernels, around, Concurrency::sequential);
  double largest = 0;
  for(std::size_t i = 0; i < x.size(); ++i) {
    const double h = samples.kernels.radii[i];
    Vector3 sum = Vector3::Zero();
    double total = 0;
    for(std::size_t j = 0; j < x.size(); ++j) {
      const Vector3 d = x[i] - x[j];
      if(d.isZero(0) || d.norm() > h)
        continue; // itself or at the same place; beyond the support radius
      const double beta = around[j].density * theta(d.squaredNorm(), h) / d.norm();
      sum += beta * d;
      total += beta;
    }
    CAPTURE(i, h);
    CHECK((fast[i] - sum / total).norm() < 1e-3 * h);
    largest = std::max(largest, fast[i].norm() / h);
  }
  CHECK(largest > 0.05);
}

TEST_CASE("A sample without others within its kernel is not repelled, and grows")
{
  const Points apart{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const Box_tree tree(apart);
  const Packet_tree packet_tree(tree);
  const Kernels kernels{tree.positions(), {0.5, 0.5, 0.5}};
  const std::vector<Surroundings> around =
    surroundings(packet_tree, kernels, Concurrency::sequential);
  for(const Surroundings& s : around) {
    CHECK(s.density == Approx(1));
    CHECK(s.neighbors == 0);
    CHECK(s.growth_factor() == 1);
  }
  for(const Vector3& f : repulsion(packet_tree, kernels, around, Concurrency::sequential))
    CHECK(f == Vector3::Zero());
}

TEST_CASE("The density of points is that of Eq. 7 within some per cent")
{
  const unsigned int seed = GENERATE(7u, 8u);
  CAPTURE(seed);
  std::mt19937 generator(seed);
  Points points; // a plane of two densities, a line, a clump and a point far away
  for(int i = 0; i < 1500; ++i) {
    const Vector3 p = random_vector(generator, 0.3);
    points.emplace_back(i % 2 ? p.x() : std::abs(p.x()), p.y(), 0);
  }
  for(int i = 0; i < 100; ++i)
    points.emplace_back(random_vector(generator, 0.3).x(), 0, 0.4);
  for(int i = 0; i < 100; ++i)
    points.push_back(Vector3(0, 0, -0.4) + random_vector(generator, 1e-3));
  points.emplace_back(0.4, 0.4, 0.4);
  const double h = 0.15;
  const std::vector<double> fast = densities(points, h, Concurrency::sequential);
  double mean = 0;
  for(std::size_t i = 0; i < points.size(); ++i) {
    double exact = 1;
    for(std::size_t j = 0; j < points.size(); ++j)
      exact += j == i ? 0 : theta((points[i] - points[j]).squaredNorm(), h);
    CAPTURE(i, points[i].transpose());
    CHECK(fast[i] == Approx(exact).epsilon(0.1));
    mean += (fast[i] / exact - 1) / static_cast<double>(points.size());
  }
  CHECK(std::abs(mean) < 0.02);
  CHECK(fast.back() == Approx(1));
}

TEST_CASE("Points at one place have their number as density")
{
  for(double density : densities(Points(1000, Vector3(1, 2, 3)), 0.1, Concurrency::sequential))
    CHECK(density == Approx(1000));
}

TEST_CASE("Kernels grow in isotropic surroundings and hardly along a line")
{
  const double h = 1;
  std::mt19937 generator(21);
  Points line, ball;
  for(int i = -50; i <= 50; ++i)
    line.push_back(0.004 * i * Vector3(1, 2, 2));
  std::swap(line.front(), line[50]); // the first one is the centre
  ball.emplace_back(0, 0, 0);
  while(ball.size() < 2000) {
    const Vector3 p = random_vector(generator, 0.5);
    if(p.norm() < 0.5)
      ball.push_back(p);
  }
  // Eq. 11 with sigma = 1 and 100 other samples; and with sigma = 1/3.
  CHECK(growth_factor_of_first(line, h) == Approx(1.0 / 99));
  CHECK(growth_factor_of_first(ball, h) == Approx(2.0 / 3).margin(0.05));

  Points disk = ball;
  for(Vector3& p : disk)
    p.z() = 0;
  CHECK(growth_factor_of_first(disk, h) == Approx(0.5).margin(0.05));
}

TEST_CASE("The growth factor stays in [0, 1] and is 1 among few samples")
{
  for(unsigned int seed = 31; seed <= 60; ++seed) {
    CAPTURE(seed);
    std::mt19937 generator(seed);
    Points points;
    const std::size_t size = 1 + seed % 10;
    for(std::size_t i = 0; i < size; ++i)
      points.push_back(random_vector(generator, 0.3).cwiseProduct(Vector3(1, 1e-3, seed % 2)));
    const double nu = growth_factor_of_first(points, 1);
    CHECK(nu >= 0);
    CHECK(nu <= 1);
    if(size <= 3) // itself and two others
      CHECK(nu == 1);
  }
  CHECK(growth_factor_of_first(Points(10, Vector3(1, 2, 3)), 1) == 1); // no direction at all
}

} // namespace surroundings_test
