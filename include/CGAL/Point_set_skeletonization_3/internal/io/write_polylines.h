// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_IO_WRITE_POLYLINES_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_IO_WRITE_POLYLINES_H

#include <CGAL/Point_set_skeletonization_3/internal/io/Written_skeleton.h>

#include <cstddef>
#include <ostream>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// CGAL's polylines, a branch a line: `n x1 y1 z1 ... xn yn zn`.
inline void write_polylines(std::ostream& os, const Written_skeleton& skeleton)
{
  for(const Plain_branch& branch : skeleton.branches) {
    os << branch.vertices.size();
    for(std::size_t v : branch.vertices)
      os << ' ' << skeleton.graph.vertices[v].point;
    os << '\n';
  }
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_IO_WRITE_POLYLINES_H
