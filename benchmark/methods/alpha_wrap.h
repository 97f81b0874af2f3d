// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_ALPHA_WRAP_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_ALPHA_WRAP_H

#include "Method.h"

#include <vector>

/// The closed surface around the points: Portaneri, Rouxel-Labbe, Hemmer, Cohen-Steiner, Alliez,
/// "Alpha Wrapping with an Offset", SIGGRAPH 2022. Balls of alpha do not get in between the points:
/// alpha is 3 spacings, which closes the gaps of random samples, the offset 0.3 spacings.
/// \return its components \pre there are points
std::vector<Mesh> alpha_wrap(const std::vector<Point>& points);

/// The same, with even triangles and about as many vertices as there are points.
std::vector<Mesh> fine_alpha_wrap(const std::vector<Point>& points);

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_ALPHA_WRAP_H
