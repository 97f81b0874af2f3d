// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// A scene is divided into its objects.

#include "catch2.h"
#include "generator/Random.h"

#include <CGAL/Point_set_skeletonization_3/internal/consolidation/Neighborhood.h>
#include <CGAL/Point_set_skeletonization_3/internal/consolidation/scene_objects.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace scene_objects_test {

using namespace CGAL::Point_set_skeletonization_3::internal;
using shapes::Random;

namespace {

using Objects = std::vector<std::vector<std::size_t>>;

void add_sphere(Gaussians& cloud, std::size_t size, const Vector3& centre, double radius,
                Random& random)
{
  for(std::size_t k = 0; k < size; ++k)
    cloud.push_back({1, centre + radius * random.direction(), Matrix3::Zero()});
}

Objects objects_in(const Gaussians& cloud)
{
  return scene_objects(cloud, Neighborhood(cloud, Concurrency::sequential).nearest,
                       Scene_options(), Concurrency::sequential);
}

/// The components from `begin` to before `end`.
std::vector<std::size_t> range(std::size_t begin, std::size_t end)
{
  std::vector<std::size_t> result(end - begin);
  std::iota(result.begin(), result.end(), begin);
  return result;
}

/// Two spheres of radius 1 and of another, with a gap between them.
Gaussians two_spheres(double radius, double gap, Random& random)
{
  Gaussians cloud;
  add_sphere(cloud, 1000, Vector3::Zero(), 1, random);
  add_sphere(cloud, 300, Vector3(1 + gap + radius, 0, 0), radius, random);
  return cloud;
}

} // namespace

TEST_CASE("What is further apart than the smaller is long are two objects")
{
  const unsigned seed = GENERATE(1u, 2u, 3u);
  const double radius = GENERATE(0.3, 0.6, 1.);
  const double unit = GENERATE(1., 1e-3);
  CAPTURE(seed, radius, unit);
  Random random(seed);
  Gaussians near = two_spheres(radius, 0.8 * 2 * radius, random);
  Gaussians far = two_spheres(radius, 1.2 * 2 * radius, random);
  for(Gaussians* cloud : {&near, &far})
    for(Gaussian& g : *cloud)
      g.mean *= unit;
  CHECK(objects_in(near) == Objects{range(0, 1300)});
  CHECK(objects_in(far) == Objects{range(0, 1000), range(1000, 1300)});
}

TEST_CASE("The objects of a scene do not depend on the order of its components")
{
  const unsigned seed = GENERATE(1u, 2u, 3u);
  CAPTURE(seed);
  Random random(seed);
  const Gaussians cloud = two_spheres(0.5, 3, random);
  std::vector<std::size_t> order = range(0, cloud.size());
  for(std::size_t k = order.size(); k-- > 1;)
    std::swap(order[k], order[static_cast<std::size_t>(random.integer(0, static_cast<int>(k)))]);
  Gaussians shuffled;
  for(std::size_t i : order)
    shuffled.push_back(cloud[i]);
  const auto before = [&](std::vector<std::size_t> object) {
    CHECK(std::is_sorted(object.begin(), object.end()));
    for(std::size_t& i : object)
      i = order[i];
    std::sort(object.begin(), object.end());
    return object;
  };
  Objects objects;
  for(const std::vector<std::size_t>& object : objects_in(shuffled))
    objects.push_back(before(object));
  std::sort(objects.begin(), objects.end());
  CHECK(objects == objects_in(cloud));
}

TEST_CASE("Outliers join no objects, and go with the nearest")
{
  const unsigned seed = GENERATE(1u, 2u, 3u);
  CAPTURE(seed);
  Random random(seed);
  constexpr double gap = 3;
  Gaussians cloud = two_spheres(1, gap, random);
  const std::size_t size = cloud.size();
  for(const double x : {1.9, 3.1}) // 0.9 of 3 from the nearer one
    for(const double y : {-1, 0, 1})
      cloud.push_back({1, Vector3(x, y, 0), Matrix3::Zero()});
  const Objects objects = objects_in(cloud);
  REQUIRE(objects.size() == 2);
  const auto is_in = [&](std::size_t object, std::size_t i) {
    return std::binary_search(objects[object].begin(), objects[object].end(), size + i);
  };
  for(std::size_t i = 0; i < 3; ++i) {
    CAPTURE(i);
    CHECK(is_in(0, i));
    CHECK(is_in(1, i + 3));
  }
  // So many that they are neighbours of each other.
  cloud.resize(size);
  for(int k = 0; k < 50; ++k)
    cloud.push_back({1, Vector3(random.uniform(-1, 2 + gap + 1), random.uniform(-2, 2),
                                random.uniform(-2, 2)), Matrix3::Zero()});
  CHECK(objects_in(cloud).size() == 2);
}

TEST_CASE("A few points far away are no object")
{
  const unsigned seed = GENERATE(1u, 2u, 3u);
  CAPTURE(seed);
  Random random(seed);
  Gaussians cloud;
  add_sphere(cloud, 2000, Vector3::Zero(), 1, random);
  add_sphere(cloud, 15, Vector3(5, 0, 0), 0.1, random);
  CHECK(objects_in(cloud) == Objects{range(0, cloud.size())});
  cloud.push_back({1000, Vector3(0, 9, 0), Matrix3::Zero()}); // many points at one place
  CHECK(objects_in(cloud) == Objects{range(0, cloud.size())});
  CHECK(objects_in({{1, Vector3::Zero(), Matrix3::Zero()}}) == Objects{{0}});
}

} // namespace scene_objects_test
