// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MIXTURE_GRID_MIXTURE_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MIXTURE_GRID_MIXTURE_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Normalized_points.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Progress.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/mixture/Cell_set.h>
#include <CGAL/Point_set_skeletonization_3/internal/mixture/Cubic_grid.h>
#include <CGAL/Point_set_skeletonization_3/internal/mixture/Exact_moments.h>
#include <CGAL/Point_set_skeletonization_3/internal/mixture/Lattice_point.h>
#include <CGAL/Point_set_skeletonization_3/internal/mixture/Moment_grid.h>
#include <CGAL/Point_set_skeletonization_3/internal/mixture/Occupied_cells.h>

#include <CGAL/assertions.h>

#include <boost/interprocess/anonymous_shared_memory.hpp>
#include <boost/interprocess/mapped_region.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <thread>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Options of stage 1: how fine the grid is.
struct Grid_options
{
  /// Average number of points of a cell, >= 1: fewer make the grid of noisy points slow, more lose
  /// thin limbs.
  double points_per_cell = 2;

  /// Greatest number of cells. Bounds memory, about 1 kB a cell, and running time.
  std::size_t maximum_cells = default_maximum_cells;
  static constexpr std::size_t default_maximum_cells = std::size_t(1) << 17;

  /// Thickness of the thinnest limb that must be found, in normalised coordinates, >= 0. Cells are
  /// coarser if the points allow finer ones than that takes. 0: as thin as the points allow.
  double smallest_feature = 0;

  /// How many cells thick a limb must be to be found. Two are enough for limbs that are far apart,
  /// in the trees of `quality detail`. The shapes of `quality generated`, where gaps are half as
  /// wide as limbs are thick, keep loops and parts with three, as with finer cells, not with 2.5.
  static constexpr double cells_across_limb = 3;

  /// Number of cells, at least 8, up to which detail is worth more than smoothness: a cloud too
  /// small for that many has cells of fewer points, but of no fewer than `least_points_per_cell`.
  /// Of scanned trees with 5000 points 79 % are found with 1500, 90 % with this; closed shapes of
  /// 3000 and 5000 points are right about as often, and nearer to their axes.
  std::size_t minimum_cells = 4000;

  /// Three cells for four points. With one cell for each point, noise cannot be told from shape: at
  /// 2000 points, 70 % of the shapes of `quality generated` are right with it, 88 % with this.
  static constexpr double least_points_per_cell = 4. / 3;

  /// Greatest number of cells of the grid that is read first: four times as many as are wanted, so
  /// that widths can be chosen in small steps. Less one: tables double when they are full.
  std::size_t maximum_fine_cells() const { return 4 * maximum_cells - 1; }

  /// The options for a grid that has been read with this bound.
  static Grid_options of_fine_cells(std::size_t maximum_fine_cells)
  {
    Grid_options options;
    options.maximum_cells = (maximum_fine_cells + 1) / 4;
    return options;
  }

  /// Greatest number of cells of a cloud.
  std::size_t cells(std::size_t points) const
  {
    const auto cells_of = [&](double points_of_a_cell) {
      return static_cast<std::size_t>(static_cast<double>(points) / points_of_a_cell);
    };
    const std::size_t most = (std::max)(cells_of(least_points_per_cell), std::size_t(8));
    const std::size_t least = (std::min)(most, minimum_cells);
    return (std::min)((std::max)(cells_of(points_per_cell), least), maximum_cells);
  }

  /// Sets the bound that a user asks for, >= 1000: fewer save nothing.
  void limit_cells(std::size_t most)
  {
    CGAL_precondition(most >= 1000);
    maximum_cells = most;
    check();
  }

  /// Checks all ranges.
  void check() const
  {
    CGAL_precondition(points_per_cell >= 1);
    CGAL_precondition(smallest_feature >= 0);
    // The eight cells around the origin are never merged.
    CGAL_precondition(minimum_cells >= 8 && maximum_cells >= 8);
    // Indices of cells have 32 bits, and so do those of pairs of adjacent patches.
    CGAL_precondition(maximum_cells <= std::size_t(1) << 26);
  }
};

/// A level of a grid mixture: its cells, ascending, and the moments of their points.
struct Grid_level
{
  Cubic_grid grid;
  Moment_cells cells;

  /// One Gaussian per cell, in normalised coordinates. O(cells).
  Gaussians gaussians(Concurrency concurrency = Concurrency::sequential) const
  {
    Gaussians result(cells.size());
    parallel_for(concurrency, result.size(),
                 [&](std::size_t i) { result[i] = cells.moments()[i].gaussian(); });
    return result;
  }
};

/// Returns a level with these cells and no points. O(cells log cells).
inline Grid_level empty_level(const Cubic_grid& grid, const Cell_set& set)
{
  std::vector<std::uint64_t> cells = set.cells();
  std::sort(cells.begin(), cells.end());
  return {grid, Moment_cells(cells)};
}

/// Returns how many cells are wanted of a cloud, whose cells in a fine grid are given: as many as
/// the points allow, but no more than there are of the width that the smallest feature takes.
/// `minimum_cells` cost next to no time, so there may be as many in any case. O(cells).
inline std::size_t wanted_cells(const std::vector<std::uint64_t>& cells, const Cubic_grid& fine,
                                std::size_t points, const Grid_options& options,
                                Concurrency concurrency)
{
  const std::size_t most = options.cells(points);
  constexpr double widest = 1; // no cloud is longer than its diagonal
  const double width =
    (std::min)(options.smallest_feature / Grid_options::cells_across_limb, widest);
  const auto factor = static_cast<std::int32_t>(width / fine.cell_size());
  if(factor <= 1)
    return most;
  const std::size_t enough = cells_around(cells, Cell_around(factor), most, concurrency).size();
  return std::clamp(enough, (std::min)(options.minimum_cells, most), most);
}

/// Returns the finest level with at most `wanted` cells that contain the given cells of `fine`,
/// without moments. Binary search over the width: O(cells) per step.
inline Grid_level patch_level(const std::vector<std::uint64_t>& cells, const Cubic_grid& fine,
                              std::size_t wanted, Concurrency concurrency)
{
  Cell_set found; // so far
  const auto are_few = [&](std::int32_t factor) {
    Cell_set around = cells_around(cells, Cell_around(factor), wanted, concurrency);
    if(around.size() > wanted)
      return false;
    found = std::move(around);
    return true;
  };
  // First the least power of two, for which the number of cells is monotonic: these grids are
  // nested. The search starts at the width for a surface with the area of the squared diagonal.
  std::int32_t wide = 1;
  while(std::ldexp(1, fine.level) > wide * std::sqrt(static_cast<double>(wanted)))
    wide *= 2;
  if(are_few(wide))
    while(wide > 1 && are_few(wide / 2))
      wide /= 2;
  else
    do
      wide *= 2;
    while(!are_few(wide));
  std::int32_t narrow = wide / 2;
  while(wide - narrow > 1) {
    const std::int32_t middle = (narrow + wide) / 2;
    (are_few(middle) ? wide : narrow) = middle;
  }
  return empty_level(fine.coarsened(wide), found);
}

/// Returns the level of `grid` with the moments of the cells of a finer grid. O(cells log cells).
inline Grid_level coarser_level(const Cubic_grid& grid, const Moment_cells& cells,
                                const Cubic_grid& fine)
{
  Grid_level result = empty_level(
    grid, cells_around(cells.cells(), grid.around(fine), cells.size(), Concurrency::sequential));
  result.cells.add(cells, grid.around(fine));
  return result;
}

/// The cell index of each point, of two bytes if that is enough, in chunks whose memory can be
/// returned to the system one after the other; the heap might keep it.
class Cells_of_points
{
public:
  Cells_of_points() = default;

  /// For indices up to `greatest`.
  Cells_of_points(std::size_t size, std::size_t greatest)
    : size_(size),
      are_small_(greatest <= (std::numeric_limits<std::uint16_t>::max)())
  {
    const std::size_t bytes = are_small_ ? sizeof(std::uint16_t) : sizeof(std::uint32_t);
    for(std::size_t first = 0; first < size; first += chunk_size)
      chunks_.push_back(boost::interprocess::anonymous_shared_memory(
        bytes * (std::min)(chunk_size, size - first)));
  }

  std::size_t size() const { return size_; }

  std::size_t operator[](std::size_t p) const
  {
    return are_small_ ? place_of<std::uint16_t>(p) : place_of<std::uint32_t>(p);
  }

  /// May be called concurrently for different points.
  void set(std::size_t p, std::size_t cell)
  {
    if(are_small_)
      place_of<std::uint16_t>(p) = static_cast<std::uint16_t>(cell);
    else
      place_of<std::uint32_t>(p) = static_cast<std::uint32_t>(cell);
  }

  /// Returns the memory of points below `end`, which must not be accessed any more.
  void forget_below(std::size_t end)
  {
    for(std::size_t c = 0; c < end / chunk_size; ++c)
      chunks_[c] = boost::interprocess::mapped_region();
  }

private:
  static constexpr std::size_t chunk_size = 1 << 20;

  template <typename Index>
  Index& place_of(std::size_t p) const
  {
    return static_cast<Index*>(chunks_[p / chunk_size].get_address())[p % chunk_size];
  }

  std::size_t size_ = 0;
  bool are_small_ = false;
  std::vector<boost::interprocess::mapped_region> chunks_;
};

/// Adds points to cells from several threads. Sums are exact: their order does not matter.
class Concurrent_cells
{
public:
  /// Refers to the cells.
  Concurrent_cells(Moment_cells& cells, Concurrency concurrency)
    : cells_(cells), is_taken_(concurrency == Concurrency::parallel ? cells.size() : 0)
  {}

  /// Adds a point to the cell with this index. O(1).
  void add(std::size_t number, const Lattice_point& p)
  {
    if(is_taken_.empty()) {
      cells_.add(number, p);
      return;
    }
    while(is_taken_[number].exchange(true, std::memory_order_acquire))
      std::this_thread::yield(); // rare: threads are at different places of the cloud
    cells_.add(number, p);
    is_taken_[number].store(false, std::memory_order_release);
  }

private:
  Moment_cells& cells_;
  std::vector<std::atomic<bool>> is_taken_; ///< Each cell, by a thread; empty for a single one.
};

/// Adds the points to the cells of `level`, and returns the cell of each point; for one far away
/// the number of cells. O(points).
inline Cells_of_points add_points(const Normalized_points& points, Grid_level& level,
                                  Concurrency concurrency, const Progress& progress)
{
  Cells_of_points cell_of_point(points.size(), level.cells.size());
  if(points.number_of_far > 0)
    for(std::size_t i = 0; i < points.size(); ++i)
      cell_of_point.set(i, level.cells.size());
  const Cell_of_point cell_of(level.grid);
  Concurrent_cells cells(level.cells, concurrency);
  points.visit_blocks(
    [&](std::size_t b) {
      const Normalized_points::Block block = points.block(b);
      std::array<Lattice_point, Point_source::block_size> places;
      std::array<std::size_t, Point_source::block_size> numbers;
      for(std::size_t k = 0; k < block.points.size(); ++k) {
        places[k] = lattice_point(block.points[k]);
        numbers[k] = level.cells.number(cell_of(places[k]));
        level.cells.prefetch(numbers[k]); // the moments are larger than the cache
        cell_of_point.set(block.numbers[k], numbers[k]);
      }
      for(std::size_t k = 0; k < block.points.size(); ++k)
        cells.add(numbers[k], places[k]);
    },
    concurrency, progress);
  return cell_of_point;
}

/// A mixture whose components are the occupied cells of a grid, with the exact moments of their
/// points.
struct Grid_mixture
{
  /// The first level is the finest grid with at most `wanted_cells()`; each further one
  /// has cells of twice the width. Empty without points.
  std::vector<Grid_level> levels;

  /// The cell of each point in the first level, or their number for one far away; empty for points
  /// from a builder.
  Cells_of_points cell_of_point;

  /// \pre there is a level
  void add_coarser_levels(std::size_t number_of_levels)
  {
    while(levels.size() < number_of_levels) {
      const Grid_level& fine = levels.back();
      levels.push_back(coarser_level(fine.grid.coarsened(2), fine.cells, fine.grid));
    }
  }
};

/// Stage 1: returns the mixture of `points`, which are read twice: for the width of the cells and
/// for their moments. O(points).
inline Grid_mixture grid_mixture(const Normalized_points& points, const Grid_options& options,
                                 std::size_t number_of_levels, Concurrency concurrency,
                                 const Progress& progress = Progress())
{
  options.check();
  Grid_mixture result;
  if(points.bulk_size() == 0)
    return result;
  const Fine_cells fine =
      fine_cells(points, options.maximum_fine_cells(), concurrency, progress.part(0, 0.5));
  const std::size_t wanted =
    wanted_cells(fine.cells, fine.grid, points.bulk_size(), options, concurrency);
  result.levels.push_back(patch_level(fine.cells, fine.grid, wanted, concurrency));
  result.cell_of_point =
      add_points(points, result.levels.front(), concurrency, progress.part(0.5, 1));
  result.add_coarser_levels(number_of_levels);
  return result;
}

/// The same for the moments of a builder, whose bound on the number of cells holds. O(cells) per
/// step of the search for the width.
inline Grid_mixture grid_mixture(const Moment_grid& fine, Grid_options options,
                                 std::size_t number_of_levels)
{
  options.maximum_cells = Grid_options::of_fine_cells(fine.maximum_cells()).maximum_cells;
  options.check();
  const std::size_t points = fine.size();
  Grid_mixture result;
  if(points == 0)
    return result;
  const std::vector<std::uint64_t>& cells = fine.cells().cells();
  const std::size_t wanted =
    wanted_cells(cells, fine.grid(), points, options, Concurrency::sequential);
  result.levels.push_back(patch_level(cells, fine.grid(), wanted, Concurrency::sequential));
  Grid_level& finest = result.levels.back();
  finest.cells.add(fine.cells(), finest.grid.around(fine.grid()));
  result.add_coarser_levels(number_of_levels);
  return result;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MIXTURE_GRID_MIXTURE_H
