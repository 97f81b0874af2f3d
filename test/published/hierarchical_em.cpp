// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// A level of a mixture is the mixture below it, seen from further away: nothing is lost or moved.

#include "catch2.h"
#include "threads.h"

#include <CGAL/Point_set_skeletonization_3/internal/published/hierarchical_em.h>
#include <CGAL/Point_set_skeletonization_3/internal/published/nearest_neighbor_gaussians.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <random>
#include <vector>

namespace hierarchical_em_test {

using namespace CGAL::Point_set_skeletonization_3::internal;
using Points = std::vector<Vector3>;

namespace {

Points torus(std::size_t size, double noise, unsigned int seed)
{
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform;
  std::normal_distribution<double> normal(0, 1);
  Points points;
  while(points.size() < size) {
    const double u = 2 * CGAL_PI * uniform(generator), v = 2 * CGAL_PI * uniform(generator);
    const double ring = 0.25 + 0.1 * std::cos(v);
    if(0.35 * uniform(generator) > ring)
      continue; // rejected, so that the density is uniform
    const Vector3 error(normal(generator), normal(generator), normal(generator));
    points.push_back(Vector3(ring * std::cos(u), ring * std::sin(u), 0.1 * std::sin(v)) +
                     noise * error);
  }
  return points;
}

Points images_of_integers(std::size_t size, const Vector3& step)
{
  Points points;
  for(std::size_t i = 0; i < size; ++i)
    points.push_back(static_cast<double>(i) * step);
  return points;
}

Points coplanar_grid(int width, double spacing)
{
  Points points;
  for(int i = 0; i < width; ++i)
    for(int j = 0; j < width; ++j)
      points.push_back(spacing * Vector3(i, j, 0));
  return points;
}

Gaussians finest(const Points& points)
{
  return nearest_neighbor_gaussians(points, Nearest_neighbor_options(), Concurrency::sequential);
}

std::vector<Gaussians> levels_of(const Points& points)
{
  return hierarchical_em(finest(points), Hierarchical_em_options(), Concurrency::sequential);
}

// The whole mixture as one Gaussian; `origin` is close to it, so that no digits cancel.
Gaussian total(const Gaussians& mixture, const Vector3& origin)
{
  Moments moments;
  for(const Gaussian& g : mixture)
    moments.add(g.weight, g.mean - origin, g.covariance);
  return moments.gaussian(origin);
}

bool is_positive_definite(const Matrix3& covariance)
{
  const Eigen::SelfAdjointEigenSolver<Matrix3> solver(covariance);
  return solver.eigenvalues()[0] > 0 && covariance.isApprox(covariance.transpose());
}

bool has_same_bits(const Gaussians& a, const Gaussians& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Gaussian& g, const Gaussian& h) {
                      return g.weight == h.weight && g.mean == h.mean &&
                             g.covariance == h.covariance;
                    });
}

template <typename T>
std::vector<T> shuffled(std::vector<T> values, unsigned int seed)
{
  std::mt19937 generator(seed);
  std::shuffle(values.begin(), values.end(), generator);
  return values;
}

// Steps 2 to 4 without logarithms or a search: the responsibilities of the parents (rows) for the
// children (columns), 0 where a parent may not claim a child.
Eigen::MatrixXd responsibilities(const Gaussians& parents, const Gaussians& children, double alpha)
{
  Eigen::MatrixXd result(parents.size(), children.size());
  for(Eigen::Index p = 0; p < result.rows(); ++p)
    for(Eigen::Index c = 0; c < result.cols(); ++c) {
      const Gaussian& parent = parents[static_cast<std::size_t>(p)];
      const Gaussian& child = children[static_cast<std::size_t>(c)];
      const Vector3 d = child.mean - parent.mean;
      const Matrix3 inverse = parent.covariance.inverse();
      const double distance = d.transpose() * inverse * d;
      const double trace = (inverse * child.covariance).trace();
      const double ratio = parent.covariance.determinant() / child.covariance.determinant();
      const double divergence = (trace + distance - 3 + std::log(ratio)) / 2;
      const double density =
        std::exp(-distance / 2) / std::sqrt((2 * CGAL_PI * parent.covariance).determinant());
      result(p, c) = divergence > alpha * alpha / 2
                       ? 0
                       : parent.weight * std::pow(density * std::exp(-trace / 2), child.weight);
    }
  for(Eigen::Index c = 0; c < result.cols(); ++c)
    if(result.col(c).sum() > 0)
      result.col(c) /= result.col(c).sum();
  return result;
}

// Step 5 and the merging, by textbook moments.
Gaussians textbook_level(const Gaussians& fine, const Hierarchical_em_options& options,
                         std::size_t level)
{
  Gaussians parents, children, result;
  for(const Gaussian& g : fine)
    (is_parent(g.mean, options, level) ? parents : children).push_back(g);
  const Eigen::MatrixXd share = responsibilities(parents, children, options.alpha);
  for(std::size_t p = 0; p < parents.size(); ++p) {
    const Vector3& origin = parents[p].mean;
    Moments moments;
    moments.add(parents[p].weight, Vector3::Zero(), parents[p].covariance);
    for(std::size_t c = 0; c < children.size(); ++c)
      moments.add(children[c].weight * share(Eigen::Index(p), Eigen::Index(c)),
                  children[c].mean - origin, children[c].covariance);
    result.push_back(moments.gaussian(origin));
  }
  for(std::size_t c = 0; c < children.size(); ++c)
    if(share.col(Eigen::Index(c)).sum() == 0)
      result.push_back(children[c]);
  return sorted_and_merged(result);
}

void check_levels(const Points& points)
{
  const std::vector<Gaussians> levels = levels_of(points);
  const Gaussian expected = total(levels.front(), points.front());
  const double size = expected.covariance.trace();
  for(std::size_t level = 0; level < levels.size(); ++level) {
    CAPTURE(level, levels[level].size());
    const Gaussian actual = total(levels[level], points.front());
    CHECK(actual.weight == Approx(static_cast<double>(points.size())));
    CHECK((actual.mean - expected.mean).norm() < 1e-12);
    CHECK((actual.covariance - expected.covariance).norm() < 1e-9 * size);
    for(const Gaussian& g : levels[level]) {
      REQUIRE(g.weight > 0);
      REQUIRE(is_positive_definite(g.covariance));
    }
    if(level > 0)
      CHECK(levels[level].size() <= levels[level - 1].size());
  }
}

} // namespace

TEST_CASE("A regularised covariance is well-conditioned whatever its scale")
{
  const double scale = GENERATE(1e-20, 1e-6, 1.0);
  const Matrix3 flat = scale * Vector3(2, 1, 0).asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Matrix3> solver(regularized(flat, 0.3));
  CHECK(solver.eigenvalues()[2] / solver.eigenvalues()[0] <= 1 + 3 / 0.3 + 1e-9);
  CHECK(is_positive_definite(regularized(Matrix3::Zero(), 0.3)));
}

TEST_CASE("A precision is the inverse and the logarithm of the determinant")
{
  Matrix3 covariance;
  covariance << 4, 1, 0, 1, 3, 0.5, 0, 0.5, 2;
  const Precision precision(covariance);
  CHECK((precision.inverse() * covariance - Matrix3::Identity()).norm() < 1e-7);
  CHECK(precision.log_determinant() == Approx(std::log(covariance.determinant())));
  CHECK(trace_of_product(precision.inverse(), covariance) == Approx(3));
  CHECK(largest_deviation(Vector3(9, 16, 4).asDiagonal()) == Approx(4));
}

TEST_CASE("The Gaussian of a grid point has the covariance of the ring of eight around it")
{
  const double s = 0.01;
  const Gaussians mixture = finest(coplanar_grid(9, s));
  const Gaussian& inner = mixture[4 * 9 + 4];
  const double flatness = Nearest_neighbor_options().flatness;
  // Six of eight neighbours are off by one spacing in x, and six in y.
  const Vector3 expected =
    s * s * (Vector3(0.75, 0.75, 0) + Vector3::Constant(flatness * 0.5));
  CHECK(inner.weight == 1);
  CHECK(inner.mean == Vector3(4 * s, 4 * s, 0));
  CHECK((inner.covariance - Matrix3(expected.asDiagonal())).norm() < 1e-12 * s);
}

TEST_CASE("Duplicates do not change the Gaussians of their neighbours")
{
  const unsigned int seed = 7;
  CAPTURE(seed);
  const Points once = torus(200, 0, seed);
  Points twice = once;
  twice.insert(twice.end(), once.begin(), once.end());
  Gaussians expected = finest(once);
  const Gaussians copy = expected;
  expected.insert(expected.end(), copy.begin(), copy.end());
  CHECK(has_same_bits(finest(twice), expected));
}

TEST_CASE("Every level keeps the weight, the mean and the covariance of the whole")
{
  const unsigned int seed = GENERATE(1u, 2u, 3u);
  CAPTURE(seed);
  SECTION("a surface") { check_levels(torus(4000, 0, seed)); }
  SECTION("a noisy surface") { check_levels(torus(4000, 0.01, seed)); }
  SECTION("a surface with duplicates and outliers")
  {
    Points points = torus(1000, 0, seed);
    points.insert(points.end(), 50, points.front());
    points.insert(points.end(), points.begin(), points.begin() + 500);
    for(double x : {-0.5, -0.1, 0.1, 0.5})
      points.emplace_back(x, 0.4, -0.4);
    check_levels(points);
  }
}

TEST_CASE("Degenerate points have levels as well")
{
  CHECK(levels_of({}).back().empty());
  SECTION("few points")
  {
    const std::size_t size = GENERATE(1u, 2u, 3u, 9u);
    CAPTURE(size);
    check_levels(images_of_integers(size, Vector3(0.05, 0.02, -0.01)));
  }
  SECTION("equal points are one component")
  {
    const Points points(5000, Vector3(0.1, -0.2, 0.3));
    check_levels(points);
    const Gaussians coarsest = levels_of(points).back();
    REQUIRE(coarsest.size() == 1);
    CHECK(coarsest.front().mean == points.front());
  }
  SECTION("collinear") { check_levels(images_of_integers(1000, Vector3(5e-4, 3e-4, 1e-4))); }
  SECTION("coplanar") { check_levels(coplanar_grid(40, 0.01)); }
}

TEST_CASE("The order of the points does not matter, to the last bit")
{
  const unsigned int seed = GENERATE(11u, 12u, 13u);
  CAPTURE(seed);
  Points points = torus(3000, 0.002, seed);
  const Points grid = coplanar_grid(20, 0.01); // neighbours at equal distances
  points.insert(points.end(), grid.begin(), grid.end());
  points.insert(points.end(), 20, points.front());

  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  order = shuffled(order, seed);
  const Gaussians mixture = finest(points);
  Points permuted;
  Gaussians expected;
  for(std::size_t i : order) {
    permuted.push_back(points[i]);
    expected.push_back(mixture[i]);
  }
  CHECK(has_same_bits(finest(permuted), expected));

  const std::vector<Gaussians> a = levels_of(points), b = levels_of(permuted);
  for(std::size_t level = 1; level < a.size(); ++level)
    CHECK(has_same_bits(a[level], b[level]));
}

TEST_CASE("Rounding of the input does not change which components merge")
{
  const unsigned int seed = 21;
  CAPTURE(seed);
  const Points points = torus(3000, 0, seed);
  Points rounded;
  for(const Vector3& p : points)
    rounded.push_back((p + Vector3(1000, -2000, 500)) - Vector3(1000, -2000, 500));
  const Gaussians a = levels_of(points).back(), b = levels_of(rounded).back();
  REQUIRE(a.size() == b.size());
  for(std::size_t i = 0; i < a.size(); ++i)
    REQUIRE((a[i].mean - b[i].mean).norm() < 1e-9);
}

TEST_CASE("The seed chooses the parents")
{
  const Points points = torus(1000, 0, 31);
  Hierarchical_em_options options;
  const Gaussians a = coarser_em_level(finest(points), options, 1, Concurrency::sequential);
  options.random_seed = 1;
  const Gaussians b = coarser_em_level(finest(points), options, 1, Concurrency::sequential);
  CHECK_FALSE(has_same_bits(a, b));
  CHECK(has_same_bits(b, coarser_em_level(finest(points), options, 1, Concurrency::sequential)));
}

TEST_CASE("A third of the components become parents")
{
  const Hierarchical_em_options options;
  const Points points = torus(20000, 0, 41);
  const auto parents = std::count_if(points.begin(), points.end(), [&](const Vector3& p) {
    return is_parent(p, options, 1);
  });
  // Within five standard deviations of the binomial distribution.
  CHECK(static_cast<double>(parents) == Approx(20000.0 / 3).margin(5 * 67));
}

TEST_CASE("A level is what the formulas say")
{
  const unsigned int seed = GENERATE(71u, 72u, 73u);
  CAPTURE(seed);
  const Hierarchical_em_options options;
  // Light and heavy components: weights are exponents, and small enough for no power to underflow.
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> weight(0.5, 3);
  Gaussians fine = finest(torus(150, 0.01, seed));
  for(Gaussian& g : fine)
    g.weight = weight(generator);

  const Gaussians actual = coarser_em_level(fine, options, 1, Concurrency::sequential);
  const Gaussians expected = textbook_level(fine, options, 1);
  REQUIRE(actual.size() < fine.size());
  REQUIRE(actual.size() == expected.size());
  for(std::size_t i = 0; i < actual.size(); ++i) {
    CHECK(actual[i].weight == Approx(expected[i].weight));
    CHECK((actual[i].mean - expected[i].mean).norm() < 1e-8);
    CHECK((actual[i].covariance - expected[i].covariance).norm() <
          1e-6 * expected[i].covariance.norm());
  }
}

TEST_CASE("Components that nobody claims survive unchanged")
{
  Gaussians apart;
  for(const Vector3& p : images_of_integers(50, Vector3(0.01, 0, 0)))
    apart.push_back({2, p, 1e-8 * Matrix3::Identity()});
  const Gaussians coarser =
    coarser_em_level(apart, Hierarchical_em_options(), 1, Concurrency::sequential);
  CHECK(has_same_bits(coarser, apart));
}

TEST_CASE("Mixtures of surfaces have sizes like the paper's")
{
  // There, a component stands for 5.8 to 15 points (figure 4); noise up to 1 % of the diagonal does
  // not change the number greatly (section 4.4).
  const unsigned int seed = 51;
  const double noise = GENERATE(0.0, 0.002, 0.01);
  const std::size_t size = GENERATE(4000u, 20000u);
  CAPTURE(seed, noise, size);
  const Gaussians coarsest = levels_of(torus(size, noise, seed)).back();
  const double points_per_component =
    static_cast<double>(size) / static_cast<double>(coarsest.size());
  CHECK(points_per_component > 5.8);
  CHECK(points_per_component < 15);
}

TEST_CASE("Threads do not change a bit")
{
  const unsigned int seed = 61;
  CAPTURE(seed);
  const Points points = torus(10000, 0.002, seed);
  const std::vector<Gaussians> expected = levels_of(points);
  for_threads([&](Concurrency concurrency) {
    const Gaussians start =
      nearest_neighbor_gaussians(points, Nearest_neighbor_options(), concurrency);
    CHECK(has_same_bits(finest(points), start));
    const std::vector<Gaussians> actual =
      hierarchical_em(start, Hierarchical_em_options(), concurrency);
    REQUIRE(actual.size() == expected.size());
    for(std::size_t level = 0; level < actual.size(); ++level)
      CHECK(has_same_bits(actual[level], expected[level]));
  });
}

} // namespace hierarchical_em_test
