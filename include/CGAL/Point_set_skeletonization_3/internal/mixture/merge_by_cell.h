// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MIXTURE_MERGE_BY_CELL_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MIXTURE_MERGE_BY_CELL_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Moments.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// The occupied cell of a cubic grid of each Gaussian.
struct Grid_cells
{
  std::vector<std::size_t> cell_of; ///< The cell of each Gaussian.
  std::size_t size = 0;             ///< Number of cells, which are in lexicographic order.
};

/// Returns the cells of the means of Gaussians. O(n log n). \pre the edge length `cell_size` is > 0
inline Grid_cells grid_cells(const Gaussians& gaussians, double cell_size)
{
  const std::size_t size = gaussians.size();
  std::vector<std::pair<std::array<double, 3>, std::size_t>> order;
  order.reserve(size);
  for(std::size_t i = 0; i < size; ++i) {
    const Vector3 cell = (gaussians[i].mean / cell_size).array().floor();
    order.push_back({{{cell.x(), cell.y(), cell.z()}}, i});
  }
  std::sort(order.begin(), order.end());
  Grid_cells result;
  result.cell_of.resize(size);
  for(std::size_t k = 0; k < size; ++k) {
    if(k == 0 || order[k].first != order[k - 1].first)
      ++result.size;
    result.cell_of[order[k].second] = result.size - 1;
  }
  return result;
}

/// Merged Gaussians, and the index of the one that each was merged into.
struct Merged_gaussians
{
  Gaussians gaussians;
  std::vector<std::size_t> merged_into;
};

/// Merges Gaussians whose means are in one cell of a cubic grid; moments stay exact. None are
/// merged if `cell_size` is 0. O(n log n).
inline Merged_gaussians merged_by_cell(const Gaussians& fine, double cell_size)
{
  if(!(cell_size > 0)) {
    Merged_gaussians same{fine, std::vector<std::size_t>(fine.size())};
    std::iota(same.merged_into.begin(), same.merged_into.end(), std::size_t(0));
    return same;
  }
  const Grid_cells cells = grid_cells(fine, cell_size);
  std::vector<Moments> moments(cells.size); // about the first mean of every cell
  std::vector<Vector3> first(cells.size);
  for(std::size_t i = 0; i < fine.size(); ++i) {
    const std::size_t c = cells.cell_of[i];
    if(!(moments[c].weight() > 0))
      first[c] = fine[i].mean;
    moments[c].add(fine[i].weight, fine[i].mean - first[c], fine[i].covariance);
  }
  Merged_gaussians result;
  for(std::size_t c = 0; c < cells.size; ++c)
    result.gaussians.push_back(moments[c].gaussian(first[c]));
  result.merged_into = cells.cell_of;
  return result;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MIXTURE_MERGE_BY_CELL_H
