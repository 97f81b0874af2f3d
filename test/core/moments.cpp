// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Moments, principal axes and quantiles: identities that hold for any numbers.

#include "catch2.h"
#include "generator/Random.h"

#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Moments.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/principal_axes.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/quantile.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace moments_test {

using namespace CGAL::Point_set_skeletonization_3::internal;

namespace {

constexpr unsigned int seeds[] = {1, 2, 3};

Matrix3 random_covariance(shapes::Random& random)
{
  const Matrix3 turn = random.rotation();
  return turn * random.uniform_vector().asDiagonal() * turn.transpose();
}

Gaussians random_gaussians(std::size_t size, shapes::Random& random)
{
  Gaussians result;
  for(std::size_t i = 0; i < size; ++i) {
    const double weight = random.uniform(0.5, 2);
    const Vector3 mean = random.uniform_vector();
    result.push_back({weight, mean, random_covariance(random)});
  }
  return result;
}

Moments moments_about(const Vector3& origin, const Gaussians& gaussians)
{
  Moments result;
  for(const Gaussian& g : gaussians)
    result.add(g.weight, g.mean - origin, g.covariance);
  return result;
}

// Straight from the definition.
Gaussian merged(const Gaussians& gaussians)
{
  Gaussian result;
  for(const Gaussian& g : gaussians)
    result.weight += g.weight;
  for(const Gaussian& g : gaussians)
    result.mean += g.weight / result.weight * g.mean;
  for(const Gaussian& g : gaussians) {
    const Vector3 d = g.mean - result.mean;
    result.covariance += g.weight / result.weight * (g.covariance + d * d.transpose());
  }
  return result;
}

void check_equal(const Gaussian& a, const Gaussian& b)
{
  CHECK(a.weight == Approx(b.weight));
  CHECK((a.mean - b.mean).norm() < 1e-12);
  CHECK((a.covariance - b.covariance).norm() < 1e-12);
}

} // namespace

TEST_CASE("Moments about any origin are those of the union of what was added")
{
  for(const unsigned int seed : seeds) {
    CAPTURE(seed);
    shapes::Random random(seed);
    const Gaussians gaussians = random_gaussians(20, random);
    const Vector3 origin = random.uniform_vector();
    check_equal(moments_about(origin, gaussians).gaussian(origin), merged(gaussians));
  }
  Moments point;
  point.add(3, Vector3(1, 2, 3));
  check_equal(point.gaussian(Vector3(4, 5, 6)), {3, Vector3(5, 7, 9), Matrix3::Zero()});
}

TEST_CASE("Moments about another origin add up as if all were about one")
{
  for(const unsigned int seed : seeds) {
    CAPTURE(seed);
    shapes::Random random(seed);
    const Gaussians first = random_gaussians(10, random), second = random_gaussians(15, random);
    const Vector3 origin = random.uniform_vector(), other = random.uniform_vector();
    Moments sum = moments_about(origin, first);
    sum.add(moments_about(other, second), other - origin);

    Gaussians both = first;
    both.insert(both.end(), second.begin(), second.end());
    const Moments expected = moments_about(origin, both);
    CHECK((sum.array() - expected.array()).norm() < 1e-12 * expected.array().norm());
    check_equal(sum.gaussian(origin), merged(both));
  }
}

TEST_CASE("Principal axes diagonalise a covariance")
{
  for(const unsigned int seed : seeds)
    for(const double scale : {1e-12, 1.0, 1e6}) {
      CAPTURE(seed, scale);
      shapes::Random random(seed);
      const Matrix3 covariance = scale * random_covariance(random);
      const auto [variances, directions] = principal_axes(covariance);
      CHECK((variances[0] <= variances[1] && variances[1] <= variances[2]));
      CHECK((directions.transpose() * directions - Matrix3::Identity()).norm() < 1e-6);
      CHECK((directions * variances.asDiagonal() * directions.transpose() - covariance).norm() <
            1e-6 * scale);
    }
}

TEST_CASE("Of a flat or a single point no variance is negative")
{
  const Vector3 d = Vector3(1, 2, -2) / 3;
  for(const Matrix3& covariance : {Matrix3(Matrix3::Zero()), Matrix3(d * d.transpose()),
                                   Matrix3(Matrix3::Identity() - d * d.transpose())}) {
    const auto [variances, directions] = principal_axes(covariance);
    CHECK(variances.minCoeff() >= 0);
    CHECK(directions.allFinite());
    CHECK(variances.sum() == Approx(covariance.trace()));
  }
  CHECK(std::abs(principal_axes(d * d.transpose()).directions.col(2).dot(d)) == Approx(1));
}

TEST_CASE("A quantile has its share of the values below it")
{
  for(const unsigned int seed : seeds) {
    CAPTURE(seed);
    shapes::Random random(seed);
    std::vector<double> values(101);
    for(double& value : values)
      value = random.uniform();
    std::vector<double> sorted = values;
    std::sort(sorted.begin(), sorted.end());
    for(const double share : {0.0, 0.25, 0.5, 0.999}) {
      const auto k = static_cast<std::size_t>(share * 101);
      CHECK(quantile(values, share) == sorted[k]);
    }
  }
  CHECK(quantile({7}, 0.5) == 7);
}

} // namespace moments_test
