// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_MEAN_CURVATURE_FLOW_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_MEAN_CURVATURE_FLOW_H

#include "Closed_mesh.h"
#include "methods.h"

#include <vector>

/// CGAL's mean curvature flow skeleton of closed meshes of one component each, in one graph;
/// without radii.
Skeleton mean_curvature_flow_skeleton(const std::vector<Mesh>& components);

/// The same surfaces with edges of about `edge_length` and even triangles.
std::vector<Mesh> remesh(std::vector<Mesh> components, double edge_length);

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_MEAN_CURVATURE_FLOW_H
