// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The closed form of the attraction against the integral and the sum that it stands for, and its
// fast evaluation against the closed form.

#include "catch2.h"

#include <CGAL/Point_set_skeletonization_3/internal/published/attraction.h>

#include <CGAL/number_type_config.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace attraction_test {

using namespace CGAL::Point_set_skeletonization_3::internal;
using Points = std::vector<Vector3>;

namespace {

// Numerator and denominator of Eq. 9.
struct Sums
{
  Vector3 weighted_position = Vector3::Zero();
  double weight = 0;

  Sums& operator+=(const Sums& other)
  {
    weighted_position += other.weighted_position;
    weight += other.weight;
    return *this;
  }
};

// The closed form for one component and one sample, in double precision.
Sums closed_form(const Gaussian& g, const Vector3& q, double h)
{
  using Value = Eigen::Array<double, 1, 1>;
  const Attractor<double> attractor(g, g.mean);
  const Vector3 d = g.mean - q;
  const Value squared_radius(h * h);
  Pull<Value> pull;
  for(std::size_t k = 0; k < Attraction_kernel::amplitude.size(); ++k)
    pull.add(attractor, Value(d.x()), Value(d.y()), Value(d.z()),
             Kernel_term<Value>(k, squared_radius));
  const double weight = pull.weight[0];
  return {weight * q + Vector3(pull.x[0], pull.y[0], pull.z[0]), weight};
}

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
Sums integrated_pull(const Framed_gaussian& g, const Vector3& q, double h)
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
  Sums sum;
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
  Sums sum;
  for(const auto& c : components)
    sum += pull(c);
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
    return closed_form({1, p, deviation * deviation * Matrix3::Identity()}, Vector3::Zero(), h);
  });
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
      const Sums closed = closed_form(g.gaussian(), q, h);
      const Sums integral = integrated_pull(g, q, h);
      // The factor 1/h of the kernel is left out of the closed form: it cancels in the quotient.
      CHECK(closed.weight == Approx(h * integral.weight).epsilon(1e-6));
      CHECK((closed.weighted_position / closed.weight -
             integral.weighted_position / integral.weight)
              .norm() < 1e-6 * h);
    }
    const Vector3 closed = attraction(
      mixture, [&](const Framed_gaussian& g) { return closed_form(g.gaussian(), q, h); });
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

    const Sums before = closed_form(g.gaussian(), q, 1);
    const Sums after = closed_form(image.gaussian(), scale * (turn * q) + offset, scale);
    CHECK(after.weight == Approx(before.weight).epsilon(1e-6));
    const Vector3 expected = scale * (turn * before.weighted_position / before.weight) + offset;
    CHECK((after.weighted_position / after.weight - expected).norm() < 1e-6 * scale);
  }
}

TEST_CASE("A component without extent in some direction still pulls")
{
  for(const Vector3& deviation : {Vector3(0, 0, 0), Vector3(0, 0, 0.1), Vector3(0, 0.1, 0.1)}) {
    const Gaussian g{2, Vector3(0.1, 0, 0), deviation.cwiseAbs2().asDiagonal()};
    const Sums pull = closed_form(g, Vector3(0.05, 0.02, 0), 1);
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
      return Sums{weight * p, weight};
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

TEST_CASE("Packets and groups give the closed form")
{
  const unsigned int seed = GENERATE(41u, 42u, 43u);
  CAPTURE(seed);
  std::mt19937 generator(seed);
  // Components the size of a patch along a bent tube, and a few elsewhere.
  Gaussians mixture;
  for(int i = 0; i < 600; ++i) {
    const double t = random_vector(generator, 1).x(), a = CGAL_PI * random_vector(generator, 1).x();
    Framed_gaussian g = random_gaussian(generator, 0.1);
    g.mean = i % 20 == 0 ? random_vector(generator, 0.4)
                         : Vector3(0.4 * t, 0.1 * t * t + 0.05 * std::cos(a), 0.05 * std::sin(a));
    mixture.push_back(g.gaussian());
  }
  Kernels samples;
  for(int i = 0; i < 101; ++i) { // the last packet is not full
    samples.places.push_back(mixture[static_cast<std::size_t>(5 * i)].mean +
                             random_vector(generator, 0.02));
    samples.radii.push_back(0.05 * std::exp(1.2 * (1 + random_vector(generator, 1).x())));
  }
  const std::vector<Vector3> fast =
    Attractors(mixture).attraction(samples, Concurrency::sequential);
  REQUIRE(fast.size() == samples.size());
  double worst = 0, mean = 0, moved = 0;
  for(std::size_t i = 0; i < samples.size(); ++i) {
    const Vector3 q = samples.places[i];
    const double h = samples.radii[i];
    const Vector3 exact =
      attraction(mixture, [&](const Gaussian& g) { return closed_form(g, q, h); }) - q;
    worst = std::max(worst, (fast[i] - exact).norm() / h);
    mean += (fast[i] - exact).norm() / h / static_cast<double>(samples.size());
    moved = std::max(moved, exact.norm() / h);
  }
  CHECK(mean < 1e-3);
  CHECK(worst < 0.01);
  CHECK(moved > 0.1);
}

TEST_CASE("A sample far from everything stays where it is")
{
  Gaussians mixture;
  for(int i = 0; i < 50; ++i)
    mixture.push_back({1, Vector3(0.001 * i, 0, 0), 1e-6 * Matrix3::Identity()});
  const Kernels samples{{Vector3(0, 0.5, 0), Vector3(0.02, 0, 0.001)}, {0.1, 0.1}};
  const std::vector<Vector3> way = Attractors(mixture).attraction(samples, Concurrency::sequential);
  CHECK(way[0] == Vector3::Zero());
  CHECK(way[1].norm() > 0);
}

TEST_CASE("The fast exponential is one up to its end and 0 beyond")
{
  Packet_values x;
  for(std::size_t i = 0; i < packet_size; ++i)
    x.set(i, 15.9f * static_cast<float>(i) / (packet_size - 1));
  for(std::size_t i = 0; i < packet_size; ++i) {
    CAPTURE(x[i]);
    const double exact = std::exp(-static_cast<double>(x[i])), error = std::pow(x[i], 3) / 3.6e5;
    CHECK(std::abs(decay(x, 16)[i] / exact - 1) < error + 3e-5); // and rounding of eight squares
    CHECK(decay(x, 7)[i] == (x[i] < 7 ? decay(x, 16)[i] : 0));
  }
}

} // namespace attraction_test
