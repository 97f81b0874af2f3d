// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MIXTURE_OCCUPIED_CELLS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MIXTURE_OCCUPIED_CELLS_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Normalized_points.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Per_thread.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Progress.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/mixture/Cell_set.h>
#include <CGAL/Point_set_skeletonization_3/internal/mixture/Cubic_grid.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Which cells are occupied by points, in a grid that gets coarser as they come. Memory is bounded by
/// the number of blocks of cells, which are fewer than cells: so points may be read at a level that is
/// finer by two than the one that is asked for, and that is found in the end.
class Occupied_cells
{
public:
  /// Of no points, at a level to begin with.
  Occupied_cells(int level, std::size_t maximum_blocks)
    : maximum_blocks_(maximum_blocks), grid_{level, 1}
  {}

  const Cubic_grid& grid() const { return grid_; }
  const Cell_set& cells() const { return cells_; }

  void add(const Vector3& p)
  {
    cells_.insert(cell_of_(p));
    limit();
  }

  /// Adds the cells of other points.
  void add(Occupied_cells other)
  {
    while(grid_.level > other.grid_.level)
      coarsen();
    while(other.grid_.level > grid_.level)
      other.coarsen();
    cells_.add(std::move(other.cells_));
    limit();
  }

  void coarsen()
  {
    --grid_.level;
    cells_ = cells_.coarsened();
    cell_of_ = Cell_of_point(grid_);
  }

private:
  void limit()
  {
    while(cells_.number_of_blocks() > maximum_blocks_)
      coarsen();
  }

  std::size_t maximum_blocks_;
  Cubic_grid grid_;
  Cell_of_point cell_of_{grid_};
  Cell_set cells_;
};

/// The level that the fine grid of a cloud probably has, as some of the points tell.
inline int probable_level(const Normalized_points& points, std::size_t maximum_cells)
{
  constexpr int coarse_level = 8; // far coarser than the fine grid of so many points
  constexpr std::size_t blocks = 64;
  constexpr std::size_t points_of_cell = 8; // on average: then hardly any cell has none of them
  Occupied_cells some(coarse_level, maximum_cells);
  const std::size_t step = 1 + points.number_of_blocks() / blocks;
  std::size_t size = 0;
  for(std::size_t b = 0; b < points.number_of_blocks(); b += step)
    for(const Vector3& p : points.block(b)) {
      some.add(p);
      ++size;
    }
  while(points_of_cell * some.cells().size() > size)
    some.coarsen();
  int level = some.grid().level;
  for(std::size_t cells = 4 * some.cells().size(); cells <= maximum_cells && level < finest_level;
      cells *= 4) // as a surface has
    ++level;
  return level;
}

/// The occupied cells of a cloud, read at a level; in the end a coarser one, if there are more than
/// `maximum_cells`.
inline Occupied_cells occupied_cells(const Normalized_points& points, int level,
                                     std::size_t maximum_cells, Concurrency concurrency,
                                     const Progress& progress)
{
  Occupied_cells result = parallel_sum(
    concurrency, points.number_of_blocks(), Occupied_cells(level, maximum_cells),
    [&](std::size_t b, Occupied_cells& cells) {
      for(const Vector3& p : points.block(b))
        cells.add(p);
    },
    progress);
  while(result.cells().size() > maximum_cells)
    result.coarsen();
  return result;
}

/// The occupied cells of a cloud in the finest cubic grid that has no more than `maximum_cells`.
inline Occupied_cells occupied_cells(const Normalized_points& points, std::size_t maximum_cells,
                                     Concurrency concurrency, const Progress& progress)
{
  int level = finest_level;
  if(points.size() > maximum_cells)
    level = std::min(level, probable_level(points, maximum_cells) + 1);
  for(;; ++level) {
    Occupied_cells result = occupied_cells(points, level, maximum_cells, concurrency, progress);
    if(level == finest_level || result.grid().level < level) // else a finer one may do
      return result;
  }
}

/// Cells of a fine grid, packed, in no order; one may be there several times.
struct Fine_cells
{
  Cubic_grid grid;
  std::vector<std::uint64_t> cells;
};

/// The occupied cells of a cloud in the finest cubic grid that has no more than `maximum_cells`.
inline Fine_cells fine_cells(const Normalized_points& points, std::size_t maximum_cells,
                             Concurrency concurrency, const Progress& progress)
{
  if(points.size() > maximum_cells) {
    const Occupied_cells occupied = occupied_cells(points, maximum_cells, concurrency, progress);
    return {occupied.grid(), occupied.cells().cells()};
  }
  Fine_cells result; // one for every point: there is no need to know which are the same
  result.cells.resize(points.size());
  const Cell_of_point cell_of(result.grid);
  parallel_for(concurrency, points.number_of_blocks(), [&](std::size_t b) {
    std::size_t i = b * Point_source::block_size;
    for(const Vector3& p : points.block(b))
      result.cells[i++] = packed(cell_of(p));
  });
  return result;
}

/// The cells that `around` finds around packed ones; of more than `most` some may be missing.
inline Cell_set cells_around(const std::vector<std::uint64_t>& cells, const Cell_around& around,
                             std::size_t most, Concurrency concurrency)
{
  constexpr std::size_t block = 1 << 10;
  return parallel_sum(
    concurrency, (cells.size() + block - 1) / block, Cell_set(), [&](std::size_t b, Cell_set& found) {
      const std::size_t end = std::min(cells.size(), (b + 1) * block);
      for(std::size_t i = b * block; i < end && found.size() <= most; ++i)
        found.insert(around(unpacked(cells[i])));
    });
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MIXTURE_OCCUPIED_CELLS_H
