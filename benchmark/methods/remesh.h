// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_REMESH_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_REMESH_H

#include "Method.h"

#include <cstddef>
#include <vector>

/// The same surfaces with even triangles and edges of about `edge_length`, in the unit of the mesh.
std::vector<Mesh> remesh(std::vector<Mesh> components, double edge_length);

/// The same surfaces with even triangles and together about as many vertices as wanted.
std::vector<Mesh> remesh_to(const std::vector<Mesh>& components, std::size_t number_of_vertices);

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_REMESH_H
