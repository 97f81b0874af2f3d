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

/// Joins sets by their minimum spanning forest (Boruvka 1926): every round finds the least link that
/// leaves each set. Returns the links that were taken.
///
/// \param sets the numbers that links join; on return, what is connected is one set
/// \param for_each_link `for_each_link(visit)` calls `visit(link)` for every link, which returns whether
///        the link is between two sets. It is called once a round, O(log n) times, so that links need not
///        be stored; those within a set may be left out
/// \tparam Link has `.a` and `.b`, the numbers that it joins, and a strict total order `<`: with one,
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

/// The same of links in a list.
template <typename Link>
std::vector<Link> minimum_spanning_forest(Union_find& sets, std::size_t size,
                                          std::vector<Link> links)
{
  return minimum_spanning_forest<Link>(sets, size, [&](const auto& visit) {
    std::size_t left = 0; // between sets
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
