// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_SCANNED_MESH_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_SCANNED_MESH_H

#include "methods/Method.h"

#include "generator/Known_shape.h"

#include <string>

/// A shape to be scanned, and the skeleton that is to be found.
struct Scene
{
  shapes::Known_shape shape;
  Skeleton reference;
};

/// The surface of a closed mesh in a random orientation. Its true counts are those of the mesh;
/// where its skeleton runs is not known: the reference is what this package finds in 20 000 points
/// of all of the surface.
/// \throw std::runtime_error
Scene scanned_mesh(const std::string& file, unsigned int seed);

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_SCANNED_MESH_H
