// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_WAYS_THROUGH_PIECES_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_WAYS_THROUGH_PIECES_H

#include <CGAL/Point_set_skeletonization_3/internal/curve/Blocks.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Skeleton_graph.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/surface_quotient.h>
#include <CGAL/Point_set_skeletonization_3/internal/separators/Local_separator.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// A side of a separator.
struct Separator_side
{
  std::size_t separator;
  std::size_t side; ///< 0 or 1.
};

/// A way of a handle through a piece of the surface: from one separator to another, or from one side
/// of a separator around to its other side.
struct Way_through
{
  Separator_side from, to;

  bool leads_around() const { return from.separator == to.separator; }
};

/// The ways through pieces, by their vertices.
using Ways_through_pieces = std::map<std::size_t, std::vector<Way_through>>;

/// Returns the side of a separator that is in a piece, which is beside it. O(side).
inline Separator_side side_in(std::size_t piece, std::size_t separator,
                              const Surface_quotient& quotient,
                              const std::vector<Local_separator>& separators)
{
  const std::vector<std::size_t>& first = separators[separator].sides[0];
  const bool is_first = std::any_of(first.begin(), first.end(), [&](std::size_t i) {
    return quotient.vertex_of_patch[i] == piece;
  });
  return {separator, is_first ? std::size_t(0) : std::size_t(1)};
}

/// Returns the ways of handles through pieces with patches of their own: as many as there are
/// independent cycles through the piece. O(n log n).
/// \param separators the first vertices of the quotient
inline Ways_through_pieces ways_through_pieces(const Surface_quotient& quotient,
                                               const std::vector<Local_separator>& separators)
{
  // Separators beside a piece whose edges to it are in one block are on cycles through the piece.
  const Blocks blocks = blocks_of(quotient.graph);
  std::map<std::pair<std::size_t, std::size_t>, std::vector<std::size_t>> around; // piece and block
  for(std::size_t e = 0; e < quotient.graph.edges.size(); ++e) {
    const auto [a, b] = quotient.graph.edges[e];
    const std::size_t separator = (std::min)(a, b), piece = (std::max)(a, b);
    if(separator < separators.size() && is_piece(piece, quotient))
      around[{piece, blocks.of_edge[e]}].push_back(separator);
  }
  Ways_through_pieces result;
  for(const auto& [place, beside] : around)
    for(std::size_t k = 1; k < beside.size(); ++k)
      result[place.first].push_back({side_in(place.first, beside[0], quotient, separators),
                                     side_in(place.first, beside[k], quotient, separators)});
  for(const Surface_quotient::Handle& handle : quotient.handles)
    if(is_piece(handle.piece, quotient))
      result[handle.piece].push_back({{handle.separator, 1}, {handle.separator, 0}});
  return result;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_WAYS_THROUGH_PIECES_H
