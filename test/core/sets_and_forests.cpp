// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Disjoint sets and spanning forests against the slowest way to find them.

#include "catch2.h"
#include "generator/Random.h"

#include <CGAL/Point_set_skeletonization_3/internal/core/Union_find.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/minimum_spanning_forest.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace sets_and_forests_test {

using namespace CGAL::Point_set_skeletonization_3::internal;

namespace {

constexpr unsigned int seeds[] = {1, 2, 3};
constexpr std::size_t size = 200; // numbers in sets

struct Link
{
  std::size_t a, b;
  int length; // many are equally long
  std::size_t index;

  bool operator<(const Link& other) const
  {
    return std::tie(length, index) < std::tie(other.length, other.index);
  }
};

std::vector<Link> random_links(std::size_t number, shapes::Random& random)
{
  constexpr int last = static_cast<int>(size) - 1;
  std::vector<Link> links;
  for(std::size_t k = 0; k < number; ++k) {
    const auto a = static_cast<std::size_t>(random.integer(0, last));
    const auto b = static_cast<std::size_t>(random.integer(0, last)); // may be the same
    links.push_back({a, b, random.integer(0, 9), k});
  }
  return links;
}

// The name of the set of every number, which is its smallest one.
class Named_sets
{
public:
  Named_sets() : name_(size) { std::iota(name_.begin(), name_.end(), std::size_t(0)); }

  std::size_t operator[](std::size_t v) const { return name_[v]; }

  bool join(std::size_t a, std::size_t b)
  {
    const auto [least, other] = std::minmax({name_[a], name_[b]});
    std::replace(name_.begin(), name_.end(), other, least);
    return least != other;
  }

private:
  std::vector<std::size_t> name_;
};

// Kruskal's algorithm: the indices of the links of the forest, ascending.
std::vector<std::size_t> kruskal(std::vector<Link> links, Named_sets& sets)
{
  std::sort(links.begin(), links.end());
  std::vector<std::size_t> result;
  for(const Link& link : links)
    if(sets.join(link.a, link.b))
      result.push_back(link.index);
  std::sort(result.begin(), result.end());
  return result;
}

std::vector<std::size_t> indices_of(const std::vector<Link>& links)
{
  std::vector<std::size_t> result;
  for(const Link& link : links)
    result.push_back(link.index);
  std::sort(result.begin(), result.end());
  return result;
}

} // namespace

TEST_CASE("A set has the name of its smallest number, in whatever order it was joined")
{
  for(const unsigned int seed : seeds) {
    CAPTURE(seed);
    shapes::Random random(seed);
    Union_find sets(size);
    Named_sets expected;
    for(const Link& link : random_links(150, random)) {
      REQUIRE(sets.join(link.a, link.b) == expected.join(link.a, link.b));
      for(std::size_t v = 0; v < size; ++v)
        REQUIRE(sets.find(v) == expected[v]);
    }
  }
}

TEST_CASE("The spanning forest is Kruskal's, and leaves its sets joined")
{
  for(const unsigned int seed : seeds)
    for(const std::size_t number : {0u, 50u, 300u, 3000u}) { // most alone, some trees, one tree
      CAPTURE(seed, number);
      shapes::Random random(seed);
      std::vector<Link> links = random_links(number, random);
      Named_sets expected_sets;
      const std::vector<std::size_t> expected = kruskal(links, expected_sets);

      Union_find sets(size);
      CHECK(indices_of(minimum_spanning_forest(sets, size, links)) == expected);
      for(std::size_t v = 0; v < size; ++v)
        REQUIRE(sets.find(v) == expected_sets[v]);

      // Links that are not stored, in another order.
      std::reverse(links.begin(), links.end());
      Union_find again(size);
      CHECK(indices_of(minimum_spanning_forest<Link>(again, size, [&](const auto& visit) {
              for(const Link& link : links)
                visit(link);
            })) == expected);
    }
}

TEST_CASE("A spanning forest keeps what was joined before")
{
  for(const unsigned int seed : seeds) {
    CAPTURE(seed);
    shapes::Random random(seed);
    Union_find sets(size);
    Named_sets expected_sets;
    for(const Link& link : random_links(80, random)) {
      sets.join(link.a, link.b);
      expected_sets.join(link.a, link.b);
    }
    const std::vector<Link> links = random_links(400, random);
    const std::vector<std::size_t> expected = kruskal(links, expected_sets);
    CHECK(indices_of(minimum_spanning_forest(sets, size, links)) == expected);
  }
}

} // namespace sets_and_forests_test
