// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_COMPARISON_ORIENTED_NORMALS_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_COMPARISON_ORIENTED_NORMALS_H

#include "../methods/Method.h"

#include <vector>

/// The points, in another order, with normals from planes through the nearest 18, as in CGAL's
/// examples, which are oriented along a minimum spanning tree (Hoppe et al. 1992). Where that does
/// not reach, it starts again.
Method_input with_normals(const std::vector<Point>& points);

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_COMPARISON_ORIENTED_NORMALS_H
