// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Patches that follow the shape: components merged where they are flat, and what is left of their
// moments and adjacency.

#include "surface_of.h"

#include "catch2.h"
#include "generator/Random.h"

#include <CGAL/Point_set_skeletonization_3/internal/spatial/Box_tree.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/K_nearest_neighbors.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Component_gaps.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch_groups.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Surface.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Surface_options.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/contract_patches.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/estimate_patches.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/flat_groups.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <set>
#include <utility>
#include <vector>

namespace groups_test {

using namespace CGAL::Point_set_skeletonization_3::internal;
using shapes::Random;

namespace {

constexpr unsigned int seeds[] = {1, 2, 3};
constexpr double cell = 1.0 / 128;
const Surface_options options;

// One component in each of the cells that random places on a surface fall into.
Gaussians components_on(const std::function<Vector3(Random&)>& place, std::size_t places,
                        unsigned int seed)
{
  Random random(seed);
  std::set<std::vector<int>> cells;
  Gaussians result;
  for(std::size_t i = 0; i < places; ++i) {
    const Vector3 p = place(random);
    const Vector3 c = (p / cell).array().floor();
    if(cells.insert({static_cast<int>(c.x()), static_cast<int>(c.y()), static_cast<int>(c.z())})
         .second)
      result.push_back({1 + random.uniform(), p, Matrix3::Zero()});
  }
  return result;
}

Vector3 on_plane(Random& random)
{
  const double x = random.uniform(), y = random.uniform();
  return Vector3(x, y, 0.3 * x + 0.2 * y);
}

Gaussians sphere(double radius, unsigned int seed)
{
  const auto place = [radius](Random& random) { return Vector3(radius * random.direction()); };
  return components_on(place, 200000, seed);
}

K_nearest_neighbors neighbors_of(const Gaussians& components)
{
  return k_nearest_neighbors(Box_tree(means_of(components)), surface_neighbors + 1,
                             Concurrency::sequential);
}

Patches patches_of(const Gaussians& components)
{
  return estimate_patches(components, neighbors_of(components), options, Concurrency::sequential);
}

Patch_groups groups_of(const Gaussians& components, double cell_size = cell)
{
  return flat_groups(components, Box_tree(means_of(components)), patches_of(components), cell_size,
                     options, Concurrency::sequential);
}

double width(const Gaussians& components, const Patch_groups::Members& members)
{
  Eigen::AlignedBox3d box;
  for(std::size_t i : members)
    box.extend(components[i].mean);
  return box.sizes().maxCoeff();
}

} // namespace

TEST_CASE("Groups are a partition")
{
  const Patch_groups groups({2, 0, 2, 1, 0}, 3);
  CHECK(groups.size() == 3);
  const std::vector<std::vector<std::size_t>> expected = {{1, 4}, {3}, {0, 2}};
  for(std::size_t g = 0; g < groups.size(); ++g) {
    CHECK(std::vector<std::size_t>(groups[g].begin(), groups[g].end()) == expected[g]);
    for(std::size_t i : groups[g])
      CHECK(groups.group_of()[i] == g);
  }
  CHECK(Patch_groups(4).size() == 4);
  CHECK(Patch_groups().size() == 0);
}

TEST_CASE("A plane is merged into few patches, and the more so the larger it is")
{
  for(unsigned int seed : seeds) {
    CAPTURE(seed);
    const Gaussians plane = components_on(on_plane, 100000, seed);
    const Patch_groups groups = groups_of(plane);
    CHECK(groups.size() < plane.size() / 50);
  }
}

TEST_CASE("A straight line is divided into pieces that are about as long as wide")
{
  for(unsigned int seed : seeds)
    for(const double width : {0.02, 0.04}) {
      CAPTURE(seed, width);
      const Gaussians strip = components_on(
        [&](Random& random) {
          const double x = random.uniform(), y = width * random.uniform();
          return Vector3(x, y + 0.2 * x, 0.3 * x);
        },
        20000, seed);
      const Patch_groups groups = groups_of(strip);
      std::vector<double> least(groups.size(), 1), most(groups.size(), 0);
      for(std::size_t i = 0; i < strip.size(); ++i) {
        const std::size_t group = groups.group_of()[i];
        least[group] = (std::min)(least[group], strip[i].mean.x());
        most[group] = (std::max)(most[group], strip[i].mean.x());
      }
      double longest = 0;
      for(std::size_t group = 0; group < groups.size(); ++group)
        longest = (std::max)(longest, most[group] - least[group]);
      CHECK(longest < 4 * width); // widths of cells are powers of two
      CHECK(groups.size() < strip.size());
    }
}

TEST_CASE("Components of a thin twig stay alone, those of the leaf that it ends in do not")
{
  const double length = 0.5, leaf = 0.3;
  for(unsigned int seed : seeds)
    for(const double radius : {0.6 * cell, 1.2 * cell}) {
      CAPTURE(seed, radius / cell);
      Gaussians components = components_on(
        [&](Random& random) {
          const Vector3 across = radius * random.direction();
          const double x = length * random.uniform();
          return Vector3(x + 0.3 * across.x(), 0.4 * x + across.y(), 0.2 * x + across.z());
        },
        400, seed);
      const std::size_t of_twig = components.size();
      for(const Gaussian& g : components_on(on_plane, 40000, seed))
        components.push_back({g.weight, Vector3(length, 0.4 * length, 0.2 * length) + leaf * g.mean,
                              Matrix3::Zero()});
      const Patch_groups groups = groups_of(components);
      std::size_t alone_of_twig = 0, alone_of_leaf = 0;
      for(std::size_t i = 0; i < components.size(); ++i)
        if(groups[groups.group_of()[i]].size() == 1)
          ++(i < of_twig ? alone_of_twig : alone_of_leaf);
      CHECK(10 * alone_of_twig > 9 * of_twig);
      CHECK(2 * alone_of_leaf < components.size() - of_twig); // along its rim they do
    }
}

TEST_CASE("Patches of a sphere are as wide as it is round, however fine its components are")
{
  for(unsigned int seed : seeds) {
    CAPTURE(seed);
    const Gaussians small = sphere(0.1, seed), large = sphere(0.4, seed);
    const auto of_small = groups_of(small).size();
    const auto of_large = groups_of(large).size();
    const auto ratio = static_cast<double>(of_large) / static_cast<double>(of_small);
    CHECK(large.size() > 4 * small.size());
    CHECK(ratio > 0.3); // widths are powers of two: within a factor of two
    CHECK(ratio < 3);
  }
}

TEST_CASE("Two sheets share hardly a patch if there is a cell between them")
{
  for(unsigned int seed : seeds) {
    CAPTURE(seed);
    const Gaussians sheets = components_on(
      [](Random& random) {
        const double x = random.uniform(), y = random.uniform();
        return Vector3(x, y, random.uniform() < 0.5 ? 0 : 2 * cell);
      },
      100000, seed);
    const Patch_groups groups = connected_groups(groups_of(sheets), patches_of(sheets));
    std::size_t shared = 0;
    for(std::size_t g = 0; g < groups.size(); ++g)
      shared += std::any_of(groups[g].begin(), groups[g].end(), [&](std::size_t i) {
        return sheets[i].mean.z() != sheets[*groups[g].begin()].mean.z();
      });
    CHECK(shared < groups.size() / 50); // at the border, where normals are unreliable
  }
}

TEST_CASE("Groups depend on the components only, not on their order")
{
  for(unsigned int seed : seeds) {
    CAPTURE(seed);
    const Gaussians components = sphere(0.3, seed);
    Gaussians reversed(components.rbegin(), components.rend());
    const Patch_groups a = groups_of(components), b = groups_of(reversed);
    REQUIRE(a.size() == b.size());
    for(std::size_t g = 0; g < a.size(); ++g) {
      const std::size_t other = b.group_of()[components.size() - 1 - *a[g].begin()];
      REQUIRE(a[g].size() == b[other].size());
      for(std::size_t i : a[g])
        REQUIRE(b.group_of()[components.size() - 1 - i] == other);
    }
  }
}

TEST_CASE("Adjacent patches differ in width by a factor of two at most")
{
  for(unsigned int seed : seeds) {
    CAPTURE(seed);
    // A plane with a small sphere above it.
    Gaussians components = components_on(on_plane, 40000, seed);
    for(Gaussian& g : components)
      g.mean.z() = 0;
    for(Gaussian g : sphere(0.05, seed)) {
      g.mean += Vector3(0.5, 0.5, 0.06);
      components.push_back(g);
    }
    const Patch_groups groups = groups_of(components);
    // The octree cell of a group is at most twice as wide as its components and a cell, and at
    // least as wide as they are.
    for(std::size_t i = 0; i < components.size(); ++i)
      for(std::size_t j = i + 1; j < components.size(); ++j) {
        if((components[i].mean - components[j].mean).squaredNorm() > cell * cell / 4)
          continue;
        const double a = width(components, groups[groups.group_of()[i]]),
                     b = width(components, groups[groups.group_of()[j]]);
        // Beside a group that fills its cell.
        if(std::max(a, b) > 16 * cell)
          REQUIRE(groups[groups.group_of()[a > b ? j : i]].size() > 1);
      }
  }
}

TEST_CASE("Without cells, or with cells too small for an octree, nothing is merged")
{
  const Gaussians components = sphere(0.3, 1);
  CHECK(groups_of(components, 0).size() == components.size());
  CHECK(groups_of(components, 1e-9).size() == components.size());
}

TEST_CASE("Contraction keeps weight, mean, area and adjacency")
{
  for(unsigned int seed : seeds) {
    CAPTURE(seed);
    const Gaussians components = sphere(0.4, seed);
    const Patches fine = patches_of(components);
    const Patch_groups groups = connected_groups(groups_of(components), fine);
    REQUIRE(groups.size() < components.size() / 4);
    const Gaussians gaussians = contracted(components, groups, Concurrency::sequential);
    const Patches patches =
      contracted(fine, gaussians, groups, options, Concurrency::sequential);
    double weight = 0, area = 0, fine_weight = 0, fine_area = 0;
    Vector3 mean = Vector3::Zero(), fine_mean = Vector3::Zero();
    for(const Patch& patch : patches) {
      weight += patch.weight;
      area += patch.area;
      mean += patch.weight * patch.mean;
    }
    for(const Patch& patch : fine) {
      fine_weight += patch.weight;
      fine_area += patch.area;
      fine_mean += patch.weight * patch.mean;
    }
    CHECK(weight == Approx(fine_weight));
    CHECK(area == Approx(fine_area));
    CHECK((mean - fine_mean).norm() < 1e-9 * weight);
    std::size_t along = 0; // the radius
    for(std::size_t g = 0; g < patches.size(); ++g) {
      along += std::abs(patches[g].normal.dot(patches[g].mean.normalized())) > 0.9;
      for(std::size_t h : patches[g].neighbors) {
        REQUIRE(h != g);
        const std::vector<std::size_t>& back = patches[h].neighbors;
        REQUIRE(std::binary_search(back.begin(), back.end(), g));
      }
    }
    CHECK(along >= patches.size() - patches.size() / 50);
    // On one smooth sheet adjacency is that of the components.
    for(std::size_t i = 0; i < fine.size(); ++i)
      for(std::size_t j : fine[i].neighbors) {
        const std::size_t g = groups.group_of()[i], h = groups.group_of()[j];
        const std::vector<std::size_t>& next = patches[g].neighbors;
        REQUIRE((g == h || std::binary_search(next.begin(), next.end(), h)));
      }
  }
}

TEST_CASE("Gaps are those between components, in what these are apart, whatever the patches are")
{
  // Two groups of five components in a row, 0.1 apart, and 1.6 from the one to the other.
  Patches patches(2);
  std::vector<Vector3> components;
  std::vector<std::size_t> group_of;
  for(std::size_t group : {0, 1})
    for(int k = 0; k < 5; ++k) {
      components.emplace_back(2.0 * static_cast<double>(group) + 0.1 * k, 0, 0);
      group_of.push_back(group);
    }
  for(std::size_t group : {0, 1})
    patches[group].mean = components[5 * group + 2];
  Surface surface = surfaces::surface_of(patches);
  surface.component_tree = Box_tree(components);
  surface.components = std::move(components);
  surface.groups = Patch_groups(std::move(group_of), 2);
  const Component_gaps gaps(surface, Concurrency::sequential);
  CHECK(gaps.between(0, 1) == Approx(1.6));
  CHECK(gaps.between(1, 0) == Approx(1.6));
  CHECK(gaps.grain(0, 1) == Approx(0.1)); // the outer ones have none on the other side
}

} // namespace groups_test
