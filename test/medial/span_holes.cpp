// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Patches across holes in the side of a limb become adjacent.

#include "surface_of.h"

#include "catch2.h"

#include <CGAL/Point_set_skeletonization_3/internal/medial/span_holes.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

namespace span_holes_test {

using namespace CGAL::Point_set_skeletonization_3::internal;
using surfaces::across;

namespace {

/// The patches of which `is_kept(number)`, with new numbers.
template <typename IsKept>
Patches some_of(const Patches& patches, const IsKept& is_kept)
{
  std::vector<std::size_t> number;
  std::size_t kept = 0;
  for(std::size_t i = 0; i < patches.size(); ++i)
    number.push_back(is_kept(i) ? kept++ : patches.size());
  Patches result;
  for(std::size_t i = 0; i < patches.size(); ++i) {
    if(!is_kept(i))
      continue;
    result.push_back(patches[i]);
    std::vector<std::size_t>& neighbors = result.back().neighbors;
    for(std::size_t& j : neighbors)
      j = number[j];
    neighbors.erase(std::remove(neighbors.begin(), neighbors.end(), patches.size()),
                    neighbors.end());
  }
  return result;
}

/// A torus without a strip of `width` patches all along one side.
Patches torus_with_slit(int width)
{
  return some_of(surfaces::torus.patches(), [width](std::size_t i) {
    return static_cast<int>(i) % across >= width;
  });
}

/// The same patches, with new neighbours.
Patches with_holes_spanned(const Patches& patches)
{
  Surface surface = surfaces::surface_of(patches);
  span_holes(surface, surfaces::samples_of(patches), Medial_options(), Concurrency::sequential);
  return surface.patches;
}

bool have_same_neighbors(const Patches& a, const Patches& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Patch& p, const Patch& q) {
    return p.neighbors == q.neighbors;
  });
}

bool are_adjacent(std::size_t i, std::size_t j, const Patches& patches)
{
  const std::vector<std::size_t>& neighbors = patches[i].neighbors;
  return std::binary_search(neighbors.begin(), neighbors.end(), j);
}

} // namespace

TEST_CASE("Where there is no hole nothing becomes adjacent")
{
  const Patches patches = surfaces::torus.patches();
  CHECK(have_same_neighbors(with_holes_spanned(patches), patches));
}

TEST_CASE("What is across a slit along a limb becomes adjacent, and nothing else")
{
  const int width = GENERATE(1, 2, 3, 4);
  CAPTURE(width);
  const Patches patches = torus_with_slit(width), spanned = with_holes_spanned(patches);
  const auto left = static_cast<std::size_t>(across - width);
  for(std::size_t i = 0; i < patches.size(); ++i) {
    const std::size_t place = i % left; // in its ring
    const bool is_on_border = place == 0 || place == left - 1;
    CAPTURE(i);
    REQUIRE(std::is_sorted(spanned[i].neighbors.begin(), spanned[i].neighbors.end()));
    REQUIRE((spanned[i].neighbors.size() > patches[i].neighbors.size()) == is_on_border);
    for(std::size_t j : spanned[i].neighbors) {
      REQUIRE(are_adjacent(j, i, spanned));
      if(!are_adjacent(i, j, patches))
        REQUIRE(place + j % left == left - 1); // one is on the one border, one on the other
    }
  }
}

TEST_CASE("Patches at one place, as of samples made elsewhere, are adjacent once")
{
  Patches patches = torus_with_slit(2);
  const std::size_t copy = patches.size();
  patches.push_back(patches.front()); // on the border
  for(std::size_t i : patches.front().neighbors)
    patches[i].neighbors.push_back(copy);
  patches.front().neighbors.push_back(copy);
  patches.back().neighbors.insert(patches.back().neighbors.begin(), 0);
  for(const Patch& patch : with_holes_spanned(patches))
    REQUIRE(std::adjacent_find(patch.neighbors.begin(), patch.neighbors.end(),
                               std::greater_equal<std::size_t>()) == patch.neighbors.end());
}

TEST_CASE("A limb of which more than a third of the way around is missing may be open")
{
  const int width = GENERATE(6, 8, 10);
  CAPTURE(width);
  const Patches patches = torus_with_slit(width);
  CHECK(have_same_neighbors(with_holes_spanned(patches), patches));
}

TEST_CASE("Two limbs with a slit each, side by side, are not joined")
{
  Patches patches = torus_with_slit(2);
  const std::size_t size = patches.size();
  Patches other = patches;
  for(Patch& patch : other) {
    patch.mean.z() += 2.2 * surfaces::tube_radius; // just beside it
    for(std::size_t& j : patch.neighbors)
      j += size;
  }
  patches.insert(patches.end(), other.begin(), other.end());
  const Patches spanned = with_holes_spanned(patches);
  CHECK(!have_same_neighbors(spanned, patches));
  for(std::size_t i = 0; i < spanned.size(); ++i)
    for(std::size_t j : spanned[i].neighbors)
      REQUIRE((i < size) == (j < size));
}

} // namespace span_holes_test
