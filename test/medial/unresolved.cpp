// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Patches of limbs that are not resolved, and where the middle of such limbs is.

#include "surface_of.h"

#include "catch2.h"
#include "generator/Random.h"

#include <CGAL/Point_set_skeletonization_3/internal/medial/Sample.h>
#include <CGAL/Point_set_skeletonization_3/internal/medial/project_to_lines.h>
#include <CGAL/Point_set_skeletonization_3/internal/medial/sample_kinds.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

using namespace CGAL::Point_set_skeletonization_3::internal;

namespace {

constexpr unsigned int seed = 7;

/// How coplanar patches of one sheet are at least.
constexpr double least_coplanarity = 0.5;

/// Patches at places, without normals, of which the other side was not seen.
Patches patches_at(const std::vector<Vector3>& places)
{
  Patches result;
  for(const Vector3& place : places) {
    Patch patch;
    patch.mean = place;
    patch.spacing = patch.weight = patch.area = 1;
    result.push_back(patch);
  }
  return result;
}

Samples samples_on(const Patches& patches)
{
  Samples result;
  for(const Patch& patch : patches)
    result.push_back({patch.mean, 0});
  return result;
}

std::vector<bool> unresolved_at(const std::vector<Vector3>& places)
{
  const Patches patches = patches_at(places);
  return unresolved_patches(surfaces::surface_of(patches), samples_on(patches), least_coplanarity);
}

} // namespace

TEST_CASE("A sheet is resolved up to its rim, what is scattered or a line is not")
{
  CAPTURE(seed);
  shapes::Random random(seed);
  std::vector<Vector3> sheet, cloud, line;
  for(int x = 0; x < 16; ++x)
    for(int y = 0; y < 16; ++y)
      sheet.emplace_back(x, y, 0);
  for(int k = 0; k < 1000; ++k) {
    const double x = random.uniform(0, 10), y = random.uniform(0, 10), z = random.uniform(0, 10);
    cloud.emplace_back(x, y, z);
  }
  for(int k = 0; k < 40; ++k)
    line.emplace_back(k, 0, 0);
  const auto number = [](const std::vector<bool>& marks) {
    return std::count(marks.begin(), marks.end(), true);
  };
  CHECK(number(unresolved_at(sheet)) == 0);
  CHECK(number(unresolved_at(cloud)) > 900);
  CHECK(number(unresolved_at(line)) == 40);
}

TEST_CASE("At the rim of a sheet of large patches, a row of small ones is no line")
{
  constexpr int length = 48, large = 4; // spacings of the small ones
  std::vector<Vector3> rim, inside, components;
  for(int x = 0; x < length; ++x) {
    rim.emplace_back(x, 0, 0);
    for(int y = 0; y < length; ++y)
      components.emplace_back(x, y, 0);
  }
  for(int x = 0; x < length; x += large)
    for(int y = large; y < length; y += large)
      inside.emplace_back(x, y, 0);
  Patches patches = patches_at(rim);
  for(Patch& patch : patches_at(inside)) {
    patch.spacing = large;
    patch.components = large * large;
    patches.push_back(patch);
  }
  Surface surface = surfaces::surface_of(patches);
  surface.components = components;
  surface.component_tree = Box_tree(components);
  const std::vector<bool> marks =
    unresolved_patches(surface, samples_on(patches), least_coplanarity);
  CHECK(std::count(marks.begin(), marks.end(), true) == 0);
}

TEST_CASE("A sheet with creases is resolved, scattered patches as planar are not")
{
  CAPTURE(seed);
  shapes::Random random(seed);
  constexpr int wall = 4; // patches
  Patches folded, scattered;
  Vector3 place = Vector3::Zero();
  for(int row = 0; row < 10 * wall; ++row) {
    const bool is_rising = row / wall % 2 == 1;
    place += is_rising ? Vector3::UnitZ() : Vector3::UnitX();
    for(int y = 0; y < 20; ++y) {
      Patch patch;
      patch.mean = place + y * Vector3::UnitY();
      patch.normal = is_rising ? Vector3::UnitX() : Vector3::UnitZ();
      patch.spacing = patch.weight = patch.area = patch.planarity = 1;
      folded.push_back(patch);
      patch.mean = 4.5 * random.uniform_vector();
      patch.normal = random.direction();
      scattered.push_back(patch);
    }
  }
  const auto share_of_unresolved = [](Patches patches) {
    for(std::size_t i = 0; i < patches.size(); ++i)
      for(std::size_t j = 0; j < patches.size(); ++j)
        if(i != j && (patches[i].mean - patches[j].mean).norm() < 1.5)
          patches[i].neighbors.push_back(j);
    const std::vector<bool> marks = unresolved_patches(
      surfaces::surface_of(patches), samples_on(patches), least_coplanarity);
    return static_cast<double>(std::count(marks.begin(), marks.end(), true)) /
           static_cast<double>(marks.size());
  };
  CHECK(share_of_unresolved(folded) == 0);
  CHECK(share_of_unresolved(scattered) > 0.9);
}

TEST_CASE("A strip two patches wide looks like a line, but its patches are on a surface")
{
  CAPTURE(seed);
  shapes::Random random(seed);
  constexpr int length = 40; // patches
  for(const int width : {2, 1}) {
    CAPTURE(width);
    std::vector<Vector3> places;
    for(int x = 0; x < length; ++x)
      for(int y = 0; y < width; ++y)
        places.emplace_back(x, y, 0);
    Patches patches = patches_at(places);
    for(std::size_t i = 0; i < patches.size(); ++i) {
      patches[i].area = patches[i].planarity = 1;
      patches[i].normal = width > 1 ? Vector3(Vector3::UnitZ()) : random.direction();
      for(std::size_t j = 0; j < patches.size(); ++j)
        if(i != j && (patches[i].mean - patches[j].mean).norm() < 1.5)
          patches[i].neighbors.push_back(j);
    }
    const Surface surface = surfaces::surface_of(patches);
    const Unresolved_limbs limbs =
      unresolved_limbs(surface, samples_on(patches), least_coplanarity);
    const auto unresolved = std::count(limbs.is_of_twig.begin(), limbs.is_of_twig.end(), true) +
                            std::count(limbs.is_loose.begin(), limbs.is_loose.end(), true);
    CHECK(2 * static_cast<std::size_t>(unresolved) > patches.size());
    const double share = share_unresolved(surface, limbs, least_coplanarity);
    if(width > 1)
      CHECK(share == 0);
    else // of one half no frame is kept; a few are as coplanar as those of a surface by chance
      CHECK(share > 0.5);
  }
}

TEST_CASE("What has a medial ball is resolved, unless most around it is not")
{
  CAPTURE(seed);
  shapes::Random random(seed);
  std::vector<Vector3> places;
  for(int k = 0; k < 1000; ++k) {
    const double x = random.uniform(0, 10), y = random.uniform(0, 10), z = random.uniform(0, 10);
    places.emplace_back(x, y, z);
  }
  const Patches patches = patches_at(places);
  const Surface surface = surfaces::surface_of(patches);
  Samples samples = samples_on(patches);
  samples[0].position += Vector3(0.5, 0, 0);
  CHECK(unresolved_patches(surface, samples, least_coplanarity)[0]);
  for(std::size_t i = 0; i < patches.size(); ++i)
    samples[i].position = patches[i].mean + Vector3(0.5, 0, 0);
  const std::vector<bool> none = unresolved_patches(surface, samples, least_coplanarity);
  CHECK(std::find(none.begin(), none.end(), true) == none.end());
}

TEST_CASE("The correlation dimension is that of lines, of surfaces and of space")
{
  for(unsigned s = seed; s < seed + 3; ++s) {
    CAPTURE(s);
    shapes::Random random(s);
    const auto dimension = [&](double width, double height) {
      const double length = 4000 / ((1 + width) * (1 + height)); // one place in a unit cube
      std::vector<Vector3> places;
      for(int k = 0; k < 4000; ++k) {
        const double x = random.uniform(0, length), y = random.uniform(0, width);
        places.emplace_back(x, y, random.uniform(0, height));
      }
      Components_around all;
      for(const Components_around& around :
          components_around(surfaces::surface_of(patches_at(places)),
                            std::vector<bool>(places.size(), true)))
        all.add(around);
      return std::array<double, 2>{all.dimension(), all.dimension_of_cloud()};
    };
    const std::array<double, 2> least_of_space{2.5, 2.4}; // four spacings reach the border oftener
    for(const std::size_t octaves : {0, 1}) {
      CHECK(dimension(0, 0)[octaves] < 1.3);
      const double of_surface = dimension(60, 0)[octaves], of_space = dimension(15, 15)[octaves];
      CHECK(of_surface > 1.8);
      CHECK(of_surface < 2.2);
      CHECK(of_space > least_of_space[octaves]);
    }
  }
  CHECK(Components_around().dimension() == 3);
  CHECK(Components_around().dimension_of_cloud() == 3);
}

TEST_CASE("Twigs are those of a cloud that mostly consists of lines")
{
  CAPTURE(seed);
  shapes::Random random(seed);
  const auto share_of_twigs = [](const std::vector<Vector3>& places, std::size_t begin,
                                 std::size_t end) {
    Patches patches = patches_at(places);
    for(std::size_t i = 0; i < places.size(); ++i)
      for(std::size_t j = 0; j < places.size(); ++j)
        if(i != j && (places[i] - places[j]).norm() < 1)
          patches[i].neighbors.push_back(j);
    const std::vector<bool> is_of_twig =
      unresolved_limbs(surfaces::surface_of(patches), samples_on(patches), least_coplanarity)
        .is_of_twig;
    const auto at = [&](std::size_t k) {
      return is_of_twig.begin() + static_cast<std::ptrdiff_t>(k);
    };
    return static_cast<double>(std::count(at(begin), at(end), true)) /
           static_cast<double>(end - begin);
  };
  std::vector<Vector3> twigs, scattered, sheet;
  for(int twig = 0; twig < 30; ++twig) {
    const Vector3 direction = random.direction(), root = 60 * random.uniform_vector();
    for(int k = 0; k < 30; ++k)
      twigs.push_back(root + 0.4 * k * direction + 0.1 * random.uniform_vector());
  }
  for(int k = 0; k < 1000; ++k)
    scattered.push_back(10 * random.uniform_vector());
  for(int x = 0; x < 50; ++x)
    for(int y = 0; y < 50; ++y)
      sheet.emplace_back(100 + x, y, 0);
  CHECK(share_of_twigs(twigs, 0, twigs.size()) > 0.9);
  CHECK(share_of_twigs(scattered, 0, scattered.size()) == 0);
  std::vector<Vector3> plant = twigs; // most of it is a leaf
  plant.insert(plant.end(), sheet.begin(), sheet.end());
  CHECK(share_of_twigs(plant, 0, plant.size()) == 0);
  std::vector<Vector3> tree = twigs; // with a limb as wide as the noise
  for(int k = 0; k < 100; ++k)
    tree.push_back(Vector3(100, 0, 0) + 5 * random.uniform_vector());
  CHECK(share_of_twigs(tree, 0, twigs.size()) > 0.9);
  CHECK(share_of_twigs(tree, twigs.size(), tree.size()) < 0.1);
}

TEST_CASE("Whatever is not resolved is of a twig or loose, as a limb two points wide among twigs")
{
  CAPTURE(seed);
  shapes::Random random(seed);
  std::vector<Vector3> places;
  for(int twig = 0; twig < 30; ++twig) {
    const Vector3 direction = random.direction(), root = 60 * random.uniform_vector();
    for(int k = 0; k < 30; ++k)
      places.push_back(root + 0.4 * k * direction + 0.1 * random.uniform_vector());
  }
  const std::size_t limb = places.size();
  for(int k = 0; k < 100; ++k) // a zigzag
    places.push_back(Vector3(100 + 0.4 * k, 0.8 * (k % 2), 0) + 0.1 * random.uniform_vector());
  Patches patches = patches_at(places);
  for(std::size_t i = 0; i < places.size(); ++i)
    for(std::size_t j = 0; j < places.size(); ++j)
      if(i != j && (places[i] - places[j]).norm() < 1.3)
        patches[i].neighbors.push_back(j);
  const Surface surface = surfaces::surface_of(patches);
  const std::vector<bool> is_unresolved =
    unresolved_patches(surface, samples_on(patches), least_coplanarity);
  const Unresolved_limbs limbs = unresolved_limbs(surface, samples_on(patches), least_coplanarity);
  CHECK(std::count(is_unresolved.begin() + static_cast<std::ptrdiff_t>(limb), is_unresolved.end(),
                   true) > 50);
  for(std::size_t i = 0; i < places.size(); ++i) {
    CHECK((!is_unresolved[i] || limbs.is_of_twig[i] || limbs.is_loose[i]));
    CHECK_FALSE((limbs.is_of_twig[i] && limbs.is_loose[i]));
  }
}

TEST_CASE("Places around a limb go to its middle, and not along it")
{
  CAPTURE(seed);
  shapes::Random random(seed);
  std::vector<Vector3> places;
  for(int k = 0; k < 400; ++k) {
    const Vector3 around = random.normal_vector();
    places.emplace_back(k / 8., around.y(), around.z());
  }
  const std::vector<Vector3> projected = project_to_lines(
    places, std::vector<double>(places.size(), 1), Concurrency::sequential);
  double before = 0, after = 0;
  for(std::size_t i = 50; i < 350; ++i) { // not at the ends
    before += std::hypot(places[i].y(), places[i].z());
    after += std::hypot(projected[i].y(), projected[i].z());
    CHECK(std::abs(projected[i].x() - places[i].x()) < 2);
  }
  CHECK(after < 0.5 * before);
}

TEST_CASE("Places on a line stay, whatever the unit")
{
  for(const double unit : {1e-3, 1., 1e3}) {
    std::vector<Vector3> places;
    for(int k = 0; k < 30; ++k)
      places.push_back(unit * k * Vector3(0.6, 0, 0.8));
    const std::vector<Vector3> projected = project_to_lines(
      places, std::vector<double>(places.size(), unit), Concurrency::parallel);
    for(std::size_t i = 0; i < places.size(); ++i)
      CHECK((projected[i] - places[i]).norm() < 1e-6 * unit);
  }
}
