// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_EXAMPLES_SAMPLE_SURFACE_H
#define POINT_SET_SKELETONIZATION_3_EXAMPLES_SAMPLE_SURFACE_H

#include "read_points.h"

#include <CGAL/Kernel_traits.h>
#include <CGAL/Random.h>
#include <CGAL/point_generators_3.h>

#include <cstddef>
#include <vector>

/// The triangles of a mesh that have an area; a larger face is cut into a fan of them.
template <typename Point>
std::vector<typename CGAL::Kernel_traits<Point>::Kernel::Triangle_3>
triangles_of(const Points_and_faces<Point>& mesh)
{
  using Triangle = typename CGAL::Kernel_traits<Point>::Kernel::Triangle_3;
  std::vector<Triangle> triangles;
  for(const std::vector<std::size_t>& face : mesh.faces)
    for(std::size_t i = 2; i < face.size(); ++i) {
      const Triangle triangle(mesh.points[face[0]], mesh.points[face[i - 1]], mesh.points[face[i]]);
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
  const auto triangles = triangles_of(mesh);
  std::vector<Point> points;
  if(triangles.empty())
    return points;
  // The generator draws the triangles from CGAL's default source whatever source it is given: so
  // that one is seeded, and used for the points as well.
  CGAL::get_default_random() = CGAL::Random(seed);
  CGAL::Random_points_in_triangles_3<Point> generator(triangles, CGAL::get_default_random());
  points.reserve(size);
  for(; points.size() < size; ++generator)
    points.push_back(*generator);
  return points;
}

#endif // POINT_SET_SKELETONIZATION_3_EXAMPLES_SAMPLE_SURFACE_H
