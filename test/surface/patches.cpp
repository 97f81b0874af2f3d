// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What patches know of their neighbours: edges, signs of normals, and what is inside.

#include "two_spheres.h"

#include "catch2.h"
#include "generator/Random.h"
#include "threads.h"

#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch_graph.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Surface.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Surface_options.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/facing.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/orient_patches.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/settle_orientation.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace patches_test {

using namespace CGAL::Point_set_skeletonization_3::internal;
using surfaces::patches_of_sphere;
using surfaces::tree_of;
using surfaces::two_spheres;

namespace {

constexpr unsigned int seeds[] = {1, 2, 3};
const Surface_options options;

bool points_outwards(const Patches& patches, std::size_t i)
{
  const Vector3 center = surfaces::center_of_sphere(i / patches_of_sphere);
  return patches[i].normal.dot(patches[i].mean - center) > 0;
}

// Links of random trust and sign between random numbers below `size`.
std::vector<Sign_link> random_links(std::size_t size, std::size_t number, shapes::Random& random)
{
  std::vector<Sign_link> links;
  const auto last = static_cast<int>(size) - 1;
  while(links.size() < number) {
    const int a = random.integer(0, last), b = random.integer(0, last);
    if(a == b)
      continue;
    Sign_link link;
    link.a = static_cast<decltype(link.a)>(std::min(a, b));
    link.b = static_cast<decltype(link.b)>(std::max(a, b));
    link.index = static_cast<decltype(link.index)>(links.size());
    link.trust = random.uniform();
    link.is_opposite = random.uniform() < 0.5;
    links.push_back(link);
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
    auto a = result[link.a], b = result[link.b];
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

// The torus as points only.
Gaussians components_of_torus()
{
  Gaussians result;
  for(const Patch& patch : surfaces::torus.patches())
    result.push_back({1, patch.mean, Matrix3::Zero()});
  return result;
}

} // namespace

TEST_CASE("Every pair of neighbours is an edge of both")
{
  const Patches patches = two_spheres();
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

TEST_CASE("A patch of a sphere has its normal and its share of the area")
{
  const Patches patches = two_spheres();
  double area = 0;
  for(std::size_t i = 0; i < patches.size(); ++i) {
    const Vector3 center = surfaces::center_of_sphere(i / patches_of_sphere);
    REQUIRE(std::abs(patches[i].normal.dot(patches[i].mean - center)) > 0.98 * 0.4);
    REQUIRE(patches[i].planarity > 0.5);
    area += patches[i].area;
  }
  CHECK(area == Approx(2 * 4 * CGAL_PI * 0.4 * 0.4).epsilon(0.3)); // a disc is not a cell
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
      Signed_pieces pieces = signed_pieces(links, size);
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
    Patches patches = two_spheres();
    for(Patch& patch : patches)
      if(random.uniform() < 0.5)
        patch.normal = -patch.normal;
    orient_patches(patches, Concurrency::sequential);
    for(std::size_t i = 0; i < patches.size(); ++i)
      REQUIRE(points_outwards(patches, i));
  }
}

TEST_CASE("A limb that is inside out is turned around")
{
  Patches patches = surfaces::torus.patches();
  std::size_t turned = 0;
  for(Patch& patch : patches)
    if(patch.mean.x() > 0.2 && ++turned)
      patch.normal = -patch.normal;
  REQUIRE(turned > patches.size() / 4);
  settle_orientation(patches, tree_of(patches), options, Concurrency::sequential);
  const Patches right = surfaces::torus.patches();
  std::size_t wrong = 0;
  for(std::size_t i = 0; i < patches.size(); ++i)
    wrong += patches[i].normal.dot(right[i].normal) < 0;
  CHECK(wrong < turned / 10); // the seam
}

TEST_CASE("Two sheets that face each other through the air are no neighbours, if that is sure")
{
  Patches patches(2);
  patches[0] = {Vector3(0, 0, 0), 1, 1, 1, Vector3(0, 0, 1), 1, false, 1, {1}};
  patches[1] = {Vector3(0.1, 0, 1), 1, 1, 1, Vector3(0, 0, -1), 1, false, 1, {0}};
  CHECK(face_each_other(patches[0], patches[1], options));
  CHECK(are_opposite_sheets(patches[0], patches[1], options));
  Patches doubtful = patches;
  part_facing_patches(patches, {1, 1}, options, Concurrency::sequential);
  CHECK((patches[0].neighbors.empty() && patches[1].neighbors.empty()));
  part_facing_patches(doubtful, {1, 0}, options, Concurrency::sequential);
  CHECK((doubtful[0].neighbors.size() == 1 && doubtful[1].neighbors.size() == 1));

  // The two sides of a limb face each other through the shape.
  for(Patch& patch : patches)
    patch.normal = -patch.normal;
  CHECK(face_each_other(patches[0], patches[1], options));
  // On a crease one is above the other, and the other below it.
  patches[1].normal = Vector3(std::sqrt(0.5), 0, -std::sqrt(0.5));
  CHECK_FALSE(face_each_other(patches[0], patches[1], options));
}

TEST_CASE("A torus is read as one oriented surface, by any number of threads")
{
  const Gaussians components = components_of_torus();
  const Box_tree tree(means_of(components));
  const K_nearest_neighbors nearest =
    k_nearest_neighbors(tree, surface_neighbors + 1, Concurrency::sequential);
  const Patches fine = estimate_patches(components, nearest, options, Concurrency::sequential);
  const Patch_groups groups(components.size());
  const Surface expected =
    build_surface(components, tree, fine, groups, false, options, Concurrency::sequential);
  const Patches right = surfaces::torus.patches();
  for_threads([&](Concurrency concurrency) {
    const Surface surface =
      build_surface(components, tree, fine, groups, false, options, concurrency);
    CHECK(surface.confidence == expected.confidence);
    for(std::size_t i = 0; i < right.size(); ++i) {
      REQUIRE(surface.patches[i].normal == expected.patches[i].normal);
      REQUIRE(surface.patches[i].neighbors == expected.patches[i].neighbors);
      REQUIRE(surface.patches[i].normal.dot(right[i].normal) > 0.9);
      REQUIRE(surface.confidence[i] > options.trusted_orientation);
    }
    CHECK(surface.winding_number(surfaces::around(1)) > 0.75);
    CHECK(surface.winding_number(Vector3::Zero()) < 0.25);
  });
}

} // namespace patches_test
