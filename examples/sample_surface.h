// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_EXAMPLES_SAMPLE_SURFACE_H
#define POINT_SET_SKELETONIZATION_3_EXAMPLES_SAMPLE_SURFACE_H

#include "read_points.h"

#include <CGAL/Kernel_traits.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Projection_traits_3.h>
#include <CGAL/Random.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/number_utils.h>
#include <CGAL/point_generators_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
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

/// The triangles that a face is cut into: a fan of them, unless one would turn back, as where the
/// face is concave: then those of CGAL, which wants faces that do not cross themselves.
template <typename Point>
std::vector<typename CGAL::Kernel_traits<Point>::Kernel::Triangle_3>
triangles_of(const std::vector<Point>& corners)
{
  using Traits = typename CGAL::Kernel_traits<Point>::Kernel;
  std::vector<typename Traits::Triangle_3> fan, result;
  std::vector<typename Traits::Vector_3> normals;
  for(std::size_t i = 2; i < corners.size(); ++i) {
    fan.emplace_back(corners[0], corners[i - 1], corners[i]);
    normals.push_back(CGAL::cross_product(corners[i - 1] - corners[0], corners[i] - corners[0]));
  }
  const typename Traits::Vector_3 sum = std::accumulate(
    normals.begin(), normals.end(), typename Traits::Vector_3(CGAL::NULL_VECTOR));
  if(std::all_of(normals.begin(), normals.end(), [&](const auto& n) { return n * sum >= 0; }) ||
     !CGAL::is_simple_2(corners.begin(), corners.end(), CGAL::Projection_traits_3<Traits>(sum)))
    return fan;
  CGAL::Surface_mesh<Point> face;
  std::vector<CGAL::SM_Vertex_index> vertices;
  for(const Point& p : corners)
    vertices.push_back(face.add_vertex(p));
  face.add_face(vertices);
  if(!CGAL::Polygon_mesh_processing::triangulate_faces(face))
    return fan;
  for(const auto triangle : face.faces()) {
    std::vector<Point> points;
    for(const auto v : face.vertices_around_face(face.halfedge(triangle)))
      points.push_back(face.point(v));
    result.emplace_back(points[0], points[1], points[2]);
  }
  return result;
}

/// The triangles of a mesh that have an area, with coordinates divided by `unit`.
template <typename Point>
std::vector<typename CGAL::Kernel_traits<Point>::Kernel::Triangle_3>
triangles_of(const Points_and_faces<Point>& mesh, double unit)
{
  using Triangle = typename CGAL::Kernel_traits<Point>::Kernel::Triangle_3;
  std::vector<Triangle> result;
  for(const std::vector<std::size_t>& face : mesh.faces) {
    std::vector<Point> corners;
    for(std::size_t v : face) {
      const Point& p = mesh.points[v];
      corners.emplace_back(p.x() / unit, p.y() / unit, p.z() / unit);
    }
    for(const Triangle& triangle : triangles_of(corners))
      if(triangle.squared_area() > 0)
        result.push_back(triangle);
  }
  return result;
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
