// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What patches know of their neighbours: edges, signs of normals, thickness.

#include "catch2.h"
#include "generator/Random.h"

#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch_graph.h>
#include <CGAL/Point_set_skeletonization_3/internal/medial/medial_balls.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/K_nearest_neighbors.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/patches.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/orient_patches.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

using CGAL::Sequential_tag;
using namespace CGAL::Point_set_skeletonization_3::internal;

namespace {

constexpr unsigned int seeds[] = {1, 2, 3};
const Vector3 centers[] = {Vector3(-0.6, 0, 0), Vector3(0.6, 0.1, 0)};
constexpr std::size_t patches_of_sphere = 600;

// Two spheres of radius 0.4, those of the first before those of the second.
std::vector<Patch> two_spheres()
{
  Gaussians gaussians;
  for(const Vector3& center : centers)
    for(std::size_t i = 0; i < patches_of_sphere; ++i) { // a spiral, with patches of equal area
      const double z = 1 - (2 * static_cast<double>(i) + 1) / patches_of_sphere;
      const double angle = CGAL_PI * (1 + std::sqrt(5)) * static_cast<double>(i);
      const Vector3 d(std::sqrt(1 - z * z) * std::cos(angle),
                      std::sqrt(1 - z * z) * std::sin(angle), z);
      gaussians.push_back({1, center + 0.4 * d, Matrix3::Zero()});
    }
  const Box_tree tree = tree_of_means<Sequential_tag>(gaussians);
  return surface_patches<Sequential_tag>(gaussians, patch_neighborhoods<Sequential_tag>(tree));
}

bool points_outwards(const std::vector<Patch>& patches, std::size_t i)
{
  return patches[i].normal.dot(patches[i].mean - centers[i / patches_of_sphere]) > 0;
}

// Links of random trust and sign between random numbers below `size`.
std::vector<Sign_link> random_links(std::size_t size, std::size_t number, shapes::Random& random)
{
  std::vector<Sign_link> links;
  const auto last = static_cast<int>(size) - 1;
  while(links.size() < number) {
    const auto a = static_cast<std::uint32_t>(random.integer(0, last));
    const auto b = static_cast<std::uint32_t>(random.integer(0, last));
    const double trust = random.uniform();
    const bool is_opposite = random.uniform() < 0.5;
    if(a != b)
      links.push_back({{std::min(a, b), std::max(a, b)}, trust, is_opposite});
  }
  return links;
}

// The first of the piece of every number, and whether it is opposite to that; from the links of the
// most trust to those of the least (Kruskal's algorithm).
std::vector<std::pair<std::size_t, bool>> pieces_of(std::vector<Sign_link> links, std::size_t size)
{
  std::sort(links.begin(), links.end(),
            [](const Sign_link& a, const Sign_link& b) { return a.trust > b.trust; });
  std::vector<std::pair<std::size_t, bool>> result;
  for(std::size_t i = 0; i < size; ++i)
    result.emplace_back(i, false);
  for(const Sign_link& link : links) {
    auto a = result[link.pair.a], b = result[link.pair.b];
    const bool is_opposite = link.is_opposite != (a.second != b.second);
    if(a.first == b.first)
      continue;
    if(a.first > b.first)
      std::swap(a, b);
    for(auto& piece : result)
      if(piece.first == b.first)
        piece = {a.first, piece.second != is_opposite};
  }
  return result;
}

} // namespace

TEST_CASE("Every pair of neighbours is an edge of both")
{
  const std::vector<Patch> patches = two_spheres();
  const std::vector<Patch_pair> pairs = adjacent_pairs(patches);
  std::size_t neighbors = 0;
  for(const Patch& patch : patches)
    neighbors += patch.neighbors.size();
  REQUIRE(2 * pairs.size() == neighbors);
  const Patch_graph all(patches, pairs);
  const Patch_graph odd(patches, pairs, [](std::size_t k) { return k % 2 == 1; });
  for(std::size_t i = 0; i < patches.size(); ++i) {
    std::vector<std::size_t> to;
    for(const auto& edge : all[i]) {
      to.push_back(edge.patch);
      REQUIRE(edge.length == Approx((patches[i].mean - patches[edge.patch].mean).norm()));
    }
    REQUIRE(to == patches[i].neighbors);
    std::vector<std::size_t> expected;
    for(std::size_t k = 1; k < pairs.size(); k += 2)
      if(pairs[k].a == i || pairs[k].b == i)
        expected.push_back(pairs[k].a == i ? pairs[k].b : pairs[k].a);
    to.clear();
    for(const auto& edge : odd[i])
      to.push_back(edge.patch);
    REQUIRE(to == expected);
  }
}

TEST_CASE("Signs are handed on along the links of the most trust")
{
  for(unsigned int seed : seeds) {
    CAPTURE(seed);
    shapes::Random random(seed);
    constexpr std::size_t size = 300;
    for(std::size_t number : {0u, 100u, 1000u}) { // most on their own, some pieces, one piece
      const std::vector<Sign_link> links = random_links(size, number, random);
      const auto expected = pieces_of(links, size);
      Signed_pieces pieces = spanned_pieces(links, size);
      for(std::size_t i = 0; i < size; ++i) {
        REQUIRE(pieces.piece(i) == expected[i].first);
        REQUIRE(pieces.is_opposite(i) == expected[i].second);
      }
    }
  }
}

TEST_CASE("Normals of closed surfaces come to point outwards")
{
  for(unsigned int seed : seeds) {
    CAPTURE(seed);
    shapes::Random random(seed);
    std::vector<Patch> patches = two_spheres();
    for(Patch& patch : patches)
      if(random.uniform() < 0.5)
        patch.normal = -patch.normal;
    orient_patches<Sequential_tag>(patches);
    for(std::size_t i = 0; i < patches.size(); ++i)
      REQUIRE(points_outwards(patches, i));
  }
}

TEST_CASE("Thickness changes no faster than half of the way")
{
  const std::vector<Patch> patches = two_spheres();
  for(unsigned int seed : seeds) {
    CAPTURE(seed);
    shapes::Random random(seed);
    std::vector<double> before(patches.size(), 0); // nothing is known of the second sphere
    for(std::size_t i = 0; i < patches_of_sphere; ++i)
      if(random.uniform() < 0.7)
        before[i] = random.uniform(0.1, 0.5);
    std::vector<double> after = before;
    limit_slope(after, patches);
    for(std::size_t i = 0; i < patches.size(); ++i) {
      if(i >= patches_of_sphere) {
        REQUIRE(after[i] == 0);
        continue;
      }
      double bound = 1e9;
      for(std::size_t j : patches[i].neighbors)
        bound = std::min(bound, after[j] + 0.5 * (patches[i].mean - patches[j].mean).norm());
      const double expected = before[i] > 0 ? std::min(before[i], bound) : bound;
      REQUIRE(after[i] == Approx(expected).epsilon(1e-12));
    }
  }
}
