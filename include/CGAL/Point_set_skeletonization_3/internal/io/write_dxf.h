// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_IO_WRITE_DXF_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_IO_WRITE_DXF_H

#include <CGAL/Point_set_skeletonization_3/internal/io/Written_skeleton.h>

#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// DXF of AutoCAD release 12, which every CAD program reads: a 3D polyline per branch, a point per
/// lone vertex, each in the layer of its order.
inline void write_dxf(std::ostream& os, const Written_skeleton& skeleton)
{
  const auto entity = [&os](const std::string& type, const std::string& layer) {
    os << "0\n" << type << "\n8\n" << layer << '\n';
  };
  const auto place = [&os](const Plain_point& p) {
    os << "10\n" << p[0] << "\n20\n" << p[1] << "\n30\n" << p[2] << '\n';
  };
  os << "0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1009\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n";
  for(const Plain_branch& branch : skeleton.branches) {
    const std::vector<std::size_t>& path = branch.vertices;
    const std::string layer = "ORDER_" + std::to_string(branch.order);
    if(path.size() == 1) {
      entity("POINT", layer);
      place(skeleton.graph.vertices[path.front()].point);
      continue;
    }
    const bool is_closed = path.front() == path.back(); // then the last vertex is not written
    entity("POLYLINE", layer);
    os << "66\n1\n70\n" << (is_closed ? 9 : 8) << '\n';
    place({{0, 0, 0}});
    for(std::size_t i = 0; i < path.size() - (is_closed ? 1 : 0); ++i) {
      entity("VERTEX", layer);
      place(skeleton.graph.vertices[path[i]].point);
      os << "70\n32\n";
    }
    entity("SEQEND", layer);
  }
  os << "0\nENDSEC\n0\nEOF\n";
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_IO_WRITE_DXF_H
