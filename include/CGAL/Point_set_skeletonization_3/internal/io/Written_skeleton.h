// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_IO_WRITTEN_SKELETON_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_IO_WRITTEN_SKELETON_H

#include <CGAL/Point_set_skeletonization_3/internal/branches/Numbered_skeleton.h>
#include <CGAL/Point_set_skeletonization_3/internal/branches/ordered_branches.h>
#include <CGAL/Point_set_skeletonization_3/internal/interface/plain_data.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <ostream>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// What the writers get: a skeleton and all of its branches.
struct Written_skeleton
{
  Plain_skeleton graph;
  std::vector<Plain_branch> branches;
};

/// Returns a BGL graph with its branches from these roots, for the writers. O(n log n).
template <typename Skeleton>
Written_skeleton written_skeleton(
    const Skeleton& skeleton,
    const std::vector<typename boost::graph_traits<Skeleton>::vertex_descriptor>& roots)
{
  Numbered_skeleton<Skeleton> numbered(skeleton);
  std::vector<Plain_branch> branches = ordered_branches(numbered.plain, numbered.numbers_of(roots));
  return {std::move(numbered.plain), std::move(branches)};
}

/// Three numbers with a blank between them, as all others with the precision of the stream.
inline std::ostream& operator<<(std::ostream& os, const Plain_point& p)
{
  return os << p[0] << ' ' << p[1] << ' ' << p[2];
}

/// Calls `visit(branch, from, to)` for each edge with the position of its branch and with its ends
/// in the direction of the branch, branch by branch.
template <typename Visit>
void for_each_edge(const Written_skeleton& skeleton, const Visit& visit)
{
  for(std::size_t b = 0; b < skeleton.branches.size(); ++b) {
    const std::vector<std::size_t>& path = skeleton.branches[b].vertices;
    for(std::size_t i = 1; i < path.size(); ++i)
      visit(b, path[i - 1], path[i]);
  }
}

/// The number of a parent in formats that write -1 for none.
inline long long number_or_minus_one(std::size_t number)
{
  return number == Plain_branch::none ? -1 : static_cast<long long>(number);
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_IO_WRITTEN_SKELETON_H
