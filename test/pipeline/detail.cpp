// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Fine details that the points resolve are in the skeleton, however many there are.

#include "catch2.h"
#include "generator/branching_tree.h"
#include "generator/clouds.h"
#include "Segment_tree.h"
#include "graph_counts.h"
#include "shapes.h"
#include "skeleton_edges.h"

#include <CGAL/L1_medial_skeletonization_3.h>
#include <CGAL/extract_l1_medial_skeleton.h>

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace detail_test {

namespace {

using Kernel = CGAL::Simple_cartesian<double>;

Graph_counts counts_of(const shapes::Known_shape& shape, std::size_t size, unsigned int seed)
{
  shapes::Random random(seed);
  const auto points = shapes::to_points<Kernel>(shapes::sample_clean(shape, size, random));
  CGAL::Curve_skeleton_3<Kernel> skeleton;
  REQUIRE(CGAL::extract_l1_medial_skeleton(points, skeleton));
  return count_graph(skeleton);
}

// Number of limbs at least as thick as `length`, and of those whose middle is not near the
// skeleton.
std::pair<std::size_t, std::size_t> limbs_and_lost(const shapes::Known_shape& shape, double length,
                                                   const CGAL::Curve_skeleton_3<Kernel>& skeleton)
{
  const metrics::Segment_tree tree(metrics::edge_segments(skeleton));
  std::size_t limbs = 0, lost = 0;
  for(const shapes::Axis_segment& limb : shape.axis) {
    const double radius = std::min(limb.radius_a, limb.radius_b);
    if(2 * radius < 0.999 * length)
      continue;
    const shapes::Vector middle = (limb.a + limb.b) / 2;
    ++limbs;
    lost += tree.nearest({middle.x(), middle.y(), middle.z()}).distance > radius;
  }
  return {limbs, lost};
}

} // namespace

// The limbs at the tips have a radius of 1.3 and 2.1 distances between points.
TEST_CASE("A tree has all its tips, and nothing else")
{
  struct Tree
  {
    std::size_t points;
    int levels;
  };
  constexpr Tree trees[] = {{18000, 5}, {100000, 6}};
  constexpr unsigned int seeds[] = {1, 2, 3};
  for(const Tree& tree : trees)
    for(const unsigned int seed : seeds) {
      CAPTURE(tree.points, tree.levels, seed);
      const shapes::Known_shape shape = shapes::branching_tree(tree.levels, seed);
      const Graph_counts counts = counts_of(shape, tree.points, seed);
      CHECK(counts.components == 1);
      CHECK(counts.cycles == 0);
      CHECK(counts.ends == shape.ends);
    }
}

// Where there are more points than the thinnest limb takes.
TEST_CASE("Limbs as thick as the smallest feature are found, with fewer patches")
{
  constexpr std::size_t size = 100000;
  for(const unsigned int seed : {4u, 5u}) {
    const shapes::Known_shape shape = shapes::branching_tree(5, seed);
    shapes::Random random(seed);
    const auto points = shapes::to_points<Kernel>(shapes::sample_clean(shape, size, random));
    const double twig = 2 * shapes::least_radius(shape);
    std::size_t patches_before = size;
    for(const double thickness : {0.01, 1.0, 2.0}) { // of a twig
      CAPTURE(seed, thickness);
      const double length = thickness * twig;
      CGAL::L1_medial_skeletonization_3<Kernel> steps(points,
                                                       CGAL::parameters::smallest_feature(length));
      REQUIRE(steps.run());
      CGAL::Curve_skeleton_3<Kernel> skeleton;
      steps.extract_skeleton(skeleton);
      const Graph_counts counts = count_graph(skeleton);
      CHECK(counts.components == 1);
      if(thickness <= 1) {
        CHECK(counts.cycles == 0);
        CHECK(counts.ends == shape.ends);
      }
      const auto [limbs, lost] = limbs_and_lost(shape, length, skeleton);
      CHECK(limbs > 0);
      CHECK(lost == 0);
      CHECK(10 * steps.number_of_samples() < 9 * patches_before);
      patches_before = steps.number_of_samples();
    }
  }
}

} // namespace detail_test
