// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The closed form of the attraction against the integral and the sum that it stands for.

#include "catch2.h"

#include <CGAL/Point_set_skeletonization_3/internal/published/attraction.h>
#include <CGAL/Point_set_skeletonization_3/internal/published/kernel_growth.h>

#include <CGAL/number_type_config.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <random>
#include <vector>

using namespace CGAL::Point_set_skeletonization_3::internal;
using Points = std::vector<Vector3>;

namespace {

// A Gaussian whose frame the test knows without computing eigenvectors.
struct Framed_gaussian
{
  double weight;
  Vector3 mean;
  Matrix3 frame;     // axes as columns
  Vector3 deviation; // along the axes

  Gaussian gaussian() const
  {
    const Matrix3 covariance = frame * deviation.cwiseAbs2().asDiagonal() * frame.transpose();
    return {weight, mean, covariance};
  }
};

Vector3 random_vector(std::mt19937& generator, double half_width)
{
  std::uniform_real_distribution<double> uniform(-half_width, half_width);
  const double x = uniform(generator), y = uniform(generator), z = uniform(generator);
  return Vector3(x, y, z);
}

// Flat, long and round ones in random directions, all within the kernel's support around 0.
Framed_gaussian random_gaussian(std::mt19937& generator, double h)
{
  std::uniform_real_distribution<double> uniform(0.003, 0.08);
  Framed_gaussian g;
  g.weight = 1 + 100 * uniform(generator);
  g.mean = random_vector(generator, 0.25 * h);
  g.frame = Eigen::AngleAxisd(random_vector(generator, 3).norm(),
                              random_vector(generator, 1).normalized())
              .toRotationMatrix();
  for(int k = 0; k < 3; ++k)
    g.deviation[k] = h * uniform(generator);
  return g;
}

// Numerator and denominator of Eq. 9 for one component by the trapezoidal rule on a grid in its
// frame, seven standard deviations wide. The rule converges exponentially for Gaussians: with steps
// below the narrowest standard deviation of the integrand its error is below 1e-7.
Pull integrated_pull(const Framed_gaussian& g, const Vector3& q, double h)
{
  const double narrowest = h * *std::min_element(Attraction_kernel::deviation.begin(),
                                                 Attraction_kernel::deviation.end());
  Vector3 step;
  int count[3];
  for(int k = 0; k < 3; ++k) {
    const double product = 1 / std::hypot(1 / g.deviation[k], 1 / narrowest);
    count[k] = static_cast<int>(std::ceil(7 * g.deviation[k] / (0.95 * product)));
    step[k] = 7 * g.deviation[k] / count[k];
  }
  const double normalization = std::pow(2 * CGAL_PI, -1.5) / g.deviation.prod();
  Pull sum;
  for(int i = -count[0]; i <= count[0]; ++i)
    for(int j = -count[1]; j <= count[1]; ++j)
      for(int k = -count[2]; k <= count[2]; ++k) {
        const Vector3 t = step.cwiseProduct(Vector3(i, j, k));
        const Vector3 x = g.mean + g.frame * t;
        const double density =
          normalization * std::exp(-t.cwiseQuotient(g.deviation).squaredNorm() / 2);
        const double weight =
          density * Attraction_kernel::value((x - q).norm(), h) * step.prod() * g.weight;
        sum.weight += weight;
        sum.weighted_position += weight * x;
      }
  return sum;
}

template <typename Components, typename Function>
Vector3 attraction(const Components& components, const Function& pull)
{
  Pull sum;
  for(const auto& c : components) {
    const Pull p = pull(c);
    sum.weight += p.weight;
    sum.weighted_position += p.weighted_position;
  }
  return sum.weighted_position / sum.weight;
}

// Points around the origin at distances where the sum of Gaussians approximates the kernel.
Points random_points(std::mt19937& generator, double h, std::size_t size)
{
  std::uniform_real_distribution<double> distance(0.02 * h, 0.45 * h);
  Points points;
  while(points.size() < size) {
    const Vector3 direction = random_vector(generator, 1);
    if(direction.norm() > 0.1)
      points.push_back(distance(generator) * direction.normalized());
  }
  return points;
}

// The mixture of equal round Gaussians at the points.
Vector3 attraction_to_balls(const Points& points, double deviation, double h)
{
  return attraction(points, [&](const Vector3& p) {
    return Attractor({1, p, deviation * deviation * Matrix3::Identity()}).pull(Vector3::Zero(), h);
  });
}

double growth_factor_of_all(const Points& points, double h)
{
  std::vector<std::size_t> near(points.size());
  std::iota(near.begin(), near.end(), std::size_t(0));
  return growth_factor(points.front(), h, points, near);
}

} // namespace

TEST_CASE("The closed form of the attraction is the integral of Eq. 9")
{
  for(unsigned int seed = 1; seed <= 4; ++seed) {
    CAPTURE(seed);
    std::mt19937 generator(seed);
    const double h = std::exp(random_vector(generator, 3).x());
    std::vector<Framed_gaussian> mixture;
    for(int i = 0; i < 3; ++i)
      mixture.push_back(random_gaussian(generator, h));
    const Vector3 q = random_vector(generator, 0.1 * h);

    for(const Framed_gaussian& g : mixture) {
      const Pull closed = Attractor(g.gaussian()).pull(q, h);
      const Pull integral = integrated_pull(g, q, h);
      // The factor 1/h of the kernel is left out of the closed form: it cancels in the quotient.
      CHECK(closed.weight == Approx(h * integral.weight).epsilon(1e-6));
      CHECK((closed.weighted_position / closed.weight -
             integral.weighted_position / integral.weight)
              .norm() < 1e-6 * h);
    }
    const Vector3 closed = attraction(
      mixture, [&](const Framed_gaussian& g) { return Attractor(g.gaussian()).pull(q, h); });
    const Vector3 integral =
      attraction(mixture, [&](const Framed_gaussian& g) { return integrated_pull(g, q, h); });
    CHECK((closed - integral).norm() < 1e-6 * h);
    CHECK((closed - q).norm() > 1e-3 * h); // it pulls at all
  }
}

TEST_CASE("The pull of a component moves, turns and scales with it")
{
  std::mt19937 generator(5);
  for(int i = 0; i < 20; ++i) {
    const Framed_gaussian g = random_gaussian(generator, 1);
    const Vector3 q = random_vector(generator, 0.2), offset = random_vector(generator, 10);
    const Matrix3 turn = Eigen::AngleAxisd(2, random_vector(generator, 1).normalized()).matrix();
    const double scale = std::exp(random_vector(generator, 5).x());
    Framed_gaussian image = g;
    image.mean = scale * (turn * g.mean) + offset;
    image.frame = turn * g.frame;
    image.deviation *= scale;

    const Pull before = Attractor(g.gaussian()).pull(q, 1);
    const Pull after = Attractor(image.gaussian()).pull(scale * (turn * q) + offset, scale);
    CHECK(after.weight == Approx(before.weight).epsilon(1e-6));
    const Vector3 expected = scale * (turn * before.weighted_position / before.weight) + offset;
    CHECK((after.weighted_position / after.weight - expected).norm() < 1e-6 * scale);
  }
}

TEST_CASE("A component without extent in some direction still pulls")
{
  for(const Vector3& deviation : {Vector3(0, 0, 0), Vector3(0, 0, 0.1), Vector3(0, 0.1, 0.1)}) {
    const Gaussian g{2, Vector3(0.1, 0, 0), deviation.cwiseAbs2().asDiagonal()};
    const Pull pull = Attractor(g).pull(Vector3(0.05, 0.02, 0), 1);
    CHECK(pull.weight > 0);
    CHECK(pull.weighted_position.allFinite());
    CHECK(pull.weighted_position.x() / pull.weight == Approx(0.1));
  }
}

TEST_CASE("The kernel is approximated within 14 % over the distances that count")
{
  for(double h : {1e-3, 0.2, 1.0, 7.0})
    for(int i = 0; i <= 1000; ++i) {
      const double r = h * (0.01 + 0.49 * i / 1000);
      CAPTURE(h, r);
      const double exact = theta(r * r, h) / r;
      REQUIRE(std::abs(Attraction_kernel::value(r, h) / exact - 1) < 0.14);
    }
}

TEST_CASE("Components that shrink to points attract as the points do")
{
  const double h = 0.3;
  for(unsigned int seed = 11; seed <= 15; ++seed) {
    CAPTURE(seed);
    std::mt19937 generator(seed);
    const Points points = random_points(generator, h, 30);
    const Vector3 exact =
      attraction_to_points(Vector3::Zero(), h, points, std::vector<double>(points.size(), 1));

    // The limit is the median with the approximate kernel. Weights that are wrong by a factor in
    // [1 - e, 1 + e] move a mean by at most e / (1 - e) times the mean distance to it.
    const Vector3 limit = attraction(points, [&](const Vector3& p) {
      const double weight = Attraction_kernel::value(p.norm(), h);
      return Pull{weight * p, weight};
    });
    double deviation = 0, total = 0;
    for(const Vector3& p : points) {
      const double weight = theta(p.squaredNorm(), h) / p.norm();
      deviation += weight * (p - exact).norm();
      total += weight;
    }
    CHECK((limit - exact).norm() < 0.14 / (1 - 0.14) * deviation / total);

    // The error of the extent is of second order: a tenth of it is a hundredth of the error.
    const double wide = (attraction_to_balls(points, 1e-3 * h, h) - limit).norm();
    const double narrow = (attraction_to_balls(points, 1e-4 * h, h) - limit).norm();
    CHECK(wide < 0.02 * h);
    CHECK(narrow < 0.02 * wide);
    CHECK((attraction_to_balls(points, 0, h) - limit).norm() < 1e-12);
  }
}

TEST_CASE("The attraction to points weighs and survives a point at the sample")
{
  const double h = 1;
  const Points pair{{-0.1, 0, 0}, {0.1, 0, 0}};
  CHECK(attraction_to_points(Vector3::Zero(), h, pair, {1, 1}).norm() < 1e-15);
  CHECK(attraction_to_points(Vector3::Zero(), h, pair, {1, 3}).x() == Approx(0.05));
  const Vector3 median = attraction_to_points(pair[0], h, pair, {1, 1});
  CHECK(median.allFinite());
  CHECK((median - pair[0]).norm() < 0.01);
  const Vector3 far(5, 0, 0); // theta underflows: nothing pulls
  CHECK((attraction_to_points(100 * far, h, pair, {1, 1}) - 100 * far).norm() == 0);
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
  CHECK(growth_factor_of_all(line, h) == Approx(1.0 / 99));
  CHECK(growth_factor_of_all(ball, h) == Approx(2.0 / 3).margin(0.05));

  Points disk = ball;
  for(Vector3& p : disk)
    p.z() = 0;
  CHECK(growth_factor_of_all(disk, h) == Approx(0.5).margin(0.05));
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
    const double nu = growth_factor_of_all(points, 1);
    CHECK(nu >= 0);
    CHECK(nu <= 1);
    if(size <= 3) // itself and two others
      CHECK(nu == 1);
  }
  CHECK(growth_factor_of_all(Points(10, Vector3(1, 2, 3)), 1) == 1); // no direction at all
}
