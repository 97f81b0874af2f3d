// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_GRID_MOMENTS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_GRID_MOMENTS_H

#include <CGAL/Point_set_skeletonization_3/internal/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/Point_blocks.h>
#include <CGAL/Point_set_skeletonization_3/internal/parallel_for.h>
#include <CGAL/Point_set_skeletonization_3/internal/radix_sort.h>

#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>
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
    CGAL_precondition(maximum_patches <= 65535); // so is an index of 16 bits, which points keep
  }
};

/// A cell of a cubic grid around the origin, by its lower corner in units of its edge length.
using Grid_cell = std::array<std::int32_t, 3>;

/// Bits of a cell's place on an axis: normalised coordinates lie between -1 and 1, and the finest
/// cells are 1/4096 wide, which is finer than any patch.
constexpr int finest_level = 12;
constexpr int axis_bits = finest_level + 2;

/// The cell with `p` in it, of edge length 2^-level.
inline Grid_cell grid_cell_of(const Vector3& p, int level)
{
  Grid_cell cell;
  for(int k = 0; k < 3; ++k) {
    const double x = p[k] * (1 << level);
    const auto truncated = static_cast<std::int32_t>(x);
    cell[static_cast<std::size_t>(k)] = truncated - (x < truncated ? 1 : 0); // floor() is a call
  }
  return cell;
}

/// A cell as a number; the numbers are in lexicographic order.
inline std::uint64_t packed(const Grid_cell& cell)
{
  std::uint64_t result = 0;
  for(std::int32_t i : cell)
    result = result << axis_bits | static_cast<std::uint64_t>(i + (1 << (axis_bits - 1)));
  return result;
}

inline Grid_cell unpacked(std::uint64_t code)
{
  Grid_cell cell;
  for(std::size_t k = 3; k-- > 0; code >>= axis_bits)
    cell[k] = static_cast<std::int32_t>(code & ((1 << axis_bits) - 1)) - (1 << (axis_bits - 1));
  return cell;
}

/// The place of a cell on a Morton curve: three bits less make that of the cell around it that is
/// twice as wide. The bits of the three axes alternate.
inline std::uint64_t morton_code(const Grid_cell& cell)
{
  std::uint64_t result = 0;
  for(std::int32_t i : cell) {
    auto x = static_cast<std::uint64_t>(i + (1 << (axis_bits - 1)));
    x = (x | x << 16) & 0x001F0000FF0000FFu;
    x = (x | x << 8) & 0x100F00F00F00F00Fu;
    x = (x | x << 4) & 0x10C30C30C30C30C3u;
    x = (x | x << 2) & 0x1249249249249249u;
    result = result << 1 | x;
  }
  return result;
}

/// The cell of edge length 2^-level at a place on a Morton curve.
inline Grid_cell cell_of_morton_code(std::uint64_t code, int level)
{
  Grid_cell cell;
  for(std::size_t k = 3; k-- > 0; code >>= 1) {
    std::uint64_t x = code & 0x1249249249249249u;
    x = (x | x >> 2) & 0x10C30C30C30C30C3u;
    x = (x | x >> 4) & 0x100F00F00F00F00Fu;
    x = (x | x >> 8) & 0x001F0000FF0000FFu;
    x = (x | x >> 16) & 0xFFFFu;
    cell[k] = static_cast<std::int32_t>(x) - (1 << (axis_bits - 1 + level - finest_level));
  }
  return cell;
}

/// A key with the index of what it belongs to, so that sorting keys sorts indices; the key of a cell
/// leaves 22 bits.
constexpr int index_bits = 64 - 3 * axis_bits;

inline std::uint64_t with_index(std::uint64_t key, std::size_t index)
{
  return key << index_bits | index;
}

inline std::size_t index_of(std::uint64_t key_with_index)
{
  return key_with_index & ((std::uint64_t(1) << index_bits) - 1);
}

/// How many different numbers the sorted keys without their last bits are. \pre there is a key
inline std::size_t number_of_different(const std::vector<std::uint64_t>& keys, int bits)
{
  std::size_t result = 1;
  for(std::size_t k = 1; k < keys.size(); ++k)
    result += keys[k - 1] >> bits != keys[k] >> bits ? 1 : 0;
  return result;
}

/// A level of a grid mixture: what the cells hold and how large they are.
struct Grid_level
{
  Gaussians gaussians;
  std::vector<std::uint64_t> cells; ///< Of every Gaussian, packed; ascending if merged.
  int fine_level = 0;               ///< The grid was made with cells 2^-fine_level wide, ...
  std::int32_t factor = 1;          ///< ... these are that many times wider.

  /// Edge length of a cell, in units of the bounding box diagonal.
  double cell_size() const { return std::ldexp(1.0, -fine_level) * factor; }

  /// The cell that holds a cell, `factor` times as wide: rounds towards minus infinity.
  static Grid_cell merged(Grid_cell cell, std::int32_t factor)
  {
    for(std::int32_t& c : cell)
      c = c >= 0 ? c / factor : -((-c + factor - 1) / factor);
    return cell;
  }

  /// Index of the Gaussian that holds the moments of `p`. \pre `p` is one of the points
  std::size_t cell_index(const Vector3& p) const
  {
    const std::uint64_t cell = packed(merged(grid_cell_of(p, fine_level), factor));
    return static_cast<std::size_t>(std::lower_bound(cells.begin(), cells.end(), cell) -
                                    cells.begin());
  }
};

/// A cubic grid of cells that hold the exact moments of their points.
///
/// Its resolution is the finest at which it holds no more than a bounded number of cells, and so
/// depends on the set of points only. Grids of parts of the points add up to the grid of all.
class Moment_grid
{
public:
  explicit Moment_grid(std::size_t maximum_cells) : maximum_cells_(maximum_cells) {}

  /// The grid of a block of points. \pre `0 < size < 2^index_bits`
  Moment_grid(const Vector3* points, std::size_t size, std::size_t maximum_cells)
    : maximum_cells_(maximum_cells)
  {
    std::vector<std::uint64_t> keys;
    keys.reserve(size);
    for(std::size_t i = 0; i < size; ++i)
      keys.push_back(with_index(morton_code(grid_cell_of(points[i], finest_level)), i));
    radix_sort(keys, index_bits);

    int bits = index_bits;
    while(level_ > 0 && number_of_different(keys, bits) > maximum_cells_) {
      bits += 3;
      --level_;
    }
    cells_.reserve(number_of_different(keys, bits));
    for(std::size_t k = 0; k < keys.size();) {
      const std::uint64_t code = keys[k] >> bits;
      Moments moments(points[index_of(keys[k])]);
      for(; k < keys.size() && keys[k] >> bits == code; ++k)
        moments.add(1, points[index_of(keys[k])]);
      cells_.push_back({code, moments.gaussian()});
    }
  }

  std::size_t size() const { return cells_.size(); }

  void add(Moment_grid other)
  {
    coarsen_to(other.level_);
    other.coarsen_to(level_);
    unite(other.cells_);
    while(level_ > 0 && size() > maximum_cells_)
      coarsen_to(level_ - 1);
  }

  /// Its cells, along a Morton curve.
  Grid_level level() const
  {
    Grid_level result;
    result.fine_level = level_;
    for(const Item& item : cells_) {
      result.cells.push_back(packed(cell_of_morton_code(item.code, level_)));
      result.gaussians.push_back(item.gaussian);
    }
    return result;
  }

private:
  struct Item
  {
    std::uint64_t code;
    Gaussian gaussian;
  };

  void coarsen_to(int level)
  {
    if(level < level_) {
      unite(3 * (level_ - level));
      level_ = level;
    }
  }

  /// Adds cells of the same level. No more memory than the union needs: of many points drawn at
  /// random all blocks have nearly the same cells.
  void unite(const std::vector<Item>& others)
  {
    std::size_t size = 0;
    for_each_cell(others, [&](const Item*, const Item*) { ++size; });
    std::vector<Item> both;
    both.reserve(size);
    for_each_cell(others, [&](const Item* mine, const Item* other) {
      both.push_back(mine != nullptr ? *mine : *other);
      if(mine == nullptr || other == nullptr)
        return;
      Moments moments(mine->gaussian.mean);
      moments.add(mine->gaussian);
      moments.add(other->gaussian);
      both.back().gaussian = moments.gaussian();
    });
    cells_.swap(both);
  }

  /// Calls `visit(mine, other)` for the cells of both in order, with a null for one that is missing.
  template <typename Visit>
  void for_each_cell(const std::vector<Item>& others, const Visit& visit) const
  {
    auto mine = cells_.begin();
    auto other = others.begin();
    while(mine != cells_.end() || other != others.end()) {
      const bool has_mine = other == others.end() ||
                            (mine != cells_.end() && mine->code <= other->code);
      const bool has_other = mine == cells_.end() ||
                             (other != others.end() && other->code <= mine->code);
      visit(has_mine ? &*mine : nullptr, has_other ? &*other : nullptr);
      mine += has_mine;
      other += has_other;
    }
  }

  /// Takes the last bits off the codes and makes one of the cells with the same code.
  void unite(int bits)
  {
    std::size_t united = 0;
    for(std::size_t k = 0; k < cells_.size();) {
      const std::uint64_t code = cells_[k].code >> bits;
      const std::size_t first = k++;
      Gaussian gaussian = cells_[first].gaussian;
      if(k < cells_.size() && cells_[k].code >> bits == code) {
        Moments moments(gaussian.mean);
        moments.add(gaussian);
        for(; k < cells_.size() && cells_[k].code >> bits == code; ++k)
          moments.add(cells_[k].gaussian);
        gaussian = moments.gaussian();
      }
      cells_[united++] = {code, gaussian};
    }
    cells_.resize(united);
  }

  std::size_t maximum_cells_;
  int level_ = finest_level;
  std::vector<Item> cells_; ///< Ascending.
};

/// Moments of points that come one after the other; the same bits as `fine_grid()` of all of them:
/// both add up the grids of the same blocks.
class Moment_stream
{
public:
  explicit Moment_stream(std::size_t maximum_cells)
    : maximum_cells_(maximum_cells), blocks_(maximum_cells)
  {}

  std::size_t size() const { return size_; }

  void add(const Vector3& p)
  {
    block_.push_back(p);
    ++size_;
    if(block_.size() < Point_blocks::block_size)
      return;
    blocks_.add(Moment_grid(block_.data(), block_.size(), maximum_cells_));
    block_.clear();
  }

  void add(const Moment_stream& other)
  {
    blocks_.add(other.grid());
    size_ += other.size_;
  }

  Moment_grid grid() const
  {
    Moment_grid result = blocks_;
    if(!block_.empty())
      result.add(Moment_grid(block_.data(), block_.size(), maximum_cells_));
    return result;
  }

private:
  std::size_t maximum_cells_;
  std::size_t size_ = 0;
  Moment_grid blocks_;
  std::vector<Vector3> block_; ///< Points since the last full block.
};

/// Moments of points in a fine grid. The grids of blocks are added in order: so sums are the same to
/// the last bit for any number of threads.
template <typename ConcurrencyTag>
Moment_grid fine_grid(const Point_blocks& points, std::size_t maximum_cells)
{
  // Blocks whose grids are in memory; to eight threads a block each.
  constexpr std::size_t at_once = std::is_convertible<ConcurrencyTag, Parallel_tag>::value ? 8 : 1;
  Moment_grid result(maximum_cells);
  for(std::size_t begin = 0; begin < points.number_of_blocks(); begin += at_once) {
    std::vector<Moment_grid> grids(std::min(at_once, points.number_of_blocks() - begin),
                                   Moment_grid(maximum_cells));
    parallel_for<ConcurrencyTag>(grids.size(), [&](std::size_t k) {
      const std::vector<Vector3> block = points.block(begin + k);
      grids[k] = Moment_grid(block.data(), block.size(), maximum_cells);
    });
    for(Moment_grid& grid : grids)
      result.add(std::move(grid));
  }
  return result;
}

/// The cells of a fine grid, from which all levels are merged.
struct Fine_cells
{
  explicit Fine_cells(const Moment_grid& grid) : level(grid.level()) {}

  /// A cell's weight is a number of points, and exact.
  std::size_t number_of_points() const
  {
    double sum = 0;
    for(const Gaussian& g : level.gaussians)
      sum += g.weight;
    return static_cast<std::size_t>(sum);
  }

  Grid_level level; ///< Its cells along a Morton curve.
};

/// The cells around those of `fine`, `factor` times as wide, with the indices of these; sorted.
inline std::vector<std::uint64_t> cells_around(const Grid_level& fine, std::int32_t factor)
{
  std::vector<std::uint64_t> result;
  result.reserve(fine.cells.size());
  for(std::uint64_t cell : fine.cells)
    result.push_back(
      with_index(packed(Grid_level::merged(unpacked(cell), factor)), result.size()));
  radix_sort(result, index_bits);
  return result;
}

/// The cells of `fine` merged into cells `factor` times as wide; merging moments is exact.
inline Grid_level merged_cells(const Grid_level& fine, std::int32_t factor)
{
  Grid_level level;
  level.fine_level = fine.fine_level;
  level.factor = fine.factor * factor;
  const std::vector<std::uint64_t> keys = cells_around(fine, factor);
  for(std::size_t k = 0; k < keys.size();) {
    const std::uint64_t cell = keys[k] >> index_bits;
    Moments moments(fine.gaussians[index_of(keys[k])].mean);
    for(; k < keys.size() && keys[k] >> index_bits == cell; ++k)
      moments.add(fine.gaussians[index_of(keys[k])]);
    level.cells.push_back(cell);
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
  std::size_t size = fine.level.cells.size();
  if(size == 0)
    return levels;

  const std::size_t wanted = options.patches(fine.number_of_points());
  std::int32_t factor = 1;
  while(size > wanted) {
    // Occupied cells of a surface fall with the square of their width: step towards the aim, by
    // at least one and never past it.
    const double excess = std::sqrt(static_cast<double>(size) / static_cast<double>(wanted));
    factor = std::max(factor + 1, static_cast<std::int32_t>(factor * std::sqrt(excess)));
    size = number_of_different(cells_around(fine.level, factor), index_bits);
  }
  levels.push_back(merged_cells(fine.level, factor));
  while(levels.size() < number_of_levels)
    levels.push_back(merged_cells(levels.back(), 2));
  return levels;
}

/// The mixture of `points`: see `grid_levels()`.
template <typename ConcurrencyTag>
std::vector<Grid_level> grid_moments(const Point_blocks& points, const Grid_options& options,
                                     std::size_t number_of_levels)
{
  options.check();
  const Fine_cells fine(fine_grid<ConcurrencyTag>(points, options.maximum_fine_cells()));
  return grid_levels(fine, options, number_of_levels);
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_GRID_MOMENTS_H
