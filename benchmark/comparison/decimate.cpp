// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "decimate.h"

#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_plane_policies.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

std::vector<Mesh> decimate(std::vector<Mesh> components, std::size_t number_of_vertices)
{
  namespace SMS = CGAL::Surface_mesh_simplification;
  double vertices = 0;
  for(const Mesh& component : components)
    vertices += static_cast<double>(component.number_of_vertices());
  const double share = static_cast<double>(number_of_vertices) / vertices;
  const auto is_done = [share](const auto&, const auto&, auto edges_first, auto edges_now) {
    return static_cast<double>(edges_now) <= share * static_cast<double>(edges_first);
  };
  for(Mesh& component : components) {
    const SMS::GarlandHeckbert_plane_policies<Mesh, Kernel> quadrics(component);
    SMS::edge_collapse(
        component, is_done,
        CGAL::parameters::get_cost(quadrics.get_cost()).get_placement(quadrics.get_placement()));
    component.collect_garbage();
  }
  return components;
}
