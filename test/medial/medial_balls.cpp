// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Medial balls of patches, and the samples at their centres.

#include "ellipsoid.h"
#include "surface_of.h"
#include "two_spheres.h"

#include "catch2.h"
#include "generator/Random.h"
#include "threads.h"

#include <CGAL/Point_set_skeletonization_3/internal/medial/medial_balls.h>
#include <CGAL/Point_set_skeletonization_3/internal/medial/medial_samples.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Surface_options.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/orient_patches.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

using namespace CGAL::Point_set_skeletonization_3::internal;
using surfaces::ellipsoid;
using surfaces::patches_of_sphere;
using surfaces::tree_of;
using surfaces::tube_radius;
using surfaces::two_spheres;

namespace {

constexpr unsigned int seeds[] = {1, 2, 3};
const Surface_options options;

// Radius of the ball that touches `a` from inside and the disc of `b` at the place nearest to where
// a ball touches its plane.
double ball_radius(const Patch& a, const Patch& b)
{
  Vector3 d = b.mean - a.mean;
  const double in_plane = b.normal.dot(d) / (1 - a.normal.dot(b.normal));
  if(in_plane > 0) {
    const Vector3 away = in_plane * (b.normal - a.normal) - d;
    d += std::min(1.0, std::sqrt(b.area / CGAL_PI) / away.norm()) * away;
  }
  return d.squaredNorm() / (-2 * a.normal.dot(d));
}

Surface torus() { return surfaces::surface_of(surfaces::torus.patches()); }

} // namespace

TEST_CASE("The facing ball is the third smallest of those with all patches that face one and count")
{
  const unsigned int seed = seeds[0];
  CAPTURE(seed);
  const Patches patches = ellipsoid(1000, seed);
  std::vector<double> confidence(patches.size());
  for(std::size_t i = 0; i < confidence.size(); ++i)
    confidence[i] = i % 10 == 0 ? options.trusted_orientation / 2 : 1;
  const std::vector<double> found =
    Facing_balls(patches, confidence, tree_of(patches), options).radii(Concurrency::sequential);
  for(std::size_t i = 0; i < patches.size(); ++i) {
    if(confidence[i] < options.trusted_orientation) {
      REQUIRE(found[i] == 0);
      continue;
    }
    std::vector<double> radii;
    for(std::size_t j = 0; j < patches.size(); ++j)
      if(confidence[j] >= options.trusted_orientation &&
         patches[j].normal.dot(patches[i].normal) <= options.opposite_normals &&
         patches[i].normal.dot(patches[j].mean - patches[i].mean) < 0)
        radii.push_back(ball_radius(patches[i], patches[j]));
    std::sort(radii.begin(), radii.end());
    REQUIRE(radii.size() > 2);
    REQUIRE(found[i] == Approx(radii[2]).epsilon(1e-4));
  }
  const Patches two = {patches[0], patches[1]};
  CHECK(Facing_balls(two, {1, 1}, tree_of(two), options).radii(Concurrency::sequential)[0] == 0);
}

TEST_CASE("Across a wall thinner than its patches are wide, a ball has the radius of the wall")
{
  const double thickness = GENERATE(0.1, 0.5);
  for(unsigned int seed : seeds) {
    CAPTURE(seed, thickness);
    shapes::Random random(seed);
    const Vector3 normal = random.direction(), across = normal.unitOrthogonal();
    const auto patch = [&](const Vector3& mean, const Vector3& outwards) {
      Patch result;
      result.mean = mean;
      result.normal = outwards;
      result.area = CGAL_PI; // the disc has radius 1
      return result;
    };
    Patches patches = {patch(Vector3::Zero(), normal)};
    for(double aside : {-0.9, 0.6, 0.8}) // no mean is opposite
      patches.push_back(patch(aside * across - thickness * normal, -normal));
    const std::vector<double> radii = Facing_balls(patches, {1, 1, 1, 1}, tree_of(patches), options)
                                        .radii(Concurrency::sequential);
    CHECK(radii[0] == Approx(thickness / 2).epsilon(1e-4));
  }
}

TEST_CASE("Thickness changes no faster than a share of the way")
{
  constexpr double slope = 0.5;
  const Patches patches = two_spheres();
  for(unsigned int seed : seeds) {
    CAPTURE(seed);
    shapes::Random random(seed);
    std::vector<double> before(patches.size(), 0); // nothing is known of the second sphere
    for(std::size_t i = 0; i < patches_of_sphere; ++i)
      if(random.uniform() < 0.7)
        before[i] = random.uniform(0.1, 0.5);
    std::vector<double> after = before;
    limit_slope(after, patches, slope);
    for(std::size_t i = 0; i < patches.size(); ++i) {
      if(i >= patches_of_sphere) {
        REQUIRE(after[i] == 0);
        continue;
      }
      double bound = 1e9;
      for(std::size_t j : patches[i].neighbors)
        bound = std::min(bound, after[j] + slope * (patches[i].mean - patches[j].mean).norm());
      const double expected = before[i] > 0 ? std::min(before[i], bound) : bound;
      REQUIRE(after[i] == Approx(expected).epsilon(1e-12));
    }
  }
}

TEST_CASE("A median has as many values below it as above")
{
  for(unsigned int seed : seeds) {
    CAPTURE(seed);
    shapes::Random random(seed);
    for(std::size_t size = 1; size < 12; ++size) {
      std::vector<double> values(size);
      for(double& value : values)
        value = random.integer(0, 5); // some are equal
      std::vector<double> sorted = values;
      std::sort(sorted.begin(), sorted.end());
      REQUIRE(median_of_few(values) == sorted[size / 2]);
    }
  }
}

TEST_CASE("A median filter drops a stray value and asks no one who knows none")
{
  const Patches patches = surfaces::torus.patches();
  std::vector<double> values(patches.size(), 1);
  const std::size_t stray = surfaces::torus.index(5, 5), unknown = surfaces::torus.index(30, 5);
  values[stray] = 100;
  values[unknown] = 0;
  const std::vector<double> filtered = median_filtered(values, patches, Concurrency::sequential);
  CHECK(std::count(filtered.begin(), filtered.end(), 1) ==
        static_cast<std::ptrdiff_t>(filtered.size()));
}

TEST_CASE("The samples of a torus lie on its axis, and know the radius of the tube")
{
  const Surface surface = torus();
  for_threads([&](Concurrency concurrency) {
    const Samples samples = medial_samples(surface, Medial_options(), concurrency);
    REQUIRE(samples.size() == surface.patches.size());
    const Samples expected = surfaces::samples_of(surface.patches);
    for(std::size_t i = 0; i < samples.size(); ++i) {
      REQUIRE((samples[i].position - expected[i].position).norm() < 0.15 * tube_radius);
      REQUIRE(samples[i].radius == Approx(tube_radius).epsilon(0.15));
    }
  });
}

TEST_CASE("Where the orientation is in doubt a sample stays on its patch")
{
  Surface surface = torus();
  const std::size_t doubtful = surfaces::torus.index(7, 3);
  surface.confidence[doubtful] = 0;
  const Samples samples = medial_samples(surface, Medial_options(), Concurrency::sequential);
  CHECK(samples[doubtful].position == surface.patches[doubtful].mean);
}
