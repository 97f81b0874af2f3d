// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Fine details that the points resolve are in the skeleton, however many there are.

#include "catch2.h"
#include "generator/branching_tree.h"
#include "generator/clouds.h"
#include "graph_counts.h"
#include "shapes.h"

#include <CGAL/extract_l1_medial_skeleton.h>

#include <CGAL/Simple_cartesian.h>

#include <cstddef>

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
