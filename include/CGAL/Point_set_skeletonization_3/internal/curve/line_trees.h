// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_LINE_TREES_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_LINE_TREES_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Union_find.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/minimum_spanning_forest.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/straightness.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Bridge.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Refined_quotient.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/surface_quotient.h>
#include <CGAL/Point_set_skeletonization_3/internal/medial/Sample.h>
#include <CGAL/Point_set_skeletonization_3/internal/medial/sample_kinds.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch_graph.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Divides pieces of a quotient into patches of twigs and pieces of other patches.
class Line_trees
{
public:
  /// Refers to all arguments but the last. O(n).
  Line_trees(const Surface_quotient& quotient, const Patches& patches,
             const std::vector<Patch_pair>& pairs, const Unresolved_limbs& limbs)
    : quotient_(quotient), patches_(patches), pairs_(pairs),
      is_replaced_(twigs_of_pieces(limbs)), result_(quotient)
  {}

  /// Returns the quotient with trees of the patches of twigs. To be called once. O(n log n).
  Surface_quotient run(const Samples& samples)
  {
    Union_find sets = result_.take_out(is_replaced_, pairs_);
    for(std::size_t i = 0; i < is_replaced_.size(); ++i)
      if(is_replaced_[i])
        result_.add_to_front(result_.add_front_at(patches_[i].mean), i);
    const auto is_measured = [&](std::size_t i) { return is_off_surface(samples[i], patches_[i]); };
    std::vector<Bridge> bridges;
    for(const Patch_pair& pair : pairs_)
      if(is_replaced_[pair.a] || is_replaced_[pair.b] ||
         !(is_measured(pair.a) && is_measured(pair.b)))
        bridges.push_back({result_.vertex_of(pair.a), result_.vertex_of(pair.b),
                           (patches_[pair.a].mean - patches_[pair.b].mean).norm()});
    for(const Bridge& added :
        minimum_spanning_forest(sets, result_.number_of_vertices(), std::move(bridges)))
      result_.add_edge(added.a, added.b);
    return result_.take(patches_, samples);
  }

private:
  /// Which patches of pieces are of twigs, as many together as it takes to see a line: fewer are
  /// straight by chance. In a piece that is mostly of twigs all are, but for limbs of another kind:
  /// where twigs are as close to each other as their points, some seem to face another side, that
  /// of the next twig.
  std::vector<bool> twigs_of_pieces(const Unresolved_limbs& limbs) const
  {
    const std::vector<bool>& is_of_twig = limbs.is_of_twig;
    Union_find lines(patches_.size());
    for(const Patch_pair& pair : pairs_)
      if(is_of_twig[pair.a] && is_of_twig[pair.b])
        lines.join(pair.a, pair.b);
    std::vector<std::size_t> size(patches_.size(), 0);
    for(std::size_t i = 0; i < size.size(); ++i)
      ++size[lines.find(i)];
    std::vector<bool> result;
    for(std::size_t i = 0; i < size.size(); ++i)
      result.push_back(is_of_twig[i] && size[lines.find(i)] >= places_of_line &&
                       is_piece(quotient_.vertex_of_patch[i], quotient_));
    for(std::size_t v = 0; v < quotient_.members.size(); ++v)
      if(is_piece(v, quotient_) && are_mostly(quotient_.members[v], result))
        for(std::size_t i : quotient_.members[v])
          result[i] = !limbs.is_loose[i];
    return result;
  }

  const Surface_quotient& quotient_;
  const Patches& patches_;
  const std::vector<Patch_pair>& pairs_;
  std::vector<bool> is_replaced_; ///< Of each patch.
  Refined_quotient result_;
};

/// Part 3b: replaces the patches of pieces that are of twigs by trees. Twigs of single points have
/// no ring around them that a separator could be, and where their points are further apart than the
/// twigs, all of them are one piece, with the limb that they grow on. What runs through such points
/// is their minimum spanning tree, joined to the limbs around, and to what is left of the piece,
/// where it touches them. Nothing was seen of these twigs from all sides: they close no cycle.
/// Limbs that touch where one has no medial ball may be one: they are joined there, rather than
/// over a longer way by twigs. O(n log n).
/// \param pairs adjacent patches, `Ball_overlaps::pairs()`
inline Surface_quotient with_line_trees(Surface_quotient quotient, const Patches& patches,
                                        const Samples& samples,
                                        const std::vector<Patch_pair>& pairs,
                                        const Unresolved_limbs& limbs)
{
  if(std::find(limbs.is_of_twig.begin(), limbs.is_of_twig.end(), true) == limbs.is_of_twig.end())
    return quotient;
  return Line_trees(quotient, patches, pairs, limbs).run(samples);
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_LINE_TREES_H
