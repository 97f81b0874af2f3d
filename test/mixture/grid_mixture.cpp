// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Every level of the grid describes the same points, whatever their order and number.

#include "catch2.h"
#include "points_source.h"
#include "threads.h"

#include <CGAL/Point_set_skeletonization_3/internal/core/Moments.h>
#include <CGAL/Point_set_skeletonization_3/internal/mixture/Grid_mixture.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <random>
#include <set>
#include <vector>

namespace grid_mixture_test {

using namespace CGAL::Point_set_skeletonization_3::internal;
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

// A similarity that leaves these points as they are, but for rounding.
Normalized_points normalized(const Points& points)
{
  return {source_of(points), Normalization()};
}

Grid_mixture mixture_of(const Points& points, const Grid_options& options = Grid_options(),
                        Concurrency concurrency = Concurrency::sequential)
{
  return grid_mixture(normalized(points), options, number_of_levels, concurrency);
}

Levels levels_of(const Points& points, const Grid_options& options = Grid_options())
{
  return mixture_of(points, options).levels;
}

Gaussian total(const Gaussians& mixture)
{
  Moments moments;
  for(const Gaussian& g : mixture)
    moments.add(g.weight, g.mean, g.covariance);
  return moments.gaussian(Vector3::Zero());
}

Gaussian total(const Points& points)
{
  Moments moments;
  for(const Vector3& p : points)
    moments.add(1, p);
  return moments.gaussian(Vector3::Zero());
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
    CHECK(a[k].grid.cell_size() == b[k].grid.cell_size());
    REQUIRE(a[k].cells.cells() == b[k].cells.cells());
    const Gaussians before = a[k].gaussians(), after = b[k].gaussians();
    for(std::size_t i = 0; i < before.size(); ++i) {
      const Gaussian &g = before[i], &h = after[i];
      REQUIRE((g.weight == h.weight && g.mean == h.mean && g.covariance == h.covariance));
    }
  }
}

// The place of the Gaussian that holds the moments of `p`, which is one of the points.
std::size_t cell_index(const Grid_level& level, const Vector3& p)
{
  return level.cells.number(Cell_of_point(level.grid)(lattice_point(p)));
}

// The moments of the points that `cell_index()` gives each Gaussian of a level.
Gaussians gathered(const Grid_level& level, const Points& points)
{
  const Gaussians means = level.gaussians();
  std::vector<Moments> moments(means.size());
  for(const Vector3& p : points) {
    const std::size_t i = cell_index(level, p);
    REQUIRE(i < moments.size());
    moments[i].add(1, p - means[i].mean);
  }
  Gaussians result;
  for(std::size_t i = 0; i < means.size(); ++i)
    result.push_back(moments[i].gaussian(means[i].mean));
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
      check_equal(total(level.gaussians()), total(points));
  }
}

TEST_CASE("A grid has at most the wanted number of cells and never stops far below it")
{
  for(std::size_t size : {100u, 3000u, 10000u, 60000u}) {
    CAPTURE(size);
    const Grid_options options;
    const std::size_t cells = levels_of(cloud(size, 2)).front().cells.size();
    CHECK(cells <= options.cells(size));
    CHECK(cells >= std::min(size / 10, options.cells(size) / 3));
  }
}

TEST_CASE("Cells are as coarse as the smallest feature allows, but not coarser than they must be")
{
  const Points points = cloud(60000, 14);
  const Grid_level before = levels_of(points).front();
  std::size_t cells = before.cells.size();
  for(double feature = 1e-9; feature < 1e9; feature *= 1.3) {
    CAPTURE(feature);
    Grid_options options;
    options.smallest_feature = feature;
    const Levels levels = levels_of(points, options);
    const Grid_level& level = levels.front();
    check_equal(total(level.gaussians()), total(points));
    CHECK(level.cells.size() <= cells); // the thicker, the fewer
    cells = level.cells.size();
    const double width = level.grid.cell_size(), wanted = feature / Grid_options::cells_across_limb;
    if(wanted <= before.grid.cell_size())
      check_same_bits(levels, levels_of(points));
    else
      CHECK(width <= wanted);
    const bool are_few = 2 * cells < 3 * Grid_options().minimum_cells;
    CHECK((are_few || width > 0.9 * wanted || cells == before.cells.size()));
  }
  CHECK(cells > Grid_options().minimum_cells / 2);
}

TEST_CASE("Levels nest: a cell and its points lie in one cell of the next level, twice as wide")
{
  const Points points = cloud(20000, 3);
  const Levels levels = levels_of(points);
  for(std::size_t k = 0; k + 1 < levels.size(); ++k) {
    const Grid_level &fine = levels[k], &coarse = levels[k + 1];
    CHECK(coarse.grid.cell_size() == 2 * fine.grid.cell_size());
    CHECK(coarse.cells.size() <= fine.cells.size());
    constexpr std::size_t none = static_cast<std::size_t>(-1);
    std::vector<std::size_t> parent(fine.cells.size(), none);
    for(const Vector3& p : points) {
      std::size_t& known = parent[cell_index(fine, p)];
      const std::size_t found = cell_index(coarse, p);
      REQUIRE((known == none || known == found));
      known = found;
    }
  }
}

TEST_CASE("A cell index leads to the Gaussian of the very points in the cell")
{
  const Points points = cloud(20000, 4);
  for(const Grid_level& level : levels_of(points)) {
    const std::vector<std::uint64_t>& cells = level.cells.cells();
    REQUIRE(std::is_sorted(cells.begin(), cells.end()));
    const Gaussians found = gathered(level, points), gaussians = level.gaussians();
    double worst = 0;
    for(std::size_t i = 0; i < found.size(); ++i) {
      REQUIRE(found[i].weight == gaussians[i].weight);
      worst = std::max({worst, (found[i].mean - gaussians[i].mean).norm(),
                        (found[i].covariance - gaussians[i].covariance).norm()});
    }
    CHECK(worst < 1e-12);
    for(const Vector3& p : points) {
      const Vector3 offset = p - gaussians[cell_index(level, p)].mean;
      REQUIRE(offset.lpNorm<Eigen::Infinity>() <= level.grid.cell_size());
    }
  }
}

TEST_CASE("Every point knows its cell in the first level")
{
  const Points points = cloud(100000, 10);
  Grid_mixture mixture = mixture_of(points, Grid_options(), Concurrency::parallel);
  REQUIRE(mixture.cell_of_point.size() == points.size());
  for(std::size_t i = 0; i < points.size(); ++i)
    REQUIRE(mixture.cell_of_point[i] == cell_index(mixture.levels.front(), points[i]));
  mixture.cell_of_point.forget_below(50000);
  REQUIRE(mixture.cell_of_point[99999] == cell_index(mixture.levels.front(), points[99999]));
}

TEST_CASE("The grid of the occupied cells is the finest there may be, whatever some points suggest")
{
  std::mt19937 generator(12);
  std::uniform_real_distribution<double> uniform(-0.28, 0.28);
  // From level to level there are twice, four times and eight times as many cells.
  const std::size_t dimension = GENERATE(1u, 2u, 3u);
  const std::size_t maximum = GENERATE(300u, 3000u, 30000u, 100000u); // the last for all points
  // With few of them there are no more cells on the next levels.
  const std::size_t places = GENERATE(2000u, 60000u);
  CAPTURE(dimension, maximum, places);
  Points points(places, Vector3::Constant(0.1));
  for(Vector3& p : points)
    for(std::size_t k = 0; k < dimension; ++k)
      p[static_cast<Eigen::Index>(k)] = uniform(generator);
  while(points.size() < 60000)
    points.push_back(points[points.size() - places]);
  std::set<std::uint64_t> expected;
  int level = finest_level(maximum) + 1;
  do {
    --level;
    expected.clear();
    for(const Vector3& p : points)
      expected.insert(packed(Cell_of_point(Cubic_grid{level, 1})(lattice_point(p))));
  } while(expected.size() > maximum);
  for(const Concurrency concurrency : {Concurrency::sequential, Concurrency::parallel}) {
    const Fine_cells fine = fine_cells(normalized(points), maximum, concurrency, Progress());
    CHECK(fine.grid.level == level);
    CHECK(std::set<std::uint64_t>(fine.cells.begin(), fine.cells.end()) == expected);
  }
}

TEST_CASE("Any order of the points gives the same bits")
{
  Points points = cloud(30000, 5);
  const Levels before = levels_of(points);
  std::shuffle(points.begin(), points.end(), std::mt19937(6));
  check_same_bits(levels_of(points), before);
}

// Threads meet in cells of hundreds of points, and the grid that is read first gets coarser
// above four cells a wanted one.
TEST_CASE("Any number of threads gives the same bits, of clouds of any size")
{
  for(const std::size_t size : {5000u, 100000u, 250000u})
    for(const std::size_t cells : {200u, 6000u, 100000u}) {
      CAPTURE(size, cells);
      const Points points = cloud(size, 7); // nearly every point has a cell of the finest grid
      Grid_options options;
      options.minimum_cells = options.maximum_cells = cells;
      const Grid_mixture expected = mixture_of(points, options);
      CHECK(expected.levels.front().cells.size() <= cells);
      check_equal(total(expected.levels.front().gaussians()), total(points));
      for_threads([&](Concurrency concurrency) {
        const Grid_mixture mixture = mixture_of(points, options, concurrency);
        check_same_bits(mixture.levels, expected.levels);
        std::size_t differences = 0;
        for(std::size_t i = 0; i < size; ++i)
          differences += mixture.cell_of_point[i] != expected.cell_of_point[i];
        CHECK(differences == 0);
      });
      const Points reversed(points.rbegin(), points.rend());
      check_same_bits(levels_of(reversed, options), expected.levels);
    }
}

TEST_CASE("Reading a large cloud can be cancelled at any report")
{
  const Points points = cloud(600000, 13);
  std::size_t reports = 0;
  const auto read = [&](std::size_t last) {
    reports = 0;
    grid_mixture(normalized(points), Grid_options(), number_of_levels, Concurrency::parallel,
                 Progress([&](double) { return reports++ < last; }));
  };
  read(static_cast<std::size_t>(-1));
  const std::size_t all = reports;
  REQUIRE(all > 2);
  for(std::size_t last = 0; last < all; ++last) {
    CHECK_THROWS_AS(read(last), Cancelled);
    CHECK(reports == last + 1); // nobody asks again
  }
}

TEST_CASE("As few patches as a grid around the origin can have")
{
  Grid_options options;
  options.minimum_cells = options.maximum_cells = 8;
  CHECK(levels_of(cloud(1000, 9), options).front().cells.size() <= 8);
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
      REQUIRE(level.cells.size() == 1);
      const Gaussian found = level.gaussians().front();
      CHECK(found.weight == static_cast<double>(size));
      CHECK((found.mean - p).norm() <= 1 / lattice_steps);
      CHECK(found.covariance.norm() == 0);
      CHECK(cell_index(level, p) == 0);
    }
  }
}

} // namespace grid_mixture_test
