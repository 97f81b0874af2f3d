// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_SPANNING_TREE_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_SPANNING_TREE_H

#include "Method.h"

/// What anybody would try first on a scan, so that is what a method has to be better than: the
/// Euclidean minimum spanning tree of thinned points, without its short twigs. Reads the points.
///
/// A cell of a grid has the mean of its points; cells are 2 average spacings wide. Twigs shorter
/// than 4 cells are cut, the shortest first. The result is always one tree, on the surface where a
/// limb is thicker than a cell.
Method_result spanning_tree(const Method_input& input);

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_SPANNING_TREE_H
