// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_IO_WRITE_GRAPHML_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_IO_WRITE_GRAPHML_H

#include <CGAL/Point_set_skeletonization_3/internal/io/Written_skeleton.h>

#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// GraphML, as networkx and igraph read it: nodes with `x y z radius`, edges with the number, axis
/// and order of their branch and their length.
inline void write_graphml(std::ostream& os, const Written_skeleton& skeleton)
{
  os << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
     << "<graphml xmlns=\"http://graphml.graphdrawing.org/xmlns\">\n";
  const auto declare = [&os](const std::string& owner, const std::string& name,
                             const std::string& type) {
    os << "<key id=\"" << name << "\" for=\"" << owner << "\" attr.name=\"" << name
       << "\" attr.type=\"" << type << "\"/>\n";
  };
  for(const char* name : {"x", "y", "z", "radius"})
    declare("node", name, "double");
  for(const char* name : {"branch", "axis", "order"})
    declare("edge", name, "int");
  declare("edge", "length", "double");
  const auto data = [&os](const std::string& name, auto value) {
    os << "<data key=\"" << name << "\">" << value << "</data>";
  };

  os << "<graph edgedefault=\"undirected\">\n";
  const std::vector<Plain_vertex>& vertices = skeleton.graph.vertices;
  for(std::size_t v = 0; v < vertices.size(); ++v) {
    os << "<node id=\"" << v << "\">";
    data("x", vertices[v].point[0]);
    data("y", vertices[v].point[1]);
    data("z", vertices[v].point[2]);
    data("radius", vertices[v].radius);
    os << "</node>\n";
  }
  for_each_edge(skeleton, [&](std::size_t b, std::size_t v, std::size_t w) {
    os << "<edge source=\"" << v << "\" target=\"" << w << "\">";
    data("branch", b);
    data("axis", skeleton.branches[b].axis);
    data("order", skeleton.branches[b].order);
    data("length", distance(vertices[v].point, vertices[w].point));
    os << "</edge>\n";
  });
  os << "</graph>\n</graphml>\n";
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_IO_WRITE_GRAPHML_H
