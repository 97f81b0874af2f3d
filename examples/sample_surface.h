// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_EXAMPLES_SAMPLE_SURFACE_H
#define POINT_SET_SKELETONIZATION_3_EXAMPLES_SAMPLE_SURFACE_H

#include "read_points.h"

#include <CGAL/Kernel_traits.h>
#include <CGAL/Random.h>
#include <CGAL/number_utils.h>
#include <CGAL/point_generators_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

/// A power of two that is about the greatest coordinate of the points.
template <typename Point>
double magnitude_of(const std::vector<Point>& points)
{
  double greatest = 0;
  for(const Point& p : points)
    for(int axis = 0; axis < 3; ++axis)
      greatest = std::max(greatest, std::abs(CGAL::to_double(p[axis])));
  return greatest > 0 ? std::ldexp(1, std::ilogb(greatest)) : 1;
}

/// The triangles of a mesh that have an area, with coordinates divided by `unit`; a larger face is
/// cut into a fan of them.
template <typename Point>
std::vector<typename CGAL::Kernel_traits<Point>::Kernel::Triangle_3>
triangles_of(const Points_and_faces<Point>& mesh, double unit)
{
  using Triangle = typename CGAL::Kernel_traits<Point>::Kernel::Triangle_3;
  std::vector<Triangle> triangles;
  const auto corner = [&](std::size_t v) {
    const Point& p = mesh.points[v];
    return Point(p.x() / unit, p.y() / unit, p.z() / unit);
  };
  for(const std::vector<std::size_t>& face : mesh.faces)
    for(std::size_t i = 2; i < face.size(); ++i) {
      const Triangle triangle(corner(face[0]), corner(face[i - 1]), corner(face[i]));
      if(triangle.squared_area() > 0)
        triangles.push_back(triangle);
    }
  return triangles;
}

/// Draws `size` points uniformly from the surface of a mesh, which need not be closed or manifold.
/// The same `seed` gives the same points. Empty if the mesh has no surface.
template <typename Point>
std::vector<Point> sample_surface(const Points_and_faces<Point>& mesh, std::size_t size,
                                  unsigned int seed)
{
  // Areas of coordinates of any size fit into a number if they are measured in this unit; by a
  // power of two nothing is rounded.
  const double unit = magnitude_of(mesh.points);
  const auto triangles = triangles_of(mesh, unit);
  std::vector<Point> points;
  if(triangles.empty())
    return points;
  // The generator draws the triangles from CGAL's default source whatever source it is given: so
  // that one is seeded, and used for the points as well.
  CGAL::get_default_random() = CGAL::Random(seed);
  CGAL::Random_points_in_triangles_3<Point> generator(triangles, CGAL::get_default_random());
  points.reserve(size);
  for(; points.size() < size; ++generator)
    points.emplace_back(generator->x() * unit, generator->y() * unit, generator->z() * unit);
  return points;
}

#endif // POINT_SET_SKELETONIZATION_3_EXAMPLES_SAMPLE_SURFACE_H
