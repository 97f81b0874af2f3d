// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The iterations of the projection as a whole, and where they halt.

#include "catch2.h"
#include "threads.h"

#include <CGAL/Point_set_skeletonization_3/internal/published/published_method.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <random>
#include <vector>

namespace projection_test {

using namespace CGAL::Point_set_skeletonization_3::internal;
using Points = std::vector<Vector3>;

namespace {

// Points of a tube along the x axis, of length 0.9 and a given radius.
Points tube(std::size_t size, double radius, unsigned int seed)
{
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Points points;
  while(points.size() < size) {
    const double angle = CGAL_PI * uniform(generator);
    points.emplace_back(0.45 * uniform(generator), radius * std::cos(angle),
                        radius * std::sin(angle));
  }
  return points;
}

Projected_samples projected(const Points& points, const Published_options& options,
                            Concurrency concurrency = Concurrency::sequential)
{
  const std::vector<Gaussians> mixture = published_mixture(points, options, concurrency, {});
  return published_samples(points, mixture, options, concurrency, {});
}

// Mean distance of the samples to the x axis, away from the ends of the tube.
double mean_axis_distance(const std::vector<L1_sample>& samples)
{
  double sum = 0;
  std::size_t number = 0;
  for(const L1_sample& s : samples)
    if(std::abs(s.position.x()) < 0.3) {
      sum += std::hypot(s.position.y(), s.position.z());
      ++number;
    }
  REQUIRE(number > 0);
  return sum / static_cast<double>(number);
}

} // namespace

TEST_CASE("Samples of a tube come to lie on its axis")
{
  const unsigned int seed = GENERATE(1u, 2u);
  CAPTURE(seed);
  const double radius = 0.05;
  const Points points = tube(4000, radius, seed);
  CHECK(mean_axis_distance(drawn_samples(points, Published_options())) == Approx(radius));
  CHECK(mean_axis_distance(projected(points, Published_options()).samples) < 0.1 * radius);
}

TEST_CASE("Without a halt the iterations are as many as asked for")
{
  const Points points = tube(1000, 0.05, 3);
  for(std::size_t iterations : {0u, 1u, 5u}) {
    Published_options options;
    options.projection.iterations = iterations;
    const Projected_samples result = projected(points, options);
    CHECK(result.iterations == iterations);
    if(iterations == 0)
      for(const L1_sample& s : result.samples)
        CHECK(s.position == s.origin);
  }
}

TEST_CASE("The projection halts once most samples lie on a curve, and only then")
{
  const unsigned int seed = GENERATE(4u, 5u);
  CAPTURE(seed);
  const double radius = 0.05;
  const Points points = tube(4000, radius, seed);
  Published_options options;
  options.projection.iterations = 200;
  options.projection.halts = true;
  const Projected_samples result = projected(points, options);
  CHECK(result.iterations > 1);
  CHECK(result.iterations < 200);
  CHECK(mean_axis_distance(result.samples) < 0.2 * radius);

  // It returns what as many iterations without a halt give.
  options.projection.halts = false;
  options.projection.iterations = result.iterations;
  const Projected_samples same = projected(points, options);
  REQUIRE(same.samples.size() == result.samples.size());
  for(std::size_t i = 0; i < same.samples.size(); ++i)
    REQUIRE(same.samples[i].position == result.samples[i].position);

  options.projection.halts = true;
  options.projection.iterations = 10;
  options.projection.curve_growth = 0; // only that of infinitely many on a perfect line
  CHECK(projected(points, options).iterations == 10);
  options.projection.curve_growth = 0.3;
  options.projection.kernel_growth = 0; // no kernel grows, no limb contracts
  CHECK(projected(points, options).iterations == 10);
}

TEST_CASE("The halt is where the share of samples on curves stops growing")
{
  const auto halted = [](const std::vector<double>& shares) -> std::optional<std::size_t> {
    Published_projection_options options; // halts when nothing has grown for four iterations
    Automatic_halt halt(options);
    for(std::size_t k = 0; k < shares.size(); ++k)
      if(halt.is_reached({{}, k}, shares[k]))
        return halt.samples().iterations;
    return std::nullopt;
  };
  CHECK(halted({0.1, 0.3, 0.5, 0.7, 0.6, 0.5, 0.5, 0.4, 0.4}) == 3u);      // a maximum
  CHECK(halted({0.4, 0.9, 1, 1, 1, 1, 1, 1}) == 2u);                       // all of them
  CHECK(halted({0.6, 0.605, 0.609, 0.609, 0.609, 0.609}) == 0u);           // hardly grows
  CHECK(halted({0.6, 0.5, 0.5, 0.5, 0.7, 0.7, 0.7, 0.7, 0.7}) == 4u);      // a short pause
  CHECK(halted({0.3, 0.2, 0.2, 0.2, 0.2, 0.2, 0.2, 0.2}) == std::nullopt); // too few
  CHECK(halted({0.6, 0.7, 0.8, 0.9}) == std::nullopt);                     // still growing
}

TEST_CASE("The options of the projection do what they say")
{
  const Points points = tube(2000, 0.05, 6);
  Published_options options;
  CHECK(drawn_samples(points, options).size() == 500);
  CHECK(drawn_samples(points, options).front().kernel_radius == Approx(2 / std::cbrt(2000.0)));
  options.projection.number_of_samples = 77;
  options.projection.initial_kernel_radius = 0.25;
  const std::vector<L1_sample> drawn = drawn_samples(points, options);
  CHECK(drawn.size() == 77);
  CHECK(drawn.front().kernel_radius == 0.25);

  options.projection.kernel_growth = 0; // kernels keep their size
  for(const L1_sample& s : projected(points, options).samples)
    CHECK(s.kernel_radius == 0.25);
  options.projection.kernel_growth = 2; // times h^(0) times nu <= 1
  options.projection.iterations = 3;
  for(const L1_sample& s : projected(points, options).samples) {
    CHECK(s.kernel_radius > 0.25);
    CHECK(s.kernel_radius <= 0.25 * (1 + 3 * 2));
  }
}

TEST_CASE("Threads do not change a bit of the projection")
{
  const Points points = tube(4000, 0.05, 7);
  const std::vector<L1_sample> expected = projected(points, Published_options()).samples;
  for_threads([&](Concurrency concurrency) {
    const std::vector<L1_sample> actual =
      projected(points, Published_options(), concurrency).samples;
    REQUIRE(actual.size() == expected.size());
    for(std::size_t i = 0; i < actual.size(); ++i) {
      CHECK(actual[i].position == expected[i].position);
      CHECK(actual[i].kernel_radius == expected[i].kernel_radius);
    }
  });
}

} // namespace projection_test
