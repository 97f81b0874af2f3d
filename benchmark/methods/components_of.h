// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_COMPONENTS_OF_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_COMPONENTS_OF_H

#include "Method.h"

#include <CGAL/Polygon_mesh_processing/connected_components.h>

#include <vector>

/// The connected components of a mesh.
inline std::vector<Mesh> components_of(const Mesh& mesh)
{
  std::vector<Mesh> components;
  CGAL::Polygon_mesh_processing::split_connected_components(mesh, components);
  return components;
}

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_COMPONENTS_OF_H
