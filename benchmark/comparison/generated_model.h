// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_COMPARISON_GENERATED_MODEL_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_COMPARISON_GENERATED_MODEL_H

#include "../Model.h"

#include <cstddef>
#include <string>
#include <vector>

/// The families of test/generator, and the filigree.
std::vector<std::string> generated_names();

/// Whether an input is a generated shape, FAMILY:SEED, and not a file.
bool is_generated(const std::string& input);

/// A generated shape: points drawn from it, a closed mesh of it, and what is true about it. The
/// mesh is an alpha wrap of many points whose vertices are moved onto the shape. \throw
/// std::runtime_error if the seed is no number or the mesh has not the topology of the shape
Model generated_model(const std::string& input, std::size_t number_of_points, unsigned int seed);

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_COMPARISON_GENERATED_MODEL_H
