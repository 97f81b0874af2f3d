// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MIXTURE_CUBIC_GRID_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MIXTURE_CUBIC_GRID_H

#include <CGAL/Point_set_skeletonization_3/internal/mixture/Lattice_point.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// A cell of a cubic grid around the origin: its lower corner in units of its edge length.
using Grid_cell = std::array<std::int32_t, 3>;

/// Bits of a cell coordinate: normalised coordinates are between -1 and 1, and no cells are narrower
/// than 1/65536. Their neighbours still differ in single precision, which searches use.
constexpr int finest_level_of_all = 16;
constexpr int axis_bits = finest_level_of_all + 2;

/// The level of the finest cells, if at most `maximum_cells` are wanted: 12 for fewer than 2^20,
/// where no patch is narrower; with each doubling one more, as along thin limbs.
inline int finest_level(std::size_t maximum_cells)
{
  int level = 12;
  for(std::size_t cells = std::size_t(1) << 20;
      cells <= maximum_cells + 1 && level < finest_level_of_all; cells *= 2)
    ++level;
  return level;
}

/// Returns a cell as a number; the order is lexicographic.
inline std::uint64_t packed(const Grid_cell& cell)
{
  std::uint64_t result = 0;
  for(std::int32_t i : cell)
    result = result << axis_bits | static_cast<std::uint64_t>(i + (1 << (axis_bits - 1)));
  return result;
}

/// The inverse of `packed()`.
inline Grid_cell unpacked(std::uint64_t code)
{
  Grid_cell cell;
  for(std::size_t k = 3; k-- > 0; code >>= axis_bits)
    cell[k] = static_cast<std::int32_t>(code & ((1 << axis_bits) - 1)) - (1 << (axis_bits - 1));
  return cell;
}

/// Returns the greatest integer <= `x`; std::floor() would be a function call.
inline std::int32_t rounded_down(double x)
{
  const auto truncated = static_cast<std::int32_t>(x);
  return truncated - (x < truncated ? 1 : 0);
}

/// Maps a cell to the cell, `factor` times as wide, that contains it. The half keeps the quotient
/// away from integers, so that it is rounded like an integer division.
class Cell_around
{
public:
  explicit Cell_around(std::int32_t factor) : inverse_(1.0 / factor) {}

  Grid_cell operator()(const Grid_cell& cell) const
  {
    return {{around(cell[0]), around(cell[1]), around(cell[2])}};
  }

private:
  std::int32_t around(std::int32_t place) const { return rounded_down((place + 0.5) * inverse_); }

  double inverse_;
};

/// A cubic grid around the origin with cells of edge length `factor` times 2^-level.
struct Cubic_grid
{
  int level = finest_level_of_all;
  std::int32_t factor = 1;

  /// Edge length of a cell, in units of the bounding box diagonal.
  double cell_size() const { return static_cast<double>(factor) / (1 << level); }

  /// The grid with cells `by` times as wide.
  Cubic_grid coarsened(std::int32_t by) const { return {level, factor * by}; }

  /// Maps cells of a grid that is as fine or finer to the cells of this grid that contain them.
  Cell_around around(const Cubic_grid& fine) const
  {
    return Cell_around((factor << (fine.level - level)) / fine.factor);
  }
};

/// Maps a point to the cell of a grid that contains it.
class Cell_of_point
{
public:
  explicit Cell_of_point(const Cubic_grid& grid)
    : shift_(lattice_level - grid.level), around_(grid.factor)
  {}

  Grid_cell operator()(const Lattice_point& p) const
  {
    return around_({{rounded_down(p[0]), rounded_down(p[1]), rounded_down(p[2])}});
  }

private:
  /// Shifts keep the sign, on all machines; C++20 says so as well.
  std::int32_t rounded_down(std::int64_t x) const
  {
    return static_cast<std::int32_t>(x >> shift_);
  }

  int shift_;
  Cell_around around_;
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MIXTURE_CUBIC_GRID_H
