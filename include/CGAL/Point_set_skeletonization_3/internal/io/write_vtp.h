// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_IO_WRITE_VTP_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_IO_WRITE_VTP_H

#include <CGAL/Point_set_skeletonization_3/internal/io/Written_skeleton.h>

#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// VTK's XML PolyData, text: a polyline per branch, a vertex cell per lone vertex. Points have
/// their radius; cells have the number, axis and order of their branch, its length and mean radius.
class Vtp_writer
{
public:
  Vtp_writer(std::ostream& os, const Written_skeleton& skeleton)
      : os_(os)
      , skeleton_(skeleton)
  {
    for(std::size_t b = 0; b < skeleton.branches.size(); ++b)
      (skeleton.branches[b].vertices.size() == 1 ? lone_ : lines_).push_back(b);
  }

  void write()
  {
    const std::vector<Plain_vertex>& vertices = skeleton_.graph.vertices;
    os_ << "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"0.1\">\n<PolyData>\n"
        << "<Piece NumberOfPoints=\"" << vertices.size() << "\" NumberOfVerts=\"" << lone_.size()
        << "\" NumberOfLines=\"" << lines_.size()
        << "\" NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n";

    os_ << "<PointData Scalars=\"radius\">\n";
    array("Float64", "radius", vertices, [](const Plain_vertex& v) { return v.radius; });
    os_ << "</PointData>\n<CellData Scalars=\"order\">\n";
    cell_array("Int64", "branch", [](std::size_t b, const Plain_branch&) { return b; });
    cell_array("Int64", "axis",
               [](std::size_t, const Plain_branch& branch) { return branch.axis; });
    cell_array("Int64", "order",
               [](std::size_t, const Plain_branch& branch) { return branch.order; });
    cell_array("Float64", "length",
               [](std::size_t, const Plain_branch& branch) { return branch.length; });
    cell_array("Float64", "mean_radius",
               [](std::size_t, const Plain_branch& branch) { return branch.mean_radius; });
    os_ << "</CellData>\n<Points>\n";
    array("Float64\" NumberOfComponents=\"3", "points", vertices,
          [](const Plain_vertex& v) -> const Plain_point& { return v.point; });
    os_ << "</Points>\n";
    cells("Verts", lone_);
    cells("Lines", lines_);
    os_ << "</Piece>\n</PolyData>\n</VTKFile>\n";
  }

private:
  template <typename Items, typename Value>
  void array(const std::string& type, const std::string& name, const Items& items,
             const Value& value)
  {
    os_ << "<DataArray type=\"" << type << "\" Name=\"" << name << "\" format=\"ascii\">\n";
    for(const auto& item : items)
      os_ << value(item) << '\n';
    os_ << "</DataArray>\n";
  }

  // VTK numbers the cells of all points before those of all lines.
  template <typename Value>
  void cell_array(const std::string& type, const std::string& name, const Value& value)
  {
    std::vector<std::size_t> branches = lone_;
    branches.insert(branches.end(), lines_.begin(), lines_.end());
    array(type, name, branches, [&](std::size_t b) { return value(b, skeleton_.branches[b]); });
  }

  void cells(const std::string& kind, const std::vector<std::size_t>& branches)
  {
    std::vector<std::size_t> vertices, ends;
    for(std::size_t b : branches) {
      const auto& path = skeleton_.branches[b].vertices;
      vertices.insert(vertices.end(), path.begin(), path.end());
      ends.push_back(vertices.size());
    }
    const auto itself = [](std::size_t i) { return i; };
    os_ << '<' << kind << ">\n";
    array("Int64", "connectivity", vertices, itself);
    array("Int64", "offsets", ends, itself);
    os_ << "</" << kind << ">\n";
  }

  std::ostream& os_;
  const Written_skeleton& skeleton_;
  std::vector<std::size_t> lone_, lines_; ///< Branches, by the kind of their cell.
};

inline void write_vtp(std::ostream& os, const Written_skeleton& skeleton)
{
  Vtp_writer(os, skeleton).write();
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_IO_WRITE_VTP_H
