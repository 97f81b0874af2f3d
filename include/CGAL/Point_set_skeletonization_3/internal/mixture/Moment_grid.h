// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MIXTURE_MOMENT_GRID_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MIXTURE_MOMENT_GRID_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Moments.h>
#include <CGAL/Point_set_skeletonization_3/internal/mixture/Cell_map.h>
#include <CGAL/Point_set_skeletonization_3/internal/mixture/Cubic_grid.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// The moments of the points in cells of a grid, about the centres of the cells.
class Moment_cells
{
public:
  Moment_cells() = default;

  /// With distinct cells in this order, without points. O(cells).
  explicit Moment_cells(const std::vector<std::uint64_t>& cells)
    : number_of_(cells.size()), cells_(cells), moments_(cells.size())
  {
    for(std::size_t i = 0; i < cells.size(); ++i)
      number_of_[cells[i]] = static_cast<std::uint32_t>(i);
  }

  std::size_t size() const { return cells_.size(); }

  /// Index of a cell and its moments. O(1). \pre it is one of them
  std::size_t number(const Grid_cell& cell) const { return number_of_.at(packed(cell)); }

  /// The cells, packed, and their moments, in the same order.
  const std::vector<std::uint64_t>& cells() const { return cells_; }
  const std::vector<Moments>& moments() const { return moments_; }

  /// Adds a point to its cell. O(1).
  void add(const Cubic_grid& grid, const Grid_cell& cell, const Vector3& p)
  {
    moments_[inserted(cell)].add(1, p - grid.center(cell));
  }

  /// Adds moments about the same centres, in the same order. O(cells).
  void add(const std::vector<Moments>& others)
  {
    for(std::size_t i = 0; i < others.size(); ++i)
      moments_[i].add(others[i], Vector3::Zero());
  }

  /// Adds the moments of the cells of `fine`, as fine as `grid` or finer; exact up to rounding.
  /// O(cells).
  void add(const Cubic_grid& grid, const Moment_cells& other, const Cubic_grid& fine)
  {
    const Cell_around around = grid.around(fine);
    for(std::size_t i = 0; i < other.size(); ++i) {
      const Grid_cell part = unpacked(other.cells()[i]), cell = around(part);
      moments_[inserted(cell)].add(other.moments_[i], fine.center(part) - grid.center(cell));
    }
  }

private:
  /// Index of a cell, which is added if it is new.
  std::size_t inserted(const Grid_cell& cell)
  {
    const std::size_t known = number_of_.size();
    std::uint32_t& number = number_of_[packed(cell)];
    if(number_of_.size() > known) {
      number = static_cast<std::uint32_t>(known);
      cells_.push_back(packed(cell));
      moments_.emplace_back();
    }
    return number;
  }

  Cell_map<std::uint32_t> number_of_;
  std::vector<std::uint64_t> cells_; ///< Packed.
  std::vector<Moments> moments_;
};

/// The moments of points in the cells of the finest cubic grid with a bounded number of them, which
/// depends on the set of points only. Grids of parts of the points add up to the grid of all.
class Moment_grid
{
public:
  explicit Moment_grid(std::size_t maximum_cells) : maximum_cells_(maximum_cells) {}

  const Cubic_grid& grid() const { return grid_; }
  const Moment_cells& cells() const { return cells_; }

  /// Adds a point. O(1) amortised.
  void add(const Vector3& p)
  {
    cells_.add(grid_, cell_of_(p), p);
    limit();
  }

  /// Adds the points of another grid. O(cells).
  void add(const Moment_grid& other)
  {
    coarsen_to(std::min(grid_.level, other.grid_.level));
    cells_.add(grid_, other.cells_, other.grid_);
    limit();
  }

private:
  /// Coarsens until there are few enough. The eight cells around the origin are never merged.
  void limit()
  {
    while(cells_.size() > maximum_cells_)
      coarsen_to(grid_.level - 1);
  }

  void coarsen_to(int level)
  {
    if(level == grid_.level)
      return;
    const Cubic_grid fine = std::exchange(grid_, {level, 1});
    const Moment_cells fine_cells = std::exchange(cells_, Moment_cells());
    cells_.add(grid_, fine_cells, fine);
    cell_of_ = Cell_of_point(grid_);
  }

  std::size_t maximum_cells_;
  Cubic_grid grid_;
  Cell_of_point cell_of_{grid_};
  Moment_cells cells_;
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MIXTURE_MOMENT_GRID_H
