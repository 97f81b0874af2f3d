// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_MINIMUM_SPANNING_FOREST_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_MINIMUM_SPANNING_FOREST_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Union_find.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Joins sets by the minimum spanning forest of some links and returns its links (Boruvka 1926):
/// each round takes the least link that leaves each set. O(log n) rounds, each linear in numbers
/// and links.
///
/// \param sets sets of the numbers that links join; on return, each connected component is one set
/// \param size of `sets`
/// \param for_each_link `for_each_link(visit)` calls `visit(link)` for each link, which returns
///        whether the link joins two sets. Called once a round, so that links need not be stored;
///        those within a set may be omitted
/// \tparam Link has `.a` and `.b`, the numbers that it joins, and a strict total order `<`, so that
///         the forest does not depend on the order of the links
template <typename Link, typename ForEachLink>
std::vector<Link> minimum_spanning_forest(Union_find& sets, std::size_t size,
                                          const ForEachLink& for_each_link)
{
  std::vector<Link> forest;
  for(;;) {
    std::vector<Link> least(size); // of every root
    std::vector<char> has_link(size, 0);
    for_each_link([&](const Link& link) {
      const std::size_t a = sets.find(link.a), b = sets.find(link.b);
      if(a == b)
        return false;
      for(std::size_t root : {a, b})
        if(!has_link[root] || link < least[root]) {
          least[root] = link;
          has_link[root] = 1;
        }
      return true;
    });
    const std::size_t before = forest.size();
    for(std::size_t root = 0; root < size; ++root)
      if(has_link[root] && sets.join(least[root].a, least[root].b))
        forest.push_back(least[root]);
    if(forest.size() == before)
      return forest;
  }
}

/// The same for a list of links.
template <typename Link>
std::vector<Link> minimum_spanning_forest(Union_find& sets, std::size_t size,
                                          std::vector<Link> links)
{
  return minimum_spanning_forest<Link>(sets, size, [&](const auto& visit) {
    std::size_t left = 0; // links between sets
    for(const Link& link : links) {
      links[left] = link;
      left += visit(link);
    }
    links.resize(left);
  });
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_MINIMUM_SPANNING_FOREST_H
