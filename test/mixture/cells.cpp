// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Sets and maps of cells against those of the standard library.

#include "catch2.h"

#include <CGAL/Point_set_skeletonization_3/internal/mixture/Cell_map.h>
#include <CGAL/Point_set_skeletonization_3/internal/mixture/Cell_set.h>
#include <CGAL/Point_set_skeletonization_3/internal/mixture/Cubic_grid.h>
#include <CGAL/Point_set_skeletonization_3/internal/mixture/Moment_grid.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <random>
#include <set>
#include <vector>

namespace cells_test {

using namespace CGAL::Point_set_skeletonization_3::internal;

namespace {

constexpr unsigned int seeds[] = {1, 2, 3};

// Cells that come again, near each other and far apart.
class Random_cells
{
public:
  explicit Random_cells(unsigned int seed) : generator_(seed) {}

  Grid_cell operator()()
  {
    const std::int32_t wide = generator_() % 10 == 0 ? 1 << (axis_bits - 1) : 32;
    return {{place(wide), place(wide) / 4, place(wide) / 8}};
  }

private:
  std::int32_t place(std::int32_t wide)
  {
    return static_cast<std::int32_t>(generator_() % static_cast<unsigned>(2 * wide)) - wide;
  }

  std::mt19937 generator_;
};

std::set<std::uint64_t> content(const Cell_set& set)
{
  const std::vector<std::uint64_t> cells = set.cells();
  CHECK(cells.size() == set.size());
  return {cells.begin(), cells.end()};
}

} // namespace

TEST_CASE("A cell is the same when it was packed, and packed cells are in lexicographic order")
{
  for(const unsigned int seed : seeds) {
    CAPTURE(seed);
    Random_cells cells(seed);
    for(int i = 0; i < 1000; ++i) {
      const Grid_cell a = cells(), b = cells();
      REQUIRE(unpacked(packed(a)) == a);
      REQUIRE((packed(a) < packed(b)) == (a < b));
    }
  }
}

TEST_CASE("A map of cells has the values that std::map has")
{
  for(const unsigned int seed : seeds) {
    CAPTURE(seed);
    Random_cells cells(seed);
    Cell_map<int> map, roomy(20000);
    std::map<std::uint64_t, int> expected;
    for(int i = 0; i < 20000; ++i) {
      const std::uint64_t cell = packed(cells());
      REQUIRE(map[cell] == expected[cell]); // 0 if it is new
      map[cell] = roomy[cell] = expected[cell] = i;
      REQUIRE(map.size() == expected.size());
    }
    for(const Cell_map<int>* found : {&map, &roomy}) {
      std::map<std::uint64_t, int> all;
      found->for_each([&](std::uint64_t cell, int value) { all.emplace(cell, value); });
      CHECK(all == expected);
      for(const auto& entry : expected)
        REQUIRE(found->at(entry.first) == entry.second);
    }
  }
  Cell_map<int>().for_each([](std::uint64_t, int) { FAIL("there is no cell"); });
}

TEST_CASE("A set of cells holds what std::set holds, alone, added up and coarsened")
{
  for(const unsigned int seed : seeds) {
    CAPTURE(seed);
    Random_cells cells(seed);
    std::array<Cell_set, 2> sets;
    std::array<std::set<std::uint64_t>, 2> expected;
    for(int i = 0; i < 20000; ++i) {
      const Grid_cell cell = cells();
      const std::size_t k = i % 3 == 0 ? 1 : 0; // they share cells, and blocks
      sets[k].insert(cell);
      expected[k].insert(packed(cell));
      REQUIRE(sets[k].size() == expected[k].size());
    }
    CHECK(content(sets[0]) == expected[0]);
    CHECK(content(sets[1]) == expected[1]);

    Cell_set sum = sets[0], other = sets[1];
    sum.add(sets[1]);
    other.add(sets[0]);
    std::set<std::uint64_t> both = expected[0];
    both.insert(expected[1].begin(), expected[1].end());
    CHECK(content(sum) == both);
    CHECK(content(other) == both);

    std::set<std::uint64_t> around;
    for(std::uint64_t cell : both)
      around.insert(packed(Cell_around(2)(unpacked(cell))));
    CHECK(content(sum.coarsened()) == around);
  }
  CHECK(Cell_set().cells().empty());
}

TEST_CASE("Cells with moments have numbers of their own, in the order in which they came")
{
  for(const unsigned int seed : seeds) {
    CAPTURE(seed);
    Random_cells cells(seed);
    Moment_cells moments;
    std::map<std::uint64_t, std::uint64_t> numbers;
    for(int i = 0; i < 5000; ++i) {
      const Grid_cell cell = cells();
      moments.add(cell, Lattice_point());
      ++numbers[packed(cell)];
      REQUIRE(moments.size() == numbers.size());
      REQUIRE(moments.cells()[moments.number(cell)] == packed(cell));
    }
    const Moment_cells same(moments.cells()); // of the same cells, without moments
    for(std::size_t k = 0; k < moments.size(); ++k) {
      REQUIRE(moments.moments()[k].number() == numbers.at(moments.cells()[k]));
      REQUIRE(same.number(unpacked(moments.cells()[k])) == k);
      REQUIRE(same.moments()[k].number() == 0);
    }
  }
}

TEST_CASE("The cell around a cell, or a point, is that of whole numbers")
{
  for(std::int32_t factor = 1; factor < 40; ++factor)
    for(std::int32_t place = -200; place < 200; ++place) {
      const double quotient = std::floor(static_cast<double>(place) / factor);
      REQUIRE(Cell_around(factor)({{place, 0, 0}})[0] == static_cast<std::int32_t>(quotient));
    }
  const Cubic_grid grid{10, 3};
  for(const double x : {-0.4, -1e-9, 0.0, 0.003, 0.25}) {
    CAPTURE(x);
    const Grid_cell cell = Cell_of_point(grid)(lattice_point(Vector3(x, x, x)));
    CHECK(cell == Grid_cell{{cell[0], cell[0], cell[0]}});
    CHECK(cell[0] * grid.cell_size() <= x);
    CHECK(x < (cell[0] + 1) * grid.cell_size());
  }
}

} // namespace cells_test
