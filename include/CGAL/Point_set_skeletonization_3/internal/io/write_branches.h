// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_IO_WRITE_BRANCHES_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_IO_WRITE_BRANCHES_H

#include <CGAL/Point_set_skeletonization_3/internal/io/Written_skeleton.h>

#include <cmath>
#include <cstddef>
#include <ostream>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// A table of the branches, one a row, numbered from 0; -1 is no parent, an unknown angle is empty.
/// \param points number of points of each branch; empty if that is not known
inline void write_branches(std::ostream& os, const Written_skeleton& skeleton,
                           const std::vector<std::size_t>& points = {})
{
  os << "branch,parent,axis,order,closes_cycle,length,chord,mean_radius,volume,angle,points,"
     << "start_x,start_y,start_z,end_x,end_y,end_z\n";
  const auto write_point = [&os](const Plain_point& p) {
    os << ',' << p[0] << ',' << p[1] << ',' << p[2];
  };
  for(std::size_t b = 0; b < skeleton.branches.size(); ++b) {
    const Plain_branch& branch = skeleton.branches[b];
    os << b << ',' << number_or_minus_one(branch.parent) << ',' << branch.axis << ','
       << branch.order << ',' << (branch.closes_cycle ? 1 : 0) << ',' << branch.length << ','
       << branch.chord << ',' << branch.mean_radius << ',' << branch.volume << ',';
    if(!std::isnan(branch.angle))
      os << branch.angle;
    os << ',';
    if(!points.empty())
      os << points[b];
    write_point(skeleton.graph.vertices[branch.vertices.front()].point);
    write_point(skeleton.graph.vertices[branch.vertices.back()].point);
    os << '\n';
  }
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_IO_WRITE_BRANCHES_H
