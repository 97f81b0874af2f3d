// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_L1_MEDIAL_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_L1_MEDIAL_H

#include "Method.h"

/// This package, as it comes. Reads the points.
Method_result l1_medial(const Method_input& input);

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_L1_MEDIAL_H
