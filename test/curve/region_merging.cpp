// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Which regions of a surface are one limb, by the overlaps along their borders.

#include "catch2.h"
#include "generator/Random.h"

#include <CGAL/Point_set_skeletonization_3/internal/core/Union_find.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Region_merging.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace region_merging_test {

using namespace CGAL::Point_set_skeletonization_3::internal;

namespace {

constexpr double least_overlap = 0.5;

/// The region of each patch, which was one of its own at first.
std::vector<std::size_t> merged(std::size_t patches, const std::vector<Border_link>& links)
{
  Union_find sets(patches);
  Region_merging(sets, patches, links, least_overlap).run();
  std::vector<std::size_t> result;
  for(std::size_t i = 0; i < patches; ++i)
    result.push_back(sets.find(i));
  return result;
}

Border_link link(std::size_t a, std::size_t b, double overlap, bool is_measured = true)
{
  return {a, b, a, b, overlap, is_measured};
}

/// Two limbs of `size` patches in a row each, that touch all along; patch `k` of the one touches
/// patch `size + k` of the other.
std::vector<Border_link> limbs_that_touch(std::size_t size, double contact)
{
  std::vector<Border_link> result;
  for(std::size_t limb = 0; limb < 2; ++limb)
    for(std::size_t k = 1; k < size; ++k)
      result.push_back(link(limb * size + k - 1, limb * size + k, 0.9));
  for(std::size_t k = 0; k < size; ++k)
    result.push_back(link(k, size + k, contact));
  return result;
}

} // namespace

TEST_CASE("A border that overlaps all along merges two regions, one that does not keeps them apart")
{
  constexpr std::size_t size = 10;
  const std::vector<std::size_t> one = merged(2 * size, limbs_that_touch(size, 0.6));
  for(std::size_t region : one)
    CHECK(region == 0);
  const std::vector<std::size_t> two = merged(2 * size, limbs_that_touch(size, 0.4));
  for(std::size_t i = 0; i < two.size(); ++i)
    CHECK(two[i] == i / size * size);
}

TEST_CASE("A single strong link or guess does not merge two regions across a weak border")
{
  constexpr std::size_t size = 10;
  for(const bool is_measured : {true, false}) {
    CAPTURE(is_measured);
    std::vector<Border_link> links = limbs_that_touch(size, 0.1);
    links.push_back(link(3, size + 4, is_measured ? 0.8 : 1, is_measured));
    const std::vector<std::size_t> regions = merged(2 * size, links);
    for(std::size_t i = 0; i < regions.size(); ++i)
      CHECK(regions[i] == i / size * size);
  }
}

TEST_CASE("A single weak link that is measured does not keep apart what overlaps by all guesses")
{
  // So it was; in frames of tubes hardly wider than their spacing joints came apart.
  constexpr std::size_t size = 10;
  for(const double guess : {0.9, 0.1}) {
    CAPTURE(guess);
    std::vector<Border_link> links = limbs_that_touch(size, guess);
    for(Border_link& contact : links)
      if(contact.patch_b == contact.patch_a + size) {
        contact.is_measured = contact.patch_a == 3;
        if(contact.is_measured)
          contact.overlap = 0;
      }
    CHECK(merged(2 * size, links).back() == (guess > least_overlap ? 0 : size));
  }
}

TEST_CASE("A weak border of few patches may be that of a thin limb, one of many is none")
{
  // Along the border the overlaps are 0.1 and 0.8 in turns: 0.45 in the mean.
  for(const std::size_t size : {4, 40}) {
    CAPTURE(size);
    std::vector<Border_link> links = limbs_that_touch(size, 0.1);
    for(Border_link& contact : links)
      if(contact.patch_b == contact.patch_a + size && contact.patch_a % 2 == 0)
        contact.overlap = 0.8;
    CHECK(merged(2 * size, links).back() == (size == 4 ? 0 : size));
  }
}

TEST_CASE("Where nothing is measured, the best guess decides")
{
  CHECK(merged(2, {link(0, 1, 0.1, false), link(0, 1, 1, false)}).back() == 0);
  CHECK(merged(2, {link(0, 1, 0.1, false), link(0, 1, 0.3, false)}).back() == 1);
}

TEST_CASE("Regions do not depend on the order of the links")
{
  constexpr std::size_t patches = 60;
  for(const unsigned int seed : {1u, 2u, 3u}) {
    CAPTURE(seed);
    shapes::Random random(seed);
    std::vector<Border_link> links;
    for(std::size_t a = 0; a < patches; ++a)
      for(std::size_t b = a + 1; b < patches && b < a + 5; ++b)
        links.push_back(link(a, b, random.uniform(), random.uniform() < 0.7));
    const std::vector<std::size_t> expected = merged(patches, links);
    for(std::size_t k = links.size(); k > 1; --k)
      std::swap(links[k - 1], links[static_cast<std::size_t>(random.uniform() *
                                                             static_cast<double>(k))]);
    CHECK(merged(patches, links) == expected);
  }
}

} // namespace region_merging_test
