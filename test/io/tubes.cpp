// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The tube of a branch is closed, turns outwards and does not intersect itself, as CGAL checks.

#include "catch2.h"

#include <CGAL/Point_set_skeletonization_3/internal/branches/ordered_branches.h>
#include <CGAL/Point_set_skeletonization_3/internal/io/write_tubes.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/number_type_config.h>

#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace tubes_test {

namespace PMP = CGAL::Polygon_mesh_processing;
namespace internal = CGAL::Point_set_skeletonization_3::internal;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

namespace {

internal::Plain_skeleton path_of(const std::vector<internal::Plain_vertex>& vertices,
                                 bool is_closed = false)
{
  internal::Plain_skeleton skeleton;
  skeleton.vertices = vertices;
  for(std::size_t v = 1; v < vertices.size(); ++v)
    skeleton.edges.emplace_back(v - 1, v);
  if(is_closed)
    skeleton.edges.emplace_back(vertices.size() - 1, 0);
  return skeleton;
}

// Of a skeleton with one branch.
Mesh checked_tube(const internal::Plain_skeleton& skeleton)
{
  const auto branches = internal::ordered_branches(skeleton, {});
  REQUIRE(branches.size() == 1);
  internal::Tube_mesh tube;
  tube.add(skeleton, branches[0]);
  std::vector<Kernel::Point_3> points;
  for(const auto& p : tube.points)
    points.emplace_back(p[0], p[1], p[2]);
  REQUIRE(PMP::is_polygon_soup_a_polygon_mesh(tube.triangles));
  Mesh mesh;
  PMP::polygon_soup_to_polygon_mesh(points, tube.triangles, mesh);
  CHECK(CGAL::is_closed(mesh));
  CHECK(!PMP::does_self_intersect(mesh));
  CHECK(PMP::is_outward_oriented(mesh));
  return mesh;
}

} // namespace

TEST_CASE("the tube of a straight branch is a cylinder with round ends")
{
  const Mesh mesh = checked_tube(path_of({{{{0, 0, 0}}, 1}, {{{0, 0, 4}}, 1}, {{{0, 0, 10}}, 1}}));
  // Polygons of 16 corners and caps of four steps have a little less.
  CHECK(PMP::volume(mesh) == Approx(CGAL_PI * (10 + 4. / 3)).epsilon(0.05));
}

TEST_CASE("the tube of a ring is a torus, however the ring turns in space")
{
  for(double wave : {0., 0.4, 1.}) {
    std::vector<internal::Plain_vertex> ring;
    constexpr int n = 60;
    for(int i = 0; i < n; ++i) {
      const double a = 2 * CGAL_PI * i / n;
      ring.push_back({{{5 * std::cos(a), 5 * std::sin(a), wave * std::sin(3 * a)}}, 1});
    }
    const Mesh mesh = checked_tube(path_of(ring, true));
    CHECK(CGAL::num_vertices(mesh) + CGAL::num_faces(mesh) == CGAL::num_edges(mesh));
    CHECK(PMP::volume(mesh) > 0.9 * 2 * CGAL_PI * CGAL_PI * 5);
  }
}

TEST_CASE("sharp bends, thick vertices, and hardly anything")
{
  checked_tube(path_of({{{{0, 0, 0}}, 1}}));
  checked_tube(path_of({{{{0, 0, 0}}, 0}, {{{1, 0, 0}}, 0}}));
  checked_tube(path_of({{{{0, 0, 0}}, 0.5}, {{{3, 0, 0}}, 0.5}, {{{3, 3, 0}}, 0.5}}));
  checked_tube(path_of({{{{0, 0, 0}}, 2}, {{{1, 0, 0}}, 2}, {{{1, 1, 0}}, 2}}));
  checked_tube(path_of({{{{0, 0, 0}}, 1}, {{{0, 0, 0}}, 1}, {{{1, 1, 1}}, 1}}));
  checked_tube(path_of({{{{0, 0, 0}}, 1}, {{{1, 0, 0}}, 1}, {{{0, 1, 0}}, 1}}, true));
}

TEST_CASE("neighbouring parts of any tube do not intersect")
{
  const unsigned int seed = 11;
  CAPTURE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> turn(-0.6, 0.6), radius(0.1, 1.5);
  for(int round = 0; round < 30; ++round) {
    // A path that goes on to the right, so that only neighbours can meet.
    std::vector<internal::Plain_vertex> path;
    for(int i = 0; i < 25; ++i)
      path.push_back({{{double(i), 0.5 * turn(random), 0.5 * turn(random)}}, radius(random)});
    checked_tube(path_of(path));
  }
}

} // namespace tubes_test
