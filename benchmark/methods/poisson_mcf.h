// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_POISSON_MCF_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_POISSON_MCF_H

#include "Method.h"

/// `mcf()` of the Poisson surface of the points: Kazhdan, Bolitho, Hoppe, "Poisson Surface
/// Reconstruction", SGP 2006, as CGAL has it,
/// remeshed. Reads the points and the normals.
/// \throw std::runtime_error if there is no such surface, or if it is not closed
Method_result poisson_mcf(const Method_input& input);

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_POISSON_MCF_H
