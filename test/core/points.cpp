// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Reading points in blocks, normalising them, and loops over them by one or many threads.

#include "catch2.h"
#include "generator/Random.h"
#include "points_source.h"
#include "threads.h"

#include <CGAL/Point_set_skeletonization_3/internal/core/Bulk.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Normalization.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Normalized_points.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Per_thread.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Progress.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/l1_median.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace points_test {

using namespace CGAL::Point_set_skeletonization_3::internal;

namespace {

constexpr unsigned int seed = 1;

std::vector<Vector3> cloud(std::size_t size)
{
  shapes::Random random(seed);
  std::vector<Vector3> result(size);
  for(Vector3& p : result)
    p = Vector3(10, 20, 30) + random.uniform_vector().cwiseProduct(Vector3(3, 4, 12));
  return result;
}

struct Sum
{
  std::size_t value = 0;
  void add(const Sum& other) { value += other.value; }
};

Normalization normalization_of(const std::vector<Vector3>& points, Concurrency concurrency)
{
  return bulk_of(source_of(points), concurrency).box().normalization();
}

// The message of normalising points.
std::string complaint(const std::vector<Vector3>& points, Concurrency concurrency)
{
  try {
    normalization_of(points, concurrency);
  } catch(const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

} // namespace

TEST_CASE("Normalised points have a box around the origin with a diagonal of 1, and come back")
{
  for(const std::size_t size : {2u, 255u, 256u, 257u, 3000u}) {
    CAPTURE(seed, size);
    const std::vector<Vector3> points = cloud(size);
    const Normalization normalization = normalization_of(points, Concurrency::parallel);
    Vector3 lower = Vector3::Ones(), upper = -Vector3::Ones();
    for(const Vector3& p : points) {
      const Vector3 q = normalization.to_unit(p);
      lower = lower.cwiseMin(q);
      upper = upper.cwiseMax(q);
      REQUIRE((normalization.from_unit(q) - p).norm() < 1e-12);
    }
    CHECK((lower + upper).norm() < 1e-12);
    CHECK((upper - lower).norm() == Approx(1));
    const Matrix3 covariance = Vector3(1, 2, 3).asDiagonal();
    CHECK(normalization.covariance_to_unit(normalization.covariance_from_unit(covariance))
            .isApprox(covariance));
  }
}

TEST_CASE("No points and equal points are normalised, too")
{
  CHECK(normalization_of({}, Concurrency::sequential).diagonal() == 1);
  const Vector3 p(1, 2, 3);
  const Normalization normalization =
    normalization_of(std::vector<Vector3>(700, p), Concurrency::sequential);
  CHECK(normalization.diagonal() == 1);
  CHECK(normalization.to_unit(p).isZero());
}

TEST_CASE("The first point that is not finite is named, whoever reads it")
{
  std::vector<Vector3> points = cloud(5000);
  points[4000].y() = std::numeric_limits<double>::infinity();
  points[300].z() = std::numeric_limits<double>::quiet_NaN();
  for(const Concurrency concurrency : {Concurrency::sequential, Concurrency::parallel})
    CHECK(complaint(points, concurrency).find("point 300 ") == 0);
}

TEST_CASE("Every point is in one block, at its number")
{
  for_threads([](Concurrency concurrency) {
    for(const std::size_t size : {0u, 1u, 256u, 1000u, 600000u}) {
      CAPTURE(size);
      const std::vector<Vector3> points = cloud(size);
      const Normalized_points normalized{source_of(points), Normalization()};
      std::vector<int> visits(size, 0);
      std::vector<char> differs(size, false);
      normalized.visit_blocks(
        [&](std::size_t b) {
          const Normalized_points::Block block = normalized.block(b);
          for(std::size_t k = 0; k < block.points.size(); ++k) {
            const std::size_t i = block.numbers[k];
            ++visits[i];
            differs[i] = block.points[k] != Normalization().to_unit(points[i]);
          }
        },
        concurrency, Progress());
      CHECK(std::count(visits.begin(), visits.end(), 1) == static_cast<std::ptrdiff_t>(size));
      CHECK(std::count(differs.begin(), differs.end(), true) == 0);
    }
  });
}

TEST_CASE("A loop calls every number once, on any number of threads")
{
  for_threads([](Concurrency concurrency) {
    for(const std::size_t size : {0u, 1u, 10000u}) {
      std::vector<int> calls(size, 0);
      parallel_for(concurrency, size, [&](std::size_t i) { ++calls[i]; });
      CHECK(std::count(calls.begin(), calls.end(), 1) == static_cast<std::ptrdiff_t>(size));
      const Sum sum = parallel_sum(concurrency, size, Sum(),
                                   [](std::size_t i, Sum& part) { part.value += i; });
      CHECK(sum.value == size * (size - std::min<std::size_t>(1, size)) / 2);
    }
    bool first = false, second = false;
    parallel_invoke(concurrency, [&] { first = true; }, [&] { second = true; });
    CHECK((first && second));
  });
}

TEST_CASE("A part of the progress covers its part of the whole, and cancels all")
{
  std::vector<double> values;
  const Progress progress([&](double value) {
    values.push_back(value);
    return value < 0.5;
  });
  const Progress part = progress.part(0.2, 0.6).part(0.5, 1);
  part(0);
  CHECK(values.back() == Approx(0.4));
  CHECK_THROWS_AS(part(0.75), Cancelled);
  CHECK(values.back() == Approx(0.55));
  CHECK_NOTHROW(Progress()(0.5));
}

TEST_CASE("The L1-median has the least sum of distances, and outliers do not move it")
{
  shapes::Random random(seed);
  std::vector<Vector3> points = cloud(500);
  const auto sum_of_distances = [&points](const Vector3& q) {
    double sum = 0;
    for(const Vector3& p : points)
      sum += (p - q).norm();
    return sum;
  };
  constexpr double closest = 0.01;
  const Vector3 median = l1_median(points, closest);
  for(int i = 0; i < 100; ++i)
    CHECK(sum_of_distances(median) <= sum_of_distances(median + 0.2 * random.uniform_vector()) + 0.01);
  points.insert(points.end(), 50, Vector3(1000, 0, 0));
  CHECK((l1_median(points, closest) - median).norm() < 2); // the mean moves by 90
  CHECK(l1_median(std::vector<Vector3>(3, Vector3(1, 2, 3)), closest).isApprox(Vector3(1, 2, 3)));
}

} // namespace points_test
