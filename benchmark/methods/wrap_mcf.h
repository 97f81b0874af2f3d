// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_WRAP_MCF_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_WRAP_MCF_H

#include "Method.h"

/// `mcf()` of the alpha wrap of the points, remeshed: on its large triangles the skeleton drifts
/// off the middle.
Method_result wrap_mcf(const Method_input& input);

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_WRAP_MCF_H
