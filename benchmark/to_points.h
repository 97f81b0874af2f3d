// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_TO_POINTS_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_TO_POINTS_H

#include "methods/Method.h"

#include "generator/Random.h"

#include <vector>

/// The generator's points as CGAL's.
inline std::vector<Point> to_points(const std::vector<shapes::Vector>& vectors)
{
  std::vector<Point> points;
  points.reserve(vectors.size());
  for(const shapes::Vector& v : vectors)
    points.emplace_back(v.x(), v.y(), v.z());
  return points;
}

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_TO_POINTS_H
