// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_TEST_POINTS_SOURCE_H
#define POINT_SET_SKELETONIZATION_3_TEST_POINTS_SOURCE_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Point_source.h>

#include <algorithm>
#include <cstddef>
#include <vector>

/// Points as the package reads them. Refers to the vector.
inline CGAL::Point_set_skeletonization_3::internal::Point_source
source_of(const std::vector<CGAL::Point_set_skeletonization_3::internal::Vector3>& points)
{
  using CGAL::Point_set_skeletonization_3::internal::Point_source;
  Point_source result;
  result.size = points.size();
  result.read = [&points](std::size_t b, double* xyz) {
    const std::size_t begin = b * Point_source::block_size;
    const std::size_t end = std::min(points.size(), begin + Point_source::block_size);
    for(std::size_t i = begin; i < end; ++i)
      xyz = std::copy_n(points[i].data(), 3, xyz);
  };
  return result;
}

#endif // POINT_SET_SKELETONIZATION_3_TEST_POINTS_SOURCE_H
