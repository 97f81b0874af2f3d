// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial

// Every level of the grid describes the same points, whatever their order and number.

#include "catch2.h"

#include <CGAL/Point_set_skeletonization_3/internal/grid_moments.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <random>
#include <vector>

using namespace CGAL::Point_set_skeletonization_3::internal;
using CGAL::Parallel_if_available_tag;
using CGAL::Sequential_tag;
using Points = std::vector<Vector3>;
using Levels = std::vector<Grid_level>;

namespace {

constexpr std::size_t number_of_levels = 3;

// A bent sheet inside the normalised box, with a clump that is far denser than the rest.
Points cloud(std::size_t size, unsigned int seed)
{
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-0.28, 0.28);
  Points points;
  while(points.size() < size) {
    const double u = uniform(generator), v = uniform(generator);
    const double shrink = points.size() % 10 == 0 ? 0.01 : 1;
    points.emplace_back(shrink * u, shrink * v, shrink * (u * v + 0.01 * uniform(generator)));
  }
  return points;
}

// Points that are normalised already.
class Normalized_blocks : public Point_blocks
{
public:
  explicit Normalized_blocks(const Points& points) : points_(points) {}

  std::size_t size() const override { return points_.size(); }

  Points block(std::size_t b) const override
  {
    const auto begin = points_.begin() + static_cast<std::ptrdiff_t>(b * block_size);
    return Points(begin, begin + std::min<std::ptrdiff_t>(block_size, points_.end() - begin));
  }

private:
  const Points& points_;
};

template <typename ConcurrencyTag = Sequential_tag>
Levels levels_of(const Points& points, const Grid_options& options = Grid_options())
{
  return grid_moments<ConcurrencyTag>(Normalized_blocks(points), options, number_of_levels);
}

Gaussian total(const Gaussians& mixture)
{
  Moments moments(Vector3::Zero());
  for(const Gaussian& g : mixture)
    moments.add(g);
  return moments.gaussian();
}

Gaussian total(const Points& points)
{
  Moments moments(Vector3::Zero());
  for(const Vector3& p : points)
    moments.add(1, p);
  return moments.gaussian();
}

void check_equal(const Gaussian& a, const Gaussian& b)
{
  CHECK(a.weight == Approx(b.weight));
  CHECK((a.mean - b.mean).norm() < 1e-12);
  CHECK((a.covariance - b.covariance).norm() < 1e-12);
}

void check_same_bits(const Levels& a, const Levels& b)
{
  REQUIRE(a.size() == b.size());
  for(std::size_t k = 0; k < a.size(); ++k) {
    CHECK(a[k].cells == b[k].cells);
    CHECK(a[k].cell_size() == b[k].cell_size());
    REQUIRE(a[k].gaussians.size() == b[k].gaussians.size());
    for(std::size_t i = 0; i < a[k].gaussians.size(); ++i) {
      const Gaussian &g = a[k].gaussians[i], &h = b[k].gaussians[i];
      REQUIRE((g.weight == h.weight && g.mean == h.mean && g.covariance == h.covariance));
    }
  }
}

// The moments of the points that `cell_index()` gives each Gaussian of a level.
Gaussians gathered(const Grid_level& level, const Points& points)
{
  std::vector<Moments> moments;
  for(const Gaussian& g : level.gaussians)
    moments.emplace_back(g.mean);
  for(const Vector3& p : points) {
    const std::size_t i = level.cell_index(p);
    REQUIRE(i < moments.size());
    moments[i].add(1, p);
  }
  Gaussians result;
  for(const Moments& m : moments)
    result.push_back(m.gaussian());
  return result;
}

} // namespace

TEST_CASE("Every level keeps mass, mean and covariance of the points")
{
  for(std::size_t size : {2u, 100u, 3000u, 60000u}) {
    CAPTURE(size);
    const Points points = cloud(size, 1);
    const Levels levels = levels_of(points);
    REQUIRE(levels.size() == number_of_levels);
    for(const Grid_level& level : levels)
      check_equal(total(level.gaussians), total(points));
  }
}

TEST_CASE("A grid has at most the wanted number of patches and never stops far below it")
{
  for(std::size_t size : {100u, 3000u, 10000u, 60000u}) {
    CAPTURE(size);
    const Grid_options options;
    const std::size_t patches = levels_of(cloud(size, 2)).front().gaussians.size();
    CHECK(patches <= options.patches(size));
    CHECK(patches >= std::min(size / 10, options.patches(size) / 3));
  }
}

TEST_CASE("Levels nest: a cell and its points lie in one cell of the next level, twice as wide")
{
  const Points points = cloud(20000, 3);
  const Levels levels = levels_of(points);
  for(std::size_t k = 0; k + 1 < levels.size(); ++k) {
    const Grid_level &fine = levels[k], &coarse = levels[k + 1];
    CHECK(coarse.cell_size() == 2 * fine.cell_size());
    CHECK(coarse.gaussians.size() <= fine.gaussians.size());
    constexpr std::size_t none = static_cast<std::size_t>(-1);
    std::vector<std::size_t> parent(fine.gaussians.size(), none);
    for(const Vector3& p : points) {
      std::size_t& known = parent[fine.cell_index(p)];
      const std::size_t found = coarse.cell_index(p);
      REQUIRE((known == none || known == found));
      known = found;
    }
  }
}

TEST_CASE("A cell index leads to the Gaussian of the very points in the cell")
{
  const Points points = cloud(20000, 4);
  for(const Grid_level& level : levels_of(points)) {
    REQUIRE(std::is_sorted(level.cells.begin(), level.cells.end()));
    const Gaussians found = gathered(level, points);
    double worst = 0;
    for(std::size_t i = 0; i < found.size(); ++i) {
      REQUIRE(found[i].weight == level.gaussians[i].weight);
      worst = std::max({worst, (found[i].mean - level.gaussians[i].mean).norm(),
                        (found[i].covariance - level.gaussians[i].covariance).norm()});
    }
    CHECK(worst < 1e-12);
    for(const Vector3& p : points) {
      const Vector3 offset = p - level.gaussians[level.cell_index(p)].mean;
      REQUIRE(offset.lpNorm<Eigen::Infinity>() <= level.cell_size());
    }
  }
}

TEST_CASE("The order of the points changes nothing but rounding")
{
  Points points = cloud(30000, 5);
  const Levels before = levels_of(points);
  std::shuffle(points.begin(), points.end(), std::mt19937(6));
  const Levels after = levels_of(points);
  REQUIRE(before.size() == after.size());
  for(std::size_t k = 0; k < before.size(); ++k) {
    REQUIRE(before[k].cells == after[k].cells);
    for(std::size_t i = 0; i < before[k].gaussians.size(); ++i) {
      const Gaussian &g = before[k].gaussians[i], &h = after[k].gaussians[i];
      REQUIRE(g.weight == h.weight);
      REQUIRE((g.mean - h.mean).norm() < 1e-14);
      REQUIRE((g.covariance - h.covariance).norm() < 1e-14);
    }
  }
}

TEST_CASE("More points than a block and more cells than the fine grid holds")
{
  // Three blocks of up to 2^18 points have grids of their own; nearly every point has a cell.
  const Points points = cloud(600000, 7);
  Grid_options options;
  options.maximum_patches = 1000;
  const Levels sequential = levels_of(points, options);
  CHECK(sequential.front().gaussians.size() <= options.maximum_patches);
  check_equal(total(sequential.front().gaussians), total(points));
  check_same_bits(sequential, levels_of<Parallel_if_available_tag>(points, options));

  Points reversed(points.rbegin(), points.rend());
  CHECK(levels_of(reversed, options).front().cells == sequential.front().cells);
}

TEST_CASE("The concurrency tag does not change a bit")
{
  const Points points = cloud(5000, 8);
  check_same_bits(levels_of(points), levels_of<Parallel_if_available_tag>(points));
}

TEST_CASE("As few patches as a grid around the origin can have")
{
  Grid_options options;
  options.minimum_patches = options.maximum_patches = 8;
  CHECK(levels_of(cloud(1000, 9), options).front().gaussians.size() <= 8);
}

TEST_CASE("No points, one point, equal points")
{
  CHECK(levels_of(Points()).empty());
  for(std::size_t size : {1u, 2u, 1000u}) {
    CAPTURE(size);
    const Vector3 p(0.1, -0.2, 0.3);
    const Levels levels = levels_of(Points(size, p));
    REQUIRE(levels.size() == number_of_levels);
    for(const Grid_level& level : levels) {
      REQUIRE(level.gaussians.size() == 1);
      CHECK(level.gaussians[0].weight == static_cast<double>(size));
      CHECK((level.gaussians[0].mean - p).norm() < 1e-15);
      CHECK(level.gaussians[0].covariance.norm() < 1e-15);
      CHECK(level.cell_index(p) == 0);
    }
  }
}
