// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Points drawn from faces of any shape.

#include "catch2.h"

#include "sample_surface.h"

#include <CGAL/Simple_cartesian.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace sample_surface_test {

using Point = CGAL::Simple_cartesian<double>::Point_3;

TEST_CASE("Points of a concave face are on it, wherever it begins")
{
  // A square with a slot that is open above, in the plane x = z.
  const std::vector<std::array<double, 2>> outline = {{0, 0}, {3, 0}, {3, 3}, {2, 3},
                                                      {2, 1}, {1, 1}, {1, 3}, {0, 3}};
  const std::size_t first = GENERATE(range(0, 8));
  constexpr unsigned int seed = 5;
  CAPTURE(first, seed);
  Points_and_faces<Point> mesh;
  mesh.faces.emplace_back();
  for(std::size_t k = 0; k < outline.size(); ++k) {
    const auto& [u, v] = outline[(first + k) % outline.size()];
    mesh.points.emplace_back(u, v, u);
    mesh.faces.front().push_back(k);
  }
  std::size_t below = 0;
  constexpr std::size_t size = 7000;
  for(const Point& p : sample_surface(mesh, size, seed)) {
    CHECK(std::abs(p.x() - p.z()) < 1e-12);
    CHECK((p.y() <= 1 + 1e-12 || p.x() <= 1 + 1e-12 || p.x() >= 2 - 1e-12));
    below += p.y() < 1 ? 1 : 0;
  }
  // Three of seven squares, give or take almost five standard deviations.
  CHECK(std::abs(static_cast<double>(below) - 3000) < 200);
}

TEST_CASE("A face of fewer than three corners, and one without area, have no points")
{
  Points_and_faces<Point> mesh;
  mesh.points = {Point(0, 0, 0), Point(1, 0, 0), Point(2, 0, 0), Point(3, 0, 0)};
  mesh.faces = {{}, {0}, {0, 1}, {0, 1, 2}, {0, 2, 1, 3}, {1, 1, 1, 1}};
  CHECK(sample_surface(mesh, 10, 1).empty());
  mesh.points.emplace_back(0, 1, 0);
  mesh.faces.push_back({0, 3, 4});
  CHECK(sample_surface(mesh, 10, 1).size() == 10);
}

TEST_CASE("Faces that cross themselves or visit a corner twice are sampled within their box")
{
  const unsigned int seed = GENERATE(range(1, 200));
  CAPTURE(seed);
  std::mt19937 random(seed);
  Points_and_faces<Point> mesh;
  const double jitter = seed % 3 == 0 ? 1e-3 : 0;
  std::uniform_real_distribution<double> offset(0, jitter);
  for(int i = 0; i < 27; ++i)
    mesh.points.emplace_back(i % 3 + offset(random), i / 3 % 3 + offset(random),
                             seed % 2 == 0 ? 0 : i / 9);
  for(int f = 0; f < 20; ++f) {
    mesh.faces.emplace_back();
    for(std::size_t k = 3 + random() % 7; k > 0; --k)
      mesh.faces.back().push_back(random() % mesh.points.size());
  }
  const std::vector<Point> points = sample_surface(mesh, 50, seed);
  CHECK(points.size() == 50);
  for(const Point& p : points)
    for(int axis = 0; axis < 3; ++axis)
      CHECK((p[axis] > -1e-9 && p[axis] < 2 + jitter + 1e-9));
}

} // namespace sample_surface_test
