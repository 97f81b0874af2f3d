// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_LINE_TREES_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_LINE_TREES_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Union_find.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/minimum_spanning_forest.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Refined_quotient.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/surface_quotient.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/wave_fronts.h>
#include <CGAL/Point_set_skeletonization_3/internal/medial/Sample.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch_graph.h>

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Two vertices of a quotient, by the shortest way between their patches.
struct Patch_link
{
  std::size_t a, b;
  double length;

  bool operator<(const Patch_link& other) const
  {
    return std::tie(length, a, b) < std::tie(other.length, other.a, other.b);
  }
};

/// Part 3b: replaces the pieces of a quotient that are mostly of patches on lines by trees of their
/// patches. Twigs of single points have no ring around them that a separator could be, and where
/// their points are further apart than the twigs, all of them are one piece. What runs through such
/// points is their minimum spanning tree, joined to the limbs around where it touches them. Since
/// nothing was seen of these twigs from all sides, they close no cycle. O(n log n).
/// \param pairs adjacent patches, `Ball_overlaps::pairs()`
/// \param is_on_line of each patch
inline Surface_quotient with_line_trees(Surface_quotient quotient, const Patches& patches,
                                        const Samples& samples,
                                        const std::vector<Patch_pair>& pairs,
                                        const std::vector<bool>& is_on_line)
{
  if(std::find(is_on_line.begin(), is_on_line.end(), true) == is_on_line.end())
    return quotient;
  std::vector<bool> is_replaced;
  for(std::size_t v = 0; v < quotient.members.size(); ++v)
    is_replaced.push_back(is_piece(v, quotient) && are_mostly(quotient.members[v], is_on_line));
  Refined_quotient refined(quotient);
  for(std::size_t v = 0; v < is_replaced.size(); ++v)
    if(is_replaced[v]) {
      refined.remove(v);
      for(std::size_t i : quotient.members[v])
        refined.add_to_front(refined.add_front(), i);
    }
  std::vector<Patch_link> links;
  for(const Patch_pair& pair : pairs)
    if(is_replaced[quotient.vertex_of_patch[pair.a]] ||
       is_replaced[quotient.vertex_of_patch[pair.b]])
      links.push_back({refined.vertex_of(pair.a), refined.vertex_of(pair.b),
                       (patches[pair.a].mean - patches[pair.b].mean).norm()});
  Union_find sets(refined.number_of_vertices());
  for(const Skeleton_graph::Edge& e : quotient.graph.edges)
    if(!is_replaced[e.first] && !is_replaced[e.second])
      sets.join(e.first, e.second);
  for(const Patch_link& link :
      minimum_spanning_forest(sets, refined.number_of_vertices(), std::move(links)))
    refined.add_edge(link.a, link.b);
  return refined.take(patches, samples);
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_LINE_TREES_H
