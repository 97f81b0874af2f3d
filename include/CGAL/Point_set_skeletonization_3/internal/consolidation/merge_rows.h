// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CONSOLIDATION_MERGE_ROWS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CONSOLIDATION_MERGE_ROWS_H

#include <CGAL/Point_set_skeletonization_3/internal/consolidation/Component_cells.h>
#include <CGAL/Point_set_skeletonization_3/internal/consolidation/cloud_of_lines.h>
#include <CGAL/Point_set_skeletonization_3/internal/consolidation/consolidate.h>
#include <CGAL/Point_set_skeletonization_3/internal/consolidation/crossing_rows.h>
#include <CGAL/Point_set_skeletonization_3/internal/consolidation/parallel_rows.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Moments.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Union_find.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/Box_tree.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/K_nearest_neighbors.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/Octree.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Raises levels until those of components in neighbouring cells differ by one at most: patches
/// that are much smaller than their neighbours are not adjacent to them. O(n) a level.
inline void balance(std::vector<int>& level_of, const Component_octree& octree)
{
  for(int level = *std::max_element(level_of.begin(), level_of.end()); level > 1; --level) {
    const Component_cells cells = octree.cells(level);
    std::vector<char> is_whole(cells.size(), false);
    const auto for_components = [&](std::size_t c, const auto& visit) {
      for(std::size_t k = cells[c].begin; k < cells[c].end; ++k)
        visit(level_of[octree.component(k)]);
    };
    for(std::size_t c = 0; c < cells.size(); ++c)
      for_components(c, [&](int other) { is_whole[c] = is_whole[c] || other >= level; });
    for(std::size_t c = 0; c < cells.size(); ++c)
      if(is_whole[c] || any_around(cells, c, is_whole))
        for_components(c, [&](int& own) { own = (std::max)(own, level - 1); });
  }
}

/// Raises levels to those whose cells are about as wide as parallel rows are apart. O(n).
inline void raise_to(std::vector<int>& level_of, const std::vector<double>& distances,
                     double cell_size)
{
  for(std::size_t i = 0; i < level_of.size(); ++i)
    if(distances[i] > cell_size)
      level_of[i] = (std::max)(
        level_of[i], static_cast<int>(std::lround(std::log2(distances[i] / cell_size))));
}

/// Returns a mixture in which the rows of a surface are pieces that are about as long as the rows
/// are apart: so neighbours are as near along the rows as across. What looked like a cloud of lines
/// may have been rows; where rows cross it was, because not all of them are found. Nothing changes
/// in a cloud without rows, or if the cells are too small for an octree. O(n log n).
/// \param flatness see `Crossing_rows`
inline Consolidated_mixture with_rows_merged(Consolidated_mixture mixture, double flatness,
                                             Concurrency concurrency)
{
  if(!has_octree(mixture.cell_size))
    return mixture;
  constexpr double contiguous = 4; // cells from one component to the next, in clouds of few points
  constexpr double few = 0.1;      // of all on lines, as by chance
  const Gaussians& components = mixture.components;
  const std::vector<Vector3> places = means_of(components);
  Parallel_rows rows(places, mixture.tree, mixture.neighbors, contiguous * mixture.cell_size,
                     concurrency);
  if(rows.share_on_lines() < few)
    return mixture;
  const Component_octree octree(components, mixture.cell_size);
  std::vector<int> level_of =
    Crossing_rows(components, mixture.neighbors, octree, flatness, concurrency).levels();
  const auto is_merged = [](int level) { return level > 0; };
  const bool are_crossing = std::any_of(level_of.begin(), level_of.end(), is_merged);
  raise_to(level_of, rows.distances(), mixture.cell_size);
  if(std::none_of(level_of.begin(), level_of.end(), is_merged))
    return mixture;
  balance(level_of, octree);
  Union_find pieces(components.size()); // two rows, or two sheets, in one cell are not joined
  for(std::size_t i = 0; i < components.size(); ++i)
    if(level_of[i] > 0)
      for(const Neighbor& neighbor : mixture.neighbors[i])
        if(level_of[neighbor.index] == level_of[i] &&
           octree.code_of(neighbor.index, level_of[i]) == octree.code_of(i, level_of[i]))
          pieces.join(i, neighbor.index);
  std::vector<std::size_t> piece_of(components.size());
  std::vector<Moments> moments;
  std::vector<Vector3> first;
  for(std::size_t i = 0; i < components.size(); ++i) {
    if(pieces.find(i) == i) { // the first of a piece has the smallest number
      piece_of[i] = moments.size();
      moments.emplace_back();
      first.push_back(components[i].mean);
    }
    else
      piece_of[i] = piece_of[pieces.find(i)];
    const std::size_t piece = piece_of[i];
    moments[piece].add(components[i].weight, components[i].mean - first[piece]);
  }
  Consolidated_mixture result;
  for(std::size_t piece = 0; piece < moments.size(); ++piece)
    result.components.push_back(
      {moments[piece].weight(), moments[piece].gaussian(first[piece]).mean, Matrix3::Zero()});
  result.tree = Box_tree(means_of(result.components), concurrency);
  for(const std::size_t i : mixture.merged_into)
    result.merged_into.push_back(i == Consolidated_mixture::none ? i : piece_of[i]);
  result.noise = mixture.noise;
  result.cell_size = mixture.cell_size;
  result.neighbors = k_nearest_neighbors(result.tree, surface_neighbors + 1, concurrency);
  result.is_of_lines =
    mixture.is_of_lines && !are_crossing &&
    is_cloud_of_lines(result.components, result.tree, result.neighbors);
  return result;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CONSOLIDATION_MERGE_ROWS_H
