// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What stands beside an object does not change it.

#include "catch2.h"
#include "generator/Random.h"
#include "generator/clouds.h"
#include "generator/families.h"
#include "generator/scanned_families.h"
#include "generator/scanner.h"
#include "graph_counts.h"
#include "part_before.h"
#include "shapes.h"
#include "skeleton_checks.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/compute_medial_samples.h>
#include <CGAL/extract_l1_medial_skeleton.h>
#include <CGAL/fit_gaussian_mixture.h>
#include <CGAL/link_medial_samples.h>

#include <Eigen/Geometry>

#include <boost/range/iterator_range.hpp>

#include <cstddef>
#include <vector>

namespace scenes_test {

using Kernel = CGAL::Simple_cartesian<double>;
using Skeleton = CGAL::Curve_skeleton_3<Kernel>;
using shapes::Vector;

namespace {

/// Points from 0 on, with a diagonal of 1.
std::vector<Vector> of_unit_size(std::vector<Vector> cloud)
{
  Eigen::AlignedBox3d box;
  for(const Vector& p : cloud)
    box.extend(p);
  for(Vector& p : cloud)
    p = (p - (box.min)()) / box.diagonal().norm();
  return cloud;
}

std::vector<Vector> scan_of(const char* family, std::size_t size, unsigned int seed)
{
  constexpr int places = 3;
  return of_unit_size(
    shapes::scan(shapes::scanned_shape(family, seed), {size, places, 0, 0, 0, 1}, seed).points);
}

std::vector<Kernel::Point_3> to_points(const std::vector<Vector>& cloud)
{
  std::vector<Kernel::Point_3> points;
  for(const Vector& p : cloud)
    points.emplace_back(p.x(), p.y(), p.z());
  return points;
}

Skeleton skeleton_of(const std::vector<Vector>& cloud)
{
  Skeleton skeleton;
  REQUIRE(CGAL::extract_l1_medial_skeleton(to_points(cloud), skeleton));
  check_valid(skeleton, cloud.size());
  return skeleton;
}

std::vector<Vector> beside(std::vector<Vector> cloud, const std::vector<Vector>& other,
                           double distance)
{
  for(const Vector& p : other)
    cloud.emplace_back(p + distance * Vector::UnitX());
  return cloud;
}

} // namespace

TEST_CASE("What stands beside an object does not change what it is made of")
{
  const unsigned int seed = GENERATE(2251u, 2252u);
  CAPTURE(seed);
  const auto solid = [seed](const char* family, shapes::Variant variant) {
    constexpr std::size_t size = 10000;
    return of_unit_size(shapes::sample(shapes::known_shape(family, seed), variant, size, seed));
  };
  const std::vector<std::vector<Vector>> objects = {
    scan_of("wire_frame", 3000, seed),    // lines, whose loops are true
    scan_of("crown_in_leaf", 10000, seed), // lines and scattered leaves, in which nothing is a loop
    scan_of("leafy_plant", 10000, seed),
    solid("frame", shapes::Variant::clean),
    solid("frame", shapes::Variant::noise_one_percent)};
  constexpr double distance = 2.2; // of the corners of two objects as long as 1
  for(std::size_t k = 0; k < objects.size(); ++k) {
    const Graph_counts alone = count_graph(skeleton_of(objects[k]));
    CHECK(alone.components == 1);
    for(std::size_t other = 0; other < objects.size(); ++other) {
      CAPTURE(k, other);
      const Skeleton scene = skeleton_of(beside(objects[k], objects[other], distance));
      CHECK(count_graph(scene).components == 2);
      const Graph_counts counts = count_graph(metrics::part_before(distance / 2, scene));
      CHECK(counts.components == alone.components);
      CHECK(counts.cycles == alone.cycles);
    }
  }
}

TEST_CASE("A few points beside a small object are outliers of the scene")
{
  // Parts of their own while they were compared with that object only.
  for(const unsigned int seed : {1u, 2u, 3u, 4u, 5u}) {
    CAPTURE(seed);
    shapes::Random random(seed);
    std::vector<Vector> cloud = shapes::sample(shapes::cylinder(), 10000, seed);
    const Vector twig(3, 0, 0);
    const auto add = [&](double x, double z) {
      const Vector noise = 0.002 * random.normal_vector();
      cloud.push_back(twig + Vector(x, 0, z) + noise);
    };
    constexpr std::size_t few = 4;
    for(int i = 0; i < 130; ++i)
      add(0, random.uniform(0, 0.5));
    for(std::size_t i = 0; i < few; ++i)
      add(0.07, i % 2 == 0 ? 0.25 : 0.26);
    const Skeleton skeleton = skeleton_of(cloud);
    CHECK(count_graph(skeleton).components == 2);
    std::size_t explained = 0;
    for(const auto v : boost::make_iterator_range(vertices(skeleton)))
      explained += skeleton[v].indices.size();
    CHECK(explained <= cloud.size() - few);
  }
}

TEST_CASE("The stages alone link each object of a scene as all at once do")
{
  const unsigned int seed = GENERATE(1u, 2u);
  CAPTURE(seed);
  using shapes::Variant;
  const auto ring = [seed](Variant variant) {
    return of_unit_size(shapes::sample(shapes::known_shape("ring", seed), variant, 5000, seed));
  };
  const std::vector<Vector> cloud = beside(ring(Variant::clean), ring(Variant::noise_one_percent),
                                           3);
  const auto mixture = CGAL::fit_gaussian_mixture(to_points(cloud));
  CGAL::Medial_samples_3<Kernel> samples;
  REQUIRE(CGAL::compute_medial_samples(mixture, samples));
  REQUIRE(samples.noise.size() == 2);
  CHECK(samples.noise[0] == 0);
  CHECK(samples.noise[1] > 0);
  for(const auto& sample : samples.samples)
    REQUIRE(sample.object == (sample.point.x() < 2 ? 0 : 1));
  Skeleton skeleton;
  REQUIRE(CGAL::link_medial_samples(samples, skeleton));
  const Graph_counts counts = count_graph(skeleton), at_once = count_graph(skeleton_of(cloud));
  CHECK(counts.components == 2);
  CHECK(counts.cycles == 2);
  CHECK(counts.cycles == at_once.cycles);
  CHECK(counts.ends == at_once.ends);
  Skeleton joined;
  REQUIRE(CGAL::link_medial_samples(samples, joined, CGAL::parameters::single_component(true)));
  CHECK(count_graph(joined).components == 1);
}

} // namespace scenes_test
