// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_BESIDE_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_BESIDE_H

#include "methods/Method.h"

#include <vector>

/// A scene of a cloud and a neighbour, made as long as the cloud, a diagonal and a half apart along
/// the first axis: what becomes of the cloud must not depend on the neighbour.
struct Scene_beside
{
  std::vector<Point> points; ///< First those of the cloud.
  double border = 0;         ///< The first coordinate halfway between both.
};

/// \pre both clouds have points
Scene_beside beside(const std::vector<Point>& cloud, const std::vector<Point>& neighbor);

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_BESIDE_H
