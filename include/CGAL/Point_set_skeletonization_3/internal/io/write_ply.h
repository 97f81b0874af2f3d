// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_IO_WRITE_PLY_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_IO_WRITE_PLY_H

#include <CGAL/Point_set_skeletonization_3/internal/io/Written_skeleton.h>

#include <ostream>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// PLY text: vertices with their radius, and edges.
inline void write_ply(std::ostream& os, const Written_skeleton& skeleton)
{
  os << "ply\nformat ascii 1.0\n"
     << "element vertex " << skeleton.graph.vertices.size() << '\n'
     << "property double x\nproperty double y\nproperty double z\nproperty double radius\n"
     << "element edge " << skeleton.graph.edges.size() << '\n'
     << "property int vertex1\nproperty int vertex2\nend_header\n";
  for(const Plain_vertex& v : skeleton.graph.vertices)
    os << v.point << ' ' << v.radius << '\n';
  for(const auto& [v, w] : skeleton.graph.edges)
    os << v << ' ' << w << '\n';
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_IO_WRITE_PLY_H
