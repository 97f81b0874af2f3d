// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "remesh.h"

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>

#include <cmath>

namespace PMP = CGAL::Polygon_mesh_processing;

std::vector<Mesh> remesh(std::vector<Mesh> components, double edge_length)
{
  for(Mesh& component : components) {
    PMP::isotropic_remeshing(faces(component), edge_length, component,
                             CGAL::parameters::number_of_iterations(3)); // as in CGAL's examples
    component.collect_garbage();
  }
  return components;
}

std::vector<Mesh> remesh_to(const std::vector<Mesh>& components, std::size_t number_of_vertices)
{
  double area = 0;
  for(const Mesh& component : components)
    area += PMP::area(component);
  // An equilateral triangle has the area sqrt(3) / 4 edges^2; there are two to a vertex.
  return remesh(components,
                std::sqrt(2 * area / (std::sqrt(3.) * static_cast<double>(number_of_vertices))));
}
