// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_L1_MEDIAL_PUBLISHED_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_L1_MEDIAL_PUBLISHED_H

#include "Method.h"

/// This package's `Published_l1_medial_skeletonization_3`: Lengauer, Houska, Preiner, "Efficient
/// Point Cloud Skeletonization with Locally Adaptive L1-Medial Projection". Reads the points.
Method_result l1_medial_published(const Method_input& input);

/// The same with the tuned set of its parameters.
Method_result l1_medial_published_tuned(const Method_input& input);

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_L1_MEDIAL_PUBLISHED_H
