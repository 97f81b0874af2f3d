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
#include <CGAL/Point_set_skeletonization_3/internal/mixture/Lattice_point.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// The cells that points occupy, in a grid that becomes coarser as points are added. It bounds the
/// number of blocks of cells, not of cells: so points may be read at a level up to two finer than
/// the one wanted, which is determined in the end.
class Occupied_cells
{
public:
  /// Without points, starting at `level`.
  Occupied_cells(int level, std::size_t maximum_blocks)
    : maximum_blocks_(maximum_blocks), grid_{level, 1}
  {}

  const Cubic_grid& grid() const { return grid_; }
  const Cell_set& cells() const { return cells_; }

  /// Adds points. O(points) amortised.
  void add(const Point_block& points)
  {
    cells_.insert(points.size(),
                  [&](std::size_t k) { return cell_of_(lattice_point(points[k])); });
    limit();
  }

  /// Adds the cells of other points. O(blocks).
  void add(Occupied_cells other)
  {
    while(grid_.level > other.grid_.level)
      coarsen();
    while(other.grid_.level > grid_.level)
      other.coarsen();
    cells_.add(std::move(other.cells_));
    limit();
  }

  /// Doubles the width of the cells. O(blocks).
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

/// Estimates the coarsest level with more than `maximum_cells` of a cloud, from some points of at
/// most 512 blocks: the points of a block may be close to each other. O(1).
inline int probable_level(const Normalized_points& points, std::size_t maximum_cells)
{
  constexpr int coarse_level = 8; // far coarser than the result
  constexpr std::size_t blocks = 512;
  constexpr std::size_t points_of_block = 32;
  constexpr double points_of_cell = 8; // on average, so that hardly any cell is missed
  constexpr double certainly = 1.25; // a level too coarse costs a second pass, one too fine little
  Occupied_cells some(coarse_level, maximum_cells);
  const std::size_t step = 1 + points.number_of_blocks() / blocks;
  double size = 0;
  for(std::size_t b = 0; b < points.number_of_blocks(); b += step) {
    const Point_block all = points.block(b).points;
    Point_block few;
    for(std::size_t k = 0; k < all.size(); k += Point_source::block_size / points_of_block)
      few.push_back(all[k]);
    some.add(few);
    size += static_cast<double>(few.size());
  }
  while(points_of_cell * static_cast<double>(some.cells().size()) > size)
    some.coarsen();
  int level = some.grid().level;
  const auto points_of_cloud = static_cast<double>(points.bulk_size());
  const double many = certainly * static_cast<double>(maximum_cells);
  // A surface has four times as many cells at the next level; random points miss some of them.
  double cells = static_cast<double>(some.cells().size());
  while(level < finest_level(maximum_cells) &&
        cells * (1 - std::exp(-points_of_cloud / cells)) <= many) {
    cells *= 4;
    ++level;
  }
  return level;
}

/// Returns the occupied cells of a cloud, read at `level` and coarsened to at most `maximum_cells`.
/// O(points).
inline Occupied_cells occupied_cells(const Normalized_points& points, int level,
                                     std::size_t maximum_cells, Concurrency concurrency,
                                     const Progress& progress)
{
  Occupied_cells result = parallel_sum(
    concurrency, points.number_of_blocks(), Occupied_cells(level, maximum_cells),
    [&](std::size_t b, Occupied_cells& cells) {
      cells.add(points.block(b).points);
    },
    progress);
  while(result.cells().size() > maximum_cells)
    result.coarsen();
  return result;
}

/// Returns the occupied cells of a cloud in the finest cubic grid with at most `maximum_cells`.
/// Reads the cloud again with finer cells if the estimated level was too coarse. O(points).
inline Occupied_cells occupied_cells(const Normalized_points& points, std::size_t maximum_cells,
                                     Concurrency concurrency, const Progress& progress)
{
  const int finest = finest_level(maximum_cells);
  int level = finest;
  if(points.bulk_size() > maximum_cells)
    level = probable_level(points, maximum_cells);
  for(;; ++level) {
    Occupied_cells result = occupied_cells(points, level, maximum_cells, concurrency, progress);
    if(level == finest || result.grid().level < level) // else a finer grid might do
      return result;
  }
}

/// Cells of a fine grid, packed, unordered, perhaps with duplicates.
struct Fine_cells
{
  Cubic_grid grid;
  std::vector<std::uint64_t> cells;
};

/// Returns the occupied cells of a cloud in the finest cubic grid with at most `maximum_cells`; if
/// there are not more points, one cell per point in the finest grid. O(points).
inline Fine_cells fine_cells(const Normalized_points& points, std::size_t maximum_cells,
                             Concurrency concurrency, const Progress& progress)
{
  if(points.bulk_size() > maximum_cells) {
    const Occupied_cells occupied = occupied_cells(points, maximum_cells, concurrency, progress);
    return {occupied.grid(), occupied.cells().cells()};
  }
  Fine_cells result{{finest_level(maximum_cells), 1}, {}}; // one per point, with duplicates
  constexpr std::uint64_t no_cell = ~std::uint64_t(0); // of a point far away
  result.cells.resize(points.size(), no_cell);
  const Cell_of_point cell_of(result.grid);
  parallel_for(concurrency, points.number_of_blocks(), [&](std::size_t b) {
    points.visit_block(b, [&](std::size_t i, const Vector3& p) {
      result.cells[i] = packed(cell_of(lattice_point(p)));
    });
  });
  result.cells.erase(std::remove(result.cells.begin(), result.cells.end(), no_cell),
                     result.cells.end());
  return result;
}

/// Returns the cells that contain packed ones; incomplete if there are more than `most`. O(cells).
inline Cell_set cells_around(const std::vector<std::uint64_t>& cells, const Cell_around& around,
                             std::size_t most, Concurrency concurrency)
{
  constexpr std::size_t block = 1 << 10;
  return parallel_sum(concurrency, (cells.size() + block - 1) / block, Cell_set(),
                      [&](std::size_t b, Cell_set& found) {
                        const std::size_t end = (std::min)(cells.size(), (b + 1) * block);
                        if(found.size() <= most)
                          found.insert(end - b * block, [&](std::size_t k) {
                            return around(unpacked(cells[b * block + k]));
                          });
                      });
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MIXTURE_OCCUPIED_CELLS_H
