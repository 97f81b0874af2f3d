// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MIXTURE_MOMENT_GRID_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MIXTURE_MOMENT_GRID_H

#include <CGAL/Point_set_skeletonization_3/internal/core/prefetch.h>
#include <CGAL/Point_set_skeletonization_3/internal/mixture/Cell_map.h>
#include <CGAL/Point_set_skeletonization_3/internal/mixture/Cubic_grid.h>
#include <CGAL/Point_set_skeletonization_3/internal/mixture/Exact_moments.h>
#include <CGAL/Point_set_skeletonization_3/internal/mixture/Lattice_point.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// The moments of the points in cells of a grid.
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

  /// The moments of a packed cell. O(1). \pre it is one of them
  const Exact_moments& of(std::uint64_t cell) const { return moments_[number_of_.at(cell)]; }

  /// The cells, packed, and their moments, in the same order.
  const std::vector<std::uint64_t>& cells() const { return cells_; }
  const std::vector<Exact_moments>& moments() const { return moments_; }

  /// Adds a point or moments to a cell. O(1).
  template <typename Addend>
  void add(const Grid_cell& cell, const Addend& addend)
  {
    moments_[inserted(cell)].add(addend);
  }

  /// Begins to load the moments of the cell with this index. O(1).
  void prefetch(std::size_t number) const { internal::prefetch(moments_[number]); }

  /// Adds a point to the cell with this index. O(1).
  void add(std::size_t number, const Lattice_point& p) { moments_[number].add(p); }

  /// Adds the moments of cells of a finer grid, each to the cell `around` it. O(cells).
  void add(const Moment_cells& other, const Cell_around& around)
  {
    for(std::size_t i = 0; i < other.size(); ++i)
      add(around(unpacked(other.cells()[i])), other.moments_[i]);
  }

  /// Merges the cells into those of a coarser grid, each into the one `around` it. In place: a
  /// second set of moments would double the peak of memory. O(cells).
  void coarsen(const Cell_around& around)
  {
    number_of_ = Cell_map<std::uint32_t>();
    std::size_t coarse = 0; // never more than cells read
    for(std::size_t i = 0; i < cells_.size(); ++i) {
      const std::uint64_t cell = packed(around(unpacked(cells_[i])));
      std::uint32_t& number = number_of_[cell];
      if(number_of_.size() == coarse) {
        moments_[number].add(moments_[i]);
        continue;
      }
      number = static_cast<std::uint32_t>(coarse);
      cells_[coarse] = cell;
      moments_[coarse] = moments_[i];
      ++coarse;
    }
    cells_.resize(coarse);
    moments_.resize(coarse);
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
  std::vector<Exact_moments> moments_;
};

/// The moments of points in the cells of the finest cubic grid with a bounded number of them, which
/// depends on the set of points only. Grids of parts of the points add up to the grid of all, bit
/// for bit.
class Moment_grid
{
public:
  explicit Moment_grid(std::size_t maximum_cells)
    : maximum_cells_(maximum_cells), grid_{finest_level(maximum_cells), 1}
  {}

  std::size_t maximum_cells() const { return maximum_cells_; }
  const Cubic_grid& grid() const { return grid_; }
  const Moment_cells& cells() const { return cells_; }

  /// Adds a point. O(1) amortised.
  void add(const Lattice_point& p)
  {
    cells_.add(cell_of_(p), p);
    limit();
  }

  /// Adds the points of another grid. O(cells).
  void add(const Moment_grid& other)
  {
    coarsen_to(std::min(grid_.level, other.grid_.level));
    cells_.add(other.cells_, grid_.around(other.grid_));
    limit();
  }

  /// Number of points. O(cells).
  std::size_t size() const
  {
    std::size_t result = 0;
    for(const Exact_moments& moments : cells_.moments())
      result += moments.number();
    return result;
  }

  /// The points of some of the cells, packed. O(cells). \pre there are such cells
  Moment_grid restricted_to(const std::vector<std::uint64_t>& cells) const
  {
    Moment_grid result(maximum_cells_);
    result.coarsen_to(grid_.level);
    for(const std::uint64_t cell : cells)
      result.cells_.add(unpacked(cell), cells_.of(cell));
    return result;
  }

  /// Writes the grid to an archive as of Boost.Serialization: the cells in order, whatever the
  /// order in which they came. O(cells log cells).
  template <typename Archive>
  void save(Archive& archive, unsigned int) const
  {
    archive& std::uint64_t(maximum_cells_);
    archive& std::uint64_t(static_cast<unsigned int>(grid_.level));
    archive& std::uint64_t(cells_.size());
    std::vector<std::uint64_t> ordered = cells_.cells();
    std::sort(ordered.begin(), ordered.end());
    for(const std::uint64_t cell : ordered) {
      archive& cell;
      archive& cells_.of(cell).words();
    }
  }

  /// Reads what `save()` wrote. \throws std::runtime_error if that was something else
  template <typename Archive>
  void load(Archive& archive, unsigned int)
  {
    std::uint64_t maximum_cells, level, size, cell;
    archive& maximum_cells;
    archive& level;
    archive& size;
    if(level > static_cast<std::uint64_t>(finest_level(static_cast<std::size_t>(maximum_cells))) ||
       size > maximum_cells)
      throw std::runtime_error("it is damaged");
    *this = Moment_grid(static_cast<std::size_t>(maximum_cells));
    coarsen_to(static_cast<int>(level));
    for(Exact_moments::Words words; size > 0; --size) {
      archive& cell;
      archive& words;
      cells_.add(unpacked(cell), Exact_moments::of_words(words));
    }
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
    cells_.coarsen(grid_.around(fine));
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
