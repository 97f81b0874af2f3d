// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_GRID_MOMENTS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_GRID_MOMENTS_H

#include <CGAL/Point_set_skeletonization_3/internal/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/parallel_for.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// How fine the grid of the patches is.
struct Grid_options
{
  /// Points a patch should hold on average: fewer make its normal noise, more lose thin limbs.
  double points_per_patch = 4;

  /// The cost of all that follows depends on the patches only, so their number is bounded.
  std::size_t maximum_patches = 6000;

  /// A cloud this small is all detail: every patch is kept.
  std::size_t minimum_patches = 400;

  /// Fine cells outnumber patches by far, so that widths can be chosen in small steps.
  std::size_t maximum_fine_cells() const { return 32 * maximum_patches; }

  std::size_t patches(std::size_t points) const
  {
    const auto wanted = static_cast<std::size_t>(static_cast<double>(points) / points_per_patch);
    return std::min(std::max(wanted, minimum_patches), maximum_patches);
  }

  void check() const
  {
    CGAL_precondition(points_per_patch >= 1);
    // The eight cells around the origin stay apart however wide they are.
    CGAL_precondition(minimum_patches >= 8 && minimum_patches <= maximum_patches);
  }
};

/// A cubic grid of cells that hold the exact moments of their points.
///
/// The grid starts very fine and is halved in resolution whenever it holds more than a bounded
/// number of cells; so one pass over the points suffices, in bounded memory, and which resolution
/// remains depends on the set of points only, not on their order.
class Moment_grid
{
public:
  using Cell = std::array<std::int32_t, 3>;

  explicit Moment_grid(std::size_t maximum_cells) : maximum_cells_(maximum_cells) {}

  /// Edge length of a cell, a power of two, in units of the bounding box diagonal.
  double cell_size() const { return std::ldexp(1.0, -level_); }

  static Cell cell_of(const Vector3& p, double cell_size)
  {
    Cell cell;
    for(int k = 0; k < 3; ++k)
      cell[static_cast<std::size_t>(k)] = static_cast<std::int32_t>(std::floor(p[k] / cell_size));
    return cell;
  }

  void add(const Vector3& p)
  {
    const Cell cell = cell_of(p, cell_size());
    entry(cell).add(1, p);
    while(cells_.size() > maximum_cells_)
      coarsen();
  }

  void add(Moment_grid other)
  {
    while(other.level_ > level_)
      other.coarsen();
    while(level_ > other.level_)
      coarsen();
    for(const auto& item : other.sorted())
      entry(item.first).add(item.second);
    while(cells_.size() > maximum_cells_)
      coarsen();
  }

  /// Cells and their Gaussians, in lexicographic order.
  std::vector<std::pair<Cell, Gaussian>> sorted() const
  {
    std::vector<std::pair<Cell, Gaussian>> result;
    result.reserve(cells_.size());
    for(const auto& item : cells_)
      result.emplace_back(item.first, item.second.gaussian());
    std::sort(result.begin(), result.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
    return result;
  }

private:
  struct Hash
  {
    std::size_t operator()(const Cell& c) const
    {
      std::uint64_t h = 0;
      for(std::int32_t i : c)
        h = (h ^ static_cast<std::uint32_t>(i)) * 0x9E3779B97F4A7C15u;
      return static_cast<std::size_t>(h ^ (h >> 29));
    }
  };

  Moments& entry(const Cell& cell)
  {
    const auto found = cells_.find(cell);
    if(found != cells_.end())
      return found->second;
    const Vector3 corner(cell[0], cell[1], cell[2]);
    return cells_.emplace(cell, Moments((corner + Vector3::Constant(0.5)) * cell_size()))
      .first->second;
  }

  void coarsen()
  {
    const auto fine = sorted(); // an order of its own, so that sums do not depend on the hash table
    cells_.clear();
    --level_;
    for(const auto& item : fine) {
      Cell cell = item.first;
      for(std::int32_t& i : cell)
        i = (i - (i < 0 ? 1 : 0)) / 2; // floor(i / 2)
      entry(cell).add(item.second);
    }
  }

  std::size_t maximum_cells_;
  // 1/4096 of the diagonal: finer than any patch, and cell indices stay far from overflow.
  int level_ = 12;
  std::unordered_map<Cell, Moments, Hash> cells_;
};

/// Points are added to grids in blocks of this number, and the grids of the blocks in order: so sums
/// are the same to the last bit for any number of threads and any chunks of a stream.
constexpr std::size_t block_size = 1 << 18;

/// Moments of points that come one after the other; the same bits as `fine_grid()` of all of them.
class Moment_stream
{
public:
  explicit Moment_stream(std::size_t maximum_cells)
    : maximum_cells_(maximum_cells), blocks_(maximum_cells), block_(maximum_cells)
  {}

  std::size_t size() const { return size_; }

  void add(const Vector3& p)
  {
    block_.add(p);
    ++size_;
    if(++size_of_block_ < block_size)
      return;
    blocks_.add(std::exchange(block_, Moment_grid(maximum_cells_)));
    size_of_block_ = 0;
  }

  void add(const Moment_stream& other)
  {
    blocks_.add(other.grid());
    size_ += other.size_;
  }

  Moment_grid grid() const
  {
    Moment_grid result = blocks_;
    result.add(block_);
    return result;
  }

private:
  std::size_t maximum_cells_;
  std::size_t size_ = 0;
  std::size_t size_of_block_ = 0;
  Moment_grid blocks_;
  Moment_grid block_; ///< Of the points since the last full block.
};

/// Moments of `points` in a fine grid.
template <typename ConcurrencyTag>
Moment_grid fine_grid(const std::vector<Vector3>& points, std::size_t maximum_cells)
{
  std::vector<Moment_grid> blocks((points.size() + block_size - 1) / block_size,
                                  Moment_grid(maximum_cells));
  parallel_for<ConcurrencyTag>(blocks.size(), [&](std::size_t b) {
    const std::size_t end = std::min(points.size(), (b + 1) * block_size);
    for(std::size_t i = b * block_size; i < end; ++i)
      blocks[b].add(points[i]);
  });
  Moment_grid result(maximum_cells);
  for(Moment_grid& block : blocks)
    result.add(std::move(block));
  return result;
}

/// The cells of a fine grid, from which all levels are merged.
struct Fine_cells
{
  Fine_cells() = default;
  explicit Fine_cells(const Moment_grid& grid) : cells(grid.sorted()), cell_size(grid.cell_size())
  {}

  /// A cell's weight is a number of points, and exact.
  std::size_t number_of_points() const
  {
    double sum = 0;
    for(const auto& cell : cells)
      sum += cell.second.weight;
    return static_cast<std::size_t>(sum);
  }

  std::vector<std::pair<Moment_grid::Cell, Gaussian>> cells; ///< In lexicographic order.
  double cell_size = 1; ///< In units of the bounding box diagonal.
};

/// A level of a grid mixture: what the cells hold and how large they are.
struct Grid_level
{
  using Cell = Moment_grid::Cell;

  Gaussians gaussians;
  std::vector<Cell> cells; ///< Of every Gaussian; ascending.
  double fine_cell_size = 0;
  std::int32_t factor = 1; ///< Cells are that many times wider than the fine ones.

  /// Edge length of a cell, in units of the bounding box diagonal.
  double cell_size() const { return fine_cell_size * factor; }

  /// The cell of this level that holds a fine one: rounds towards minus infinity.
  static Cell merged(Cell fine, std::int32_t factor)
  {
    for(std::int32_t& c : fine)
      c = c >= 0 ? c / factor : -((-c + factor - 1) / factor);
    return fine;
  }

  /// Index of the Gaussian that holds the moments of `p`. \pre `p` is one of the points
  std::size_t cell_index(const Vector3& p) const
  {
    const Cell cell = merged(Moment_grid::cell_of(p, fine_cell_size), factor);
    return static_cast<std::size_t>(std::lower_bound(cells.begin(), cells.end(), cell) -
                                    cells.begin());
  }
};

/// The cells of `fine` merged into cells `factor` times as wide; merging moments is exact.
inline Grid_level merged_cells(const Fine_cells& grid, std::int32_t factor)
{
  const auto& fine = grid.cells;
  std::vector<std::pair<Moment_grid::Cell, std::size_t>> order;
  order.reserve(fine.size());
  for(std::size_t i = 0; i < fine.size(); ++i)
    order.emplace_back(Grid_level::merged(fine[i].first, factor), i);
  std::sort(order.begin(), order.end());

  Grid_level level;
  level.fine_cell_size = grid.cell_size;
  level.factor = factor;
  for(std::size_t begin = 0, end; begin < order.size(); begin = end) {
    Moments moments(fine[order[begin].second].second.mean);
    for(end = begin; end < order.size() && order[end].first == order[begin].first; ++end)
      moments.add(fine[order[end].second].second);
    level.cells.push_back(order[begin].first);
    level.gaussians.push_back(moments.gaussian());
  }
  return level;
}

/// The mixture whose components are the occupied cells of a grid, with the exact moments of their
/// points; the first level is the finest grid with at most `options.patches()` cells, every next one
/// has cells twice as wide.
inline std::vector<Grid_level> grid_levels(const Fine_cells& fine, const Grid_options& options,
                                           std::size_t number_of_levels)
{
  std::vector<Grid_level> levels;
  if(fine.cells.empty())
    return levels;

  const std::size_t wanted = options.patches(fine.number_of_points());
  std::int32_t factor = 1;
  Grid_level level = merged_cells(fine, factor);
  while(level.gaussians.size() > wanted) {
    // Occupied cells of a surface fall with the square of their width: step towards the aim, by
    // at least one and never past it.
    const double excess = std::sqrt(static_cast<double>(level.gaussians.size()) /
                                    static_cast<double>(wanted));
    factor = std::max(factor + 1, static_cast<std::int32_t>(factor * std::sqrt(excess)));
    level = merged_cells(fine, factor);
  }
  levels.push_back(std::move(level));
  while(levels.size() < number_of_levels) {
    factor *= 2;
    levels.push_back(merged_cells(fine, factor));
  }
  return levels;
}

/// The mixture of `points`: see `grid_levels()`.
template <typename ConcurrencyTag>
std::vector<Grid_level> grid_moments(const std::vector<Vector3>& points,
                                     const Grid_options& options, std::size_t number_of_levels)
{
  options.check();
  const Fine_cells fine(fine_grid<ConcurrencyTag>(points, options.maximum_fine_cells()));
  return grid_levels(fine, options, number_of_levels);
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_GRID_MOMENTS_H
