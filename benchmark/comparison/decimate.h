// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_COMPARISON_DECIMATE_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_COMPARISON_DECIMATE_H

#include "../methods/Method.h"

#include <cstddef>
#include <vector>

/// The meshes with about as many vertices together as wanted: edges collapsed in the order of
/// Garland and Heckbert's quadrics, as in the paper's Fig. 5.
std::vector<Mesh> decimate(std::vector<Mesh> components, std::size_t number_of_vertices);

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_COMPARISON_DECIMATE_H
