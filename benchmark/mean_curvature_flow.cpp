// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial

#include "mean_curvature_flow.h"

#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/extract_mean_curvature_flow_skeleton.h>

Skeleton mean_curvature_flow_skeleton(const std::vector<Mesh>& components)
{
  using Flow_skeleton = CGAL::Mean_curvature_flow_skeletonization<Mesh>::Skeleton;
  Skeleton result;
  for(const Mesh& component : components) {
    Flow_skeleton skeleton;
    CGAL::extract_mean_curvature_flow_skeleton(component, skeleton);
    const auto first = num_vertices(result);
    for(const auto v : CGAL::make_range(vertices(skeleton)))
      result[add_vertex(result)].point = skeleton[v].point;
    for(const auto e : CGAL::make_range(edges(skeleton)))
      add_edge(first + source(e, skeleton), first + target(e, skeleton), result);
  }
  return result;
}

std::vector<Mesh> remesh(std::vector<Mesh> components, double edge_length)
{
  for(Mesh& component : components)
    CGAL::Polygon_mesh_processing::isotropic_remeshing(
        faces(component), edge_length, component,
        CGAL::parameters::number_of_iterations(3)); // as in CGAL's examples
  return components;
}
