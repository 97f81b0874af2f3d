// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_DEFECT_OF_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_DEFECT_OF_H

#include "Method.h"

#include <string>

/// Why a skeleton is none, in a few words: nothing in it, a number that is not finite, a negative
/// radius, an edge from a vertex to itself, or two between the same vertices. Empty if it is one.
std::string defect_of(const Skeleton& skeleton);

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_DEFECT_OF_H
