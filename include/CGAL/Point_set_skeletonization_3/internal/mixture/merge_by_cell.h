// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MIXTURE_MERGE_BY_CELL_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MIXTURE_MERGE_BY_CELL_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Positions sorted into the occupied cells of a cubic grid.
struct Grid_cells
{
  std::vector<std::size_t> cell_of; ///< The cell of every position.
  std::size_t size = 0;             ///< Number of cells; they are numbered in lexicographic order.
};

/// Sorts `size` positions into cells of the given edge length; `position(i)` gives the `i`-th.
template <typename Position>
Grid_cells grid_cells(std::size_t size, const Position& position, double cell_size)
{
  std::vector<std::pair<std::array<double, 3>, std::size_t>> order;
  order.reserve(size);
  for(std::size_t i = 0; i < size; ++i) {
    const Vector3 cell = (position(i) / cell_size).array().floor();
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

/// Merges the Gaussians that share a cell; moments merge exactly.
inline Gaussians coarsened(const Gaussians& fine, double cell_size)
{
  const Grid_cells cells =
    grid_cells(fine.size(), [&](std::size_t i) { return fine[i].mean; }, cell_size);
  std::vector<Moments> moments(cells.size, Moments(Vector3::Zero()));
  std::vector<bool> begun(cells.size, false);
  for(std::size_t i = 0; i < fine.size(); ++i) {
    const std::size_t c = cells.cell_of[i];
    if(!begun[c])
      moments[c] = Moments(fine[i].mean);
    begun[c] = true;
    moments[c].add(fine[i]);
  }
  Gaussians result;
  for(const Moments& m : moments)
    result.push_back(m.gaussian());
  return result;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MIXTURE_MERGE_BY_CELL_H
