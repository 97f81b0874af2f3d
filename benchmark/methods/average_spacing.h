// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_AVERAGE_SPACING_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_AVERAGE_SPACING_H

#include "Method.h"

#include <CGAL/compute_average_spacing.h>

#include <vector>

/// The mean distance of a point to its six nearest, in the unit of the points. \pre there are two
inline double average_spacing(const std::vector<Point>& points)
{
  constexpr unsigned int neighbours = 6; // as in CGAL's examples
  return CGAL::compute_average_spacing<CGAL::Sequential_tag>(points, neighbours);
}

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_AVERAGE_SPACING_H
