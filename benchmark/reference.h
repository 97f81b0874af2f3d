// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_REFERENCE_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_REFERENCE_H

#include "methods/Method.h"

#include "generator/Known_shape.h"

#include <string>

/// Skeletons that are known, to compare with.

/// The axis of a shape, with the largest radius of the pieces that meet at each vertex.
Skeleton reference_of(const shapes::Known_shape& shape);

/// From an OBJ file with vertices and polylines (`v` and `l`); without radii. \throw std::runtime_error
Skeleton read_reference(const std::string& file);

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_REFERENCE_H
