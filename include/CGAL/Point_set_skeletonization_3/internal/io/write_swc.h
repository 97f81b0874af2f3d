// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_IO_WRITE_SWC_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_IO_WRITE_SWC_H

#include <CGAL/Point_set_skeletonization_3/internal/io/Written_skeleton.h>

#include <cstddef>
#include <ostream>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// SWC, the format of neuron reconstructions: `id type x y z radius parent`, ids from 1, the type 0
/// (undefined), the parent -1 for a root. It can hold trees only, so a cycle is opened at the far
/// end of the branch that closes it; comments name the two ids of each edge left out.
inline void write_swc(std::ostream& os, const Written_skeleton& skeleton)
{
  os << "# id type x y z radius parent\n";
  std::vector<std::size_t> id(skeleton.graph.vertices.size(), 0);
  std::size_t ids = 0;
  const auto write = [&](std::size_t v, long long parent) {
    id[v] = ++ids;
    os << id[v] << " 0 " << skeleton.graph.vertices[v].point << ' '
       << skeleton.graph.vertices[v].radius << ' ' << parent << '\n';
  };
  std::vector<std::pair<std::size_t, std::size_t>> left_out;
  for(const Plain_branch& branch : skeleton.branches) {
    const std::vector<std::size_t>& path = branch.vertices;
    if(id[path.front()] == 0)
      write(path.front(), -1);
    for(std::size_t i = 1; i < path.size(); ++i)
      if(id[path[i]] == 0)
        write(path[i], static_cast<long long>(id[path[i - 1]]));
      else
        left_out.emplace_back(id[path[i - 1]], id[path[i]]);
  }
  for(const auto& [v, w] : left_out)
    os << "# closes a cycle: " << v << ' ' << w << '\n';
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_IO_WRITE_SWC_H
