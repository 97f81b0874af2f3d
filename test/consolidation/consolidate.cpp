// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Noise is taken off a mixture, and nothing else.

#include "catch2.h"
#include "generator/Random.h"
#include "threads.h"

#include <CGAL/Point_set_skeletonization_3/internal/consolidation/consolidate.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

using namespace CGAL::Point_set_skeletonization_3::internal;
using shapes::Random;

namespace {

constexpr unsigned seeds = 3;

Gaussians components(std::size_t size, const std::function<Vector3()>& draw)
{
  Gaussians result;
  for(std::size_t i = 0; i < size; ++i)
    result.push_back({1, draw(), Matrix3::Zero()});
  return result;
}

Consolidated_mixture consolidated(const Gaussians& mixture,
                                  Concurrency concurrency = Concurrency::sequential)
{
  constexpr double no_cells = 0;
  return consolidate(mixture, Neighborhood(mixture, concurrency), no_cells, Consolidation_options(),
                     concurrency);
}

struct Measured_noise
{
  Noise noise;
  double window; ///< Its radius.
};

Measured_noise measured_noise_of(const Gaussians& mixture)
{
  constexpr auto concurrency = Concurrency::sequential;
  const Box_tree tree(means_of(mixture), concurrency);
  const K_nearest_neighbors nearest = k_nearest_neighbors(tree, surface_neighbors + 1, concurrency);
  std::vector<double> spacings;
  for(std::size_t i = 0; i < mixture.size(); ++i)
    spacings.push_back(spacing_of(i, nearest));
  const double spacing = quantile(spacings, 0.5);
  Scale_space space(mixture, tree, spacing, concurrency);
  const Moving_mixture moving = {mixture, means_of(mixture),
                                 std::vector<bool>(mixture.size(), false)};
  const Window_radii radii(spacing);
  const Noise noise =
    measure_noise(space, moving, nearest, radii, Noise_options(), concurrency);
  return {noise, radii[noise.size]};
}

Noise noise_of(const Gaussians& mixture) { return measured_noise_of(mixture).noise; }

/// Components around the wires of a square lattice, `across()` from the middle of a wire.
Gaussians lattice(int meshes, int points_of_edge, Random& random,
                  const std::function<Eigen::Vector2d()>& across)
{
  Gaussians result;
  for(int axis = 0; axis < 2; ++axis)
    for(int wire = 0; wire <= meshes; ++wire)
      for(int k = 0; k < meshes * points_of_edge; ++k) {
        const Eigen::Vector2d off = across();
        Vector3 p(0, 0, off[1]);
        p[axis] = random.uniform(0, meshes);
        p[1 - axis] = wire + off[0];
        result.push_back({1, p, Matrix3::Zero()});
      }
  return result;
}

bool is_outlier(const Consolidated_mixture& mixture, std::size_t i)
{
  return mixture.merged_into[i] == Consolidated_mixture::none;
}

/// Values of what is no outlier.
std::vector<double> kept(const Consolidated_mixture& mixture,
                         const std::function<double(const Vector3&)>& value)
{
  std::vector<double> result;
  for(const Gaussian& component : mixture.components)
    result.push_back(value(component.mean));
  return result;
}

double root_mean_square(const std::vector<double>& values)
{
  double sum = 0;
  for(double v : values)
    sum += v * v;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

double widest_gap(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  double result = 0;
  for(std::size_t i = 1; i < values.size(); ++i)
    result = std::max(result, values[i] - values[i - 1]);
  return result;
}

} // namespace

TEST_CASE("Where there is no noise nothing moves")
{
  for(unsigned seed = 0; seed < seeds; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Gaussians sphere = components(2000, [&] { return random.direction(); });
    const Consolidated_mixture surface = consolidated(sphere);
    CHECK(surface.noise == 0);
    REQUIRE(surface.merged_into.size() == sphere.size());
    for(std::size_t i = 0; i < sphere.size(); ++i)
      if(!is_outlier(surface, i))
        REQUIRE(surface.components[surface.merged_into[i]].mean == sphere[i].mean);
  }
}

TEST_CASE("Twigs as thin as a window are noisy only where the trunk is")
{
  constexpr double radius = 0.003, length = 0.06, trunk_radius = 0.035, spacing = 0.005;
  constexpr int number = 100, points = 40, trunk_points = 500;
  const bool is_noisy = GENERATE(false, true);
  for(unsigned seed = 0; seed < seeds; ++seed) {
    CAPTURE(seed, is_noisy);
    Random random(seed);
    Gaussians tree;
    const auto add = [&](const Vector3& p) { tree.push_back({1, p, Matrix3::Zero()}); };
    for(int twig = 0; twig < number; ++twig) {
      const Vector3 place(random.uniform(), random.uniform(), random.uniform());
      const Vector3 axis = random.direction();
      for(int k = 0; k < points; ++k)
        add(place + length * random.uniform() * axis +
            radius * axis.cross(random.direction()).normalized());
    }
    for(int k = 0; k < trunk_points; ++k)
      add((trunk_radius + (is_noisy ? spacing * random.normal() : 0)) * random.direction());
    const Consolidated_mixture surface = consolidated(tree);
    CHECK((surface.noise > 0) == is_noisy);
    if(!is_noisy)
      CHECK(surface.components.size() > tree.size() * 97 / 100);
  }
}

TEST_CASE("A noisy plane becomes flat and keeps its width")
{
  constexpr double sigma = 0.03; // a spacing and a half
  for(unsigned seed = 0; seed < seeds; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Gaussians plane = components(2000, [&] {
      const double x = random.uniform(), y = random.uniform(), z = sigma * random.normal();
      return Vector3(x, y, z);
    });
    const Consolidated_mixture surface = consolidated(plane);
    CHECK(surface.noise > 0.5);
    CHECK(root_mean_square(kept(surface, [](const Vector3& p) { return p.z(); })) < sigma / 3);
    const std::vector<double> x = kept(surface, [](const Vector3& p) { return p.x(); });
    CHECK(*std::max_element(x.begin(), x.end()) - *std::min_element(x.begin(), x.end()) > 0.9);
  }
}

TEST_CASE("Curvature is no noise: a tube has as much as a plane")
{
  const double sigma = GENERATE(0.3, 0.6);  // spacings
  const double radius = GENERATE(3., 10.); // spacings; the latter is nearly a plane
  const double length = 2000 / (2 * CGAL_PI * radius);
  for(unsigned seed = 0; seed < seeds; ++seed) {
    CAPTURE(seed, sigma, radius);
    Random random(seed);
    const Gaussians tube = components(2000, [&] {
      const double angle = random.uniform(0, 2 * CGAL_PI), r = radius + sigma * random.normal();
      return Vector3(r * std::cos(angle), r * std::sin(angle), random.uniform(0, length));
    });
    const Noise noise = noise_of(tube);
    CHECK(noise.strength > 0);
    const double measured = std::sqrt(noise.variance) / sigma;
    CHECK((measured > 0.5 && measured < 1.1));
  }
}

TEST_CASE("A tube is hidden by noise as wide, not by noise of a quarter of its radius")
{
  const double sigma = GENERATE(0.25, 1.); // radii
  constexpr double length = 40;
  for(unsigned seed = 0; seed < seeds; ++seed) {
    CAPTURE(seed, sigma);
    Random random(seed);
    const Gaussians tube = components(1500, [&] {
      const double angle = random.uniform(0, 2 * CGAL_PI);
      return Vector3(std::cos(angle) + sigma * random.normal(),
                     std::sin(angle) + sigma * random.normal(), random.uniform(0, length));
    });
    const auto across = [](const Vector3& p) { return std::hypot(p.x(), p.y()); };
    const double radius = root_mean_square(kept(consolidated(tube), across));
    CHECK((sigma < 1 ? radius > 0.6 : radius < 0.4));
  }
}

TEST_CASE("A lattice of thin tubes is no noise, one of lines in as much noise is")
{
  // From afar both are a plane with noise, from nearby both show neither planes nor lines.
  constexpr int meshes = 4, points_of_edge = 60;
  constexpr double radius = 0.12; // 1.2 spacings
  const bool is_noisy = GENERATE(false, true);
  for(unsigned seed = 0; seed < seeds; ++seed) {
    CAPTURE(seed, is_noisy);
    Random random(seed);
    const auto across = [&]() -> Eigen::Vector2d {
      const double angle = random.uniform(0, 2 * CGAL_PI);
      if(is_noisy)
        return radius * std::sqrt(0.5) * Eigen::Vector2d(random.normal(), random.normal());
      return radius * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    };
    const double noise = consolidated(lattice(meshes, points_of_edge, random, across)).noise;
    if(is_noisy)
      CHECK(noise > 0.9);
    else
      CHECK(noise == 0);
  }
}

TEST_CASE("A net in noise stays a net, which is no plane to any window")
{
  constexpr int meshes = 5, points_of_edge = 200;
  const double noise = GENERATE(0.03, 0.06); // of meshes of width 1
  for(unsigned seed = 0; seed < seeds; ++seed) {
    CAPTURE(seed, noise);
    Random random(seed);
    const Gaussians net = lattice(meshes, points_of_edge, random, [&]() -> Eigen::Vector2d {
      return noise * Eigen::Vector2d(random.normal(), random.normal());
    });
    const Measured_noise measured = measured_noise_of(net);
    CHECK(measured.noise.strength == 1);
    CHECK(measured.window < 0.5);
    const Consolidated_mixture result = consolidated(net);
    const auto off_wires = [](const Vector3& p) {
      const double x = p[0] - std::round(p[0]), y = p[1] - std::round(p[1]);
      return std::hypot(std::min(std::abs(x), std::abs(y)), p[2]);
    };
    CHECK(root_mean_square(kept(result, off_wires)) < noise);
    const int wire = 2;
    std::vector<double> along_wire;
    for(const Gaussian& component : result.components)
      if(std::abs(component.mean[1] - wire) < 2 * noise)
        along_wire.push_back(component.mean[0]);
    CHECK(widest_gap(along_wire) < 0.25);
  }
}

TEST_CASE("Hardly a component is in the middle of a tube, many are in that of noise")
{
  constexpr std::size_t size = 2000;
  const double of_noise = std::sqrt(std::log(0.9) / std::log(0.5)); // Rayleigh distribution
  for(unsigned seed = 0; seed < seeds; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const auto shortest_of = [](const std::function<Vector3()>& draw) {
      std::vector<Local_shape> along_x(size); // their axis is that by default
      std::vector<Vector3> ways;
      for(std::size_t i = 0; i < size; ++i)
        ways.push_back(draw());
      return shortest_across(along_x, ways, Noise_options());
    };
    const auto on_circle = [&] {
      const double angle = random.uniform(0, 2 * CGAL_PI);
      return Vector3(random.normal(), std::cos(angle), std::sin(angle));
    };
    CHECK(shortest_of(on_circle) == Approx(1));
    CHECK(shortest_of([&] { return random.normal_vector(); }) == Approx(of_noise).margin(0.05));
    CHECK(shortest_of([&] { return Vector3(random.normal(), 0, random.normal()); }) <
          0.6 * of_noise);
    CHECK(shortest_of([] { return Vector3(1, 0, 0); }) == 0);
  }
}

TEST_CASE("A twig drowned in noise becomes thin and does not gather in lumps")
{
  constexpr double sigma = 0.01;
  for(unsigned seed = 0; seed < seeds; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Gaussians twig = components(1000, [&] { // of 500 nothing is known but the points
      const double x = random.uniform(), y = sigma * random.normal(), z = sigma * random.normal();
      return Vector3(x, y, z);
    });
    const auto along = [](const Vector3& p) { return p.x(); };
    const auto across = [](const Vector3& p) { return std::hypot(p.y(), p.z()); };
    const Consolidated_mixture surface = consolidated(twig);
    CHECK(root_mean_square(kept(surface, across)) < sigma);
    CHECK(widest_gap(kept(surface, along)) < 3 * sigma);
  }
}

TEST_CASE("Between two limbs as thin as their noise hardly a component remains")
{
  for(unsigned seed = 0; seed < seeds; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    constexpr double noise = 0.01, radius = 2 * noise, apart = 9 * noise;
    const Gaussians limbs = components(20000, [&] {
      const double angle = random.uniform(0, 2 * CGAL_PI);
      const double axis = random.uniform() < 0.5 ? -apart / 2 : apart / 2;
      return Vector3(axis + radius * std::cos(angle) + noise * random.normal(),
                     radius * std::sin(angle) + noise * random.normal(), random.uniform(-0.5, 0.5));
    });
    const std::vector<double> to_the_middle =
      kept(consolidated(limbs), [](const Vector3& p) { return std::abs(p[0]); });
    const auto between =
      std::count_if(to_the_middle.begin(), to_the_middle.end(),
                    [&](double x) { return x < apart / 2 - radius - noise; });
    CHECK(between < static_cast<std::ptrdiff_t>(to_the_middle.size() / 1000));
  }
}

TEST_CASE("Points far from all others are outliers")
{
  for(unsigned seed = 0; seed < seeds; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    Gaussians sphere = components(2000, [&] { return random.direction(); });
    sphere.push_back({1, Vector3(2, 0, 0), Matrix3::Zero()});
    const Consolidated_mixture surface = consolidated(sphere);
    CHECK(is_outlier(surface, sphere.size() - 1));
    CHECK(surface.components.size() > sphere.size() - 20);
  }
}

TEST_CASE("Twigs whose points are far apart are no outliers, points spread in space are")
{
  const bool is_twig = GENERATE(false, true);
  for(unsigned seed = 0; seed < seeds; ++seed) {
    CAPTURE(seed, is_twig);
    Random random(seed);
    Gaussians tree = components(2000, [&] { return random.direction(); });
    const std::size_t first = tree.size();
    constexpr double length = 3; // twenty points: about four spacings of the sphere apart
    for(int k = 0; k < 20; ++k) {
      const Vector3 place = length * Vector3(random.uniform(), random.uniform(), random.uniform());
      tree.push_back({1, is_twig ? Vector3(1.1 + place.x(), 0.02 * place.y(), 0)
                                 : Vector3(place + Vector3::Constant(1.2)),
                      Matrix3::Zero()});
    }
    const Consolidated_mixture surface = consolidated(tree);
    int dropped = 0;
    for(std::size_t i = first; i < tree.size(); ++i)
      dropped += is_outlier(surface, i) ? 1 : 0;
    CHECK((is_twig ? dropped < 5 : dropped == 20));
  }
}

TEST_CASE("Of what is kept, the components and their neighbours belong together")
{
  for(const double sigma : {0.0, 0.03}) { // kept as they were, and moved
    CAPTURE(sigma);
    Random random(1);
    Gaussians sphere =
      components(2000, [&] { return Vector3((1 + sigma * random.normal()) * random.direction()); });
    sphere.insert(sphere.begin(), {1, Vector3(3, 0, 0), Matrix3::Zero()});
    const Consolidated_mixture surface = consolidated(sphere);
    CHECK(is_outlier(surface, 0));
    CHECK((surface.noise > 0) == (sigma > 0));
    double weight = 0, left = 0;
    for(const Gaussian& component : surface.components)
      weight += component.weight;
    for(std::size_t i = 0; i < sphere.size(); ++i)
      left += is_outlier(surface, i) ? 0 : sphere[i].weight;
    CHECK(weight == Approx(left));
    REQUIRE(surface.neighbors.size() == surface.components.size());
    const K_nearest_neighbors expected =
      k_nearest_neighbors(Box_tree(means_of(surface.components)), surface.neighbors.k(), Concurrency::sequential);
    for(std::size_t i = 0; i < expected.size(); ++i)
      for(std::size_t k = 0; k < expected.k(); ++k)
        REQUIRE(surface.neighbors[i].begin()[k].index == expected[i].begin()[k].index);
  }
}

TEST_CASE("Components that come to lie in one cell are merged, with their weight")
{
  constexpr double sigma = 0.03;
  Random random(2);
  const Gaussians plane = components(2000, [&] {
    const double x = random.uniform(), y = random.uniform(), z = sigma * random.normal();
    return Vector3(x, y, z);
  });
  const Consolidated_mixture apart = consolidated(plane);
  const Consolidated_mixture merged =
    consolidate(plane, Neighborhood(plane, Concurrency::sequential), 0.05, Consolidation_options(),
                Concurrency::sequential);
  CHECK(merged.components.size() < apart.components.size() / 2);
  const auto weight = [](const Consolidated_mixture& mixture) {
    double sum = 0;
    for(const Gaussian& component : mixture.components)
      sum += component.weight;
    return sum;
  };
  CHECK(weight(merged) == Approx(weight(apart)));
}

TEST_CASE("A mixture much finer than its noise is coarsened to it, whatever its resolution")
{
  constexpr double sigma = 0.04;
  for(unsigned seed = 0; seed < seeds; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    std::vector<double> numbers;
    for(const std::size_t size : {4000u, 32000u}) {
      const Gaussians sphere = components(
        size, [&] { return Vector3((1 + sigma * random.normal()) * random.direction()); });
      const double cell_size = std::sqrt(4 * CGAL_PI / static_cast<double>(size));
      const Consolidated_mixture surface =
        consolidate(sphere, Neighborhood(sphere, Concurrency::sequential), cell_size,
                    Consolidation_options(), Concurrency::sequential);
      CHECK(surface.cell_size >= cell_size);
      double radius = 0; // planes fitted to a sphere are inside of it
      for(double r : kept(surface, [](const Vector3& p) { return p.norm(); }))
        radius += r / static_cast<double>(surface.components.size());
      const auto off = [radius](const Vector3& p) { return p.norm() - radius; };
      CHECK(root_mean_square(kept(surface, off)) < sigma / 2);
      double weight = 0, left = 0;
      for(const Gaussian& component : surface.components)
        weight += component.weight;
      for(std::size_t i = 0; i < size; ++i)
        left += is_outlier(surface, i) ? 0 : sphere[i].weight;
      CHECK(weight == Approx(left));
      numbers.push_back(static_cast<double>(surface.components.size()));
    }
    CHECK(numbers[1] < 4 * numbers[0]); // of eight times as many points
  }
}

TEST_CASE("Any number of threads takes the same noise off")
{
  Random random(3);
  for(const double sigma : {0.0, 0.05}) {
    CAPTURE(sigma);
    const Gaussians sphere =
      components(3000, [&] { return Vector3((1 + sigma * random.normal()) * random.direction()); });
    const Consolidated_mixture expected = consolidated(sphere);
    for_threads([&](Concurrency concurrency) {
      const Consolidated_mixture surface = consolidated(sphere, concurrency);
      CHECK(surface.noise == expected.noise);
      CHECK(surface.merged_into == expected.merged_into);
      CHECK(means_of(surface.components) == means_of(expected.components));
    });
  }
}

TEST_CASE("The exponential by its Taylor polynomial has nine digits")
{
  for(double x = -1.0 / 7; x <= 0; x += 1e-4)
    REQUIRE(exponential_of_32_times(x) == Approx(std::exp(32 * x)).epsilon(1e-8));
}
