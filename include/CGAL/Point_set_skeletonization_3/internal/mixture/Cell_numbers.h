// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MIXTURE_CELL_NUMBERS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MIXTURE_CELL_NUMBERS_H

#include <CGAL/Point_set_skeletonization_3/internal/mixture/Cubic_grid.h>
#include <CGAL/Point_set_skeletonization_3/internal/mixture/Lattice_point.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// The occupied cells of a grid, in order: finds the cell of a point after all points are gone.
struct Cell_numbers
{
  Cubic_grid grid;
  std::vector<std::uint64_t> cells; ///< Packed, ascending.

  /// The place of the cell that contains a point; the number of cells if it is not occupied.
  /// O(log cells).
  std::size_t number(const Lattice_point& p) const
  {
    const std::uint64_t cell = packed(Cell_of_point(grid)(p));
    const auto found = std::lower_bound(cells.begin(), cells.end(), cell);
    return found != cells.end() && *found == cell
               ? static_cast<std::size_t>(found - cells.begin())
               : cells.size();
  }
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MIXTURE_CELL_NUMBERS_H
