// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_MESH_CONTRACTION_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_MESH_CONTRACTION_H

#include "Method.h"
#include "laplacian_contraction.h"

#include <string>
#include <vector>

namespace methods {

/// The positions of the vertices, by index.
Positions positions_of(const Mesh& mesh);

/// The triangles at every vertex, by index.
std::vector<Fan> fans_of(const Mesh& mesh);

/// Where the vertices of a closed mesh are contracted to, as Au et al. 2008 do it: with their
/// s_L = 2, until the volume is less than a millionth of what it was.
/// \throw std::runtime_error if the first step fails
Positions contract_mesh(const Mesh& mesh);

/// Adds what becomes of a contracted component to a skeleton.
using Add_component = void (*)(Skeleton& skeleton, const Mesh& mesh, const Positions& contracted);

/// Contracts the components of the input, then adds all. \param stage the name of the latter
Method_result contract_and_add(const Method_input& input, const std::string& stage,
                               Add_component add);

} // namespace methods

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_MESH_CONTRACTION_H
