// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_MCF_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_MCF_H

#include "Method.h"

/// The mean curvature flow skeleton of CGAL: Tagliasacchi, Alhashim, Olson, Zhang, "Mean Curvature
/// Skeletons", SGP 2012. Reads the components.
/// \throw std::runtime_error if one is open
Method_result mcf(const Method_input& input);

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_MCF_H
