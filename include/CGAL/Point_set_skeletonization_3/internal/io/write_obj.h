// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_IO_WRITE_OBJ_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_IO_WRITE_OBJ_H

#include <CGAL/Point_set_skeletonization_3/internal/io/Written_skeleton.h>

#include <ostream>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Wavefront OBJ: `v` lines, and an `l` line for each edge.
inline void write_obj(std::ostream& os, const Written_skeleton& skeleton)
{
  for(const Plain_vertex& v : skeleton.graph.vertices)
    os << "v " << v.point << '\n';
  for(const auto& [v, w] : skeleton.graph.edges)
    os << "l " << v + 1 << ' ' << w + 1 << '\n'; // OBJ counts from one
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_IO_WRITE_OBJ_H
