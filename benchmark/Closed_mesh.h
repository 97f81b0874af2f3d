// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_CLOSED_MESH_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_CLOSED_MESH_H

#include "methods/components_of.h"
#include "read_points.h"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/boost/graph/helpers.h>

#include <cstddef>

/// The triangle mesh of a file's faces. If they make no closed mesh as they are, equal points
/// become one: then they may.
inline Mesh to_triangle_mesh(Points_and_faces<Point> soup)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  const auto to_mesh = [&soup] {
    Mesh mesh;
    PMP::polygon_soup_to_polygon_mesh(soup.points, soup.faces, mesh);
    PMP::triangulate_faces(mesh);
    return mesh;
  };
  if(PMP::is_polygon_soup_a_polygon_mesh(soup.faces)) {
    Mesh mesh = to_mesh();
    if(CGAL::is_closed(mesh))
      return mesh;
  }
  PMP::repair_polygon_soup(soup.points, soup.faces);
  PMP::orient_polygon_soup(soup.points, soup.faces);
  return to_mesh();
}

/// Number of handles of a closed surface with one component, from its Euler characteristic.
inline std::size_t genus_of(const Mesh& component)
{
  const std::size_t vertices_and_faces =
      component.number_of_vertices() + component.number_of_faces();
  return (component.number_of_edges() + 2 - vertices_and_faces) / 2;
}

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_CLOSED_MESH_H
