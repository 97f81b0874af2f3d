// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_IO_WRITE_CYLINDERS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_IO_WRITE_CYLINDERS_H

#include <CGAL/Point_set_skeletonization_3/internal/io/Written_skeleton.h>

#include <cstddef>
#include <ostream>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// A quantitative structure model (QSM) as a table: a cylinder per edge, with the columns of
/// SimpleForest. IDs count from 0 and -1 is none; a segment is what we call a branch, a branch is
/// what we call an axis. The radius is the mean of both ends.
inline void write_cylinders(std::ostream& os, const Written_skeleton& skeleton)
{
  os << "ID,parentID,startX,startY,startZ,endX,endY,endZ,radius,length,"
     << "branchOrder,branchID,segmentID,parentSegmentID\n";
  const auto write_point = [&os](const Plain_point& p) {
    os << p[0] << ',' << p[1] << ',' << p[2] << ',';
  };
  constexpr std::size_t none = Plain_branch::none;
  std::vector<std::size_t> last(skeleton.branches.size(), none); // cylinder of each branch
  std::size_t id = 0;
  for_each_edge(skeleton, [&](std::size_t b, std::size_t v, std::size_t w) {
    const Plain_branch& branch = skeleton.branches[b];
    const Plain_vertex& start = skeleton.graph.vertices[v];
    const Plain_vertex& end = skeleton.graph.vertices[w];
    const std::size_t parent = last[b] != none         ? last[b]
                               : branch.parent != none ? last[branch.parent]
                                                       : none;
    os << id << ',' << number_or_minus_one(parent) << ',';
    write_point(start.point);
    write_point(end.point);
    os << (start.radius + end.radius) / 2 << ',' << distance(start.point, end.point) << ','
       << branch.order << ',' << branch.axis << ',' << b << ','
       << number_or_minus_one(branch.parent) << '\n';
    last[b] = id++;
  });
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_IO_WRITE_CYLINDERS_H
