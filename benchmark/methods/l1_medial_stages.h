// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_L1_MEDIAL_STAGES_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_L1_MEDIAL_STAGES_H

#include "Method.h"

/// This package on the points, its steps as stages.
Method_result l1_medial_stages(const Method_input& input, bool as_published);

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_L1_MEDIAL_STAGES_H
