// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CUBIC_GRID_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CUBIC_GRID_H

#include <CGAL/Point_set_skeletonization_3/internal/Gaussian.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// A cell of a cubic grid around the origin, by its lower corner in units of its edge length.
using Grid_cell = std::array<std::int32_t, 3>;

/// Bits of a cell's place on an axis: normalised coordinates lie between -1 and 1, and the finest
/// cells are 1/4096 wide, which is finer than any patch.
constexpr int finest_level = 12;
constexpr int axis_bits = finest_level + 2;

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

/// The greatest integer below; floor() is a call.
inline std::int32_t rounded_down(double x)
{
  const auto truncated = static_cast<std::int32_t>(x);
  return truncated - (x < truncated ? 1 : 0);
}

/// Finds the cell of a grid that holds a cell, `factor` times as narrow. The half keeps the quotient
/// off whole numbers, so that it rounds to the same one as that of integers.
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

/// A cubic grid around the origin, whose cells are `factor` cells of edge length 2^-level wide.
struct Cubic_grid
{
  int level = finest_level;
  std::int32_t factor = 1;

  /// Edge length of a cell, in units of the bounding box diagonal.
  double cell_size() const { return static_cast<double>(factor) / (1 << level); }

  /// The grid with cells `by` times as wide.
  Cubic_grid coarsened(std::int32_t by) const { return {level, factor * by}; }

  /// Finds the cells of this grid around those of one that is as fine or finer.
  Cell_around around(const Cubic_grid& fine) const
  {
    return Cell_around((factor << (fine.level - level)) / fine.factor);
  }

  Vector3 center(const Grid_cell& cell) const
  {
    return cell_size() * (Vector3(cell[0], cell[1], cell[2]) + Vector3::Constant(0.5));
  }
};

/// Finds the cell of a grid that holds a point.
class Cell_of_point
{
public:
  explicit Cell_of_point(const Cubic_grid& grid)
    : fine_cells_(1 << grid.level), around_(grid.factor)
  {}

  Grid_cell operator()(const Vector3& p) const
  {
    return around_({{rounded_down(p[0] * fine_cells_), rounded_down(p[1] * fine_cells_),
                     rounded_down(p[2] * fine_cells_)}});
  }

private:
  double fine_cells_; ///< To a unit of length.
  Cell_around around_;
};

/// Numbers cells in the order in which they come: a hash table with open addressing.
class Cell_index
{
public:
  Cell_index() = default;

  /// With room for `size` cells.
  explicit Cell_index(std::size_t size)
  {
    while(std::size_t(1) << (64 - shift_) <= 2 * size)
      --shift_;
    slots_.assign(std::size_t(1) << (64 - shift_), empty);
  }

  std::size_t size() const { return cells_.size(); }

  /// The number of a cell. \pre it was inserted
  std::size_t operator[](std::uint64_t cell) const { return slots_[slot_of(cell)] & number_mask; }

  /// Forgets all cells and keeps the room.
  void clear()
  {
    cells_.clear();
    std::fill(slots_.begin(), slots_.end(), empty);
  }

  /// The cells, packed, by their numbers.
  const std::vector<std::uint64_t>& cells() const { return cells_; }

  /// The number of a cell. A new one gets the next.
  std::size_t insert(std::uint64_t cell)
  {
    if(2 * size() >= slots_.size())
      grow();
    std::uint64_t& slot = slots_[slot_of(cell)];
    if(slot == empty) {
      slot = cell << number_bits | size();
      cells_.push_back(cell);
    }
    return slot & number_mask;
  }

private:
  static constexpr int number_bits = 64 - 3 * axis_bits; // what a packed cell leaves
  static constexpr std::uint64_t number_mask = (std::uint64_t(1) << number_bits) - 1;
  static constexpr std::uint64_t empty = ~std::uint64_t(0); // normalised coordinates stay below

  /// Where a cell is, or would be.
  std::size_t slot_of(std::uint64_t cell) const
  {
    std::size_t slot = cell * 0x9E3779B97F4A7C15u >> shift_; // by the golden ratio: Knuth
    while(slots_[slot] != empty && slots_[slot] >> number_bits != cell)
      slot = (slot + 1) & (slots_.size() - 1);
    return slot;
  }

  void grow()
  {
    --shift_;
    std::vector<std::uint64_t> old(std::size_t(1) << (64 - shift_), empty);
    old.swap(slots_);
    for(std::uint64_t slot : old)
      if(slot != empty)
        slots_[slot_of(slot >> number_bits)] = slot;
  }

  std::vector<std::uint64_t> cells_;
  std::vector<std::uint64_t> slots_; ///< Of a power of two; cells with their numbers, or empty.
  int shift_ = 64 - 7;               ///< Leaves the bits of a slot's number of a hash.
};

/// A set of cells. Those of a block of 4 x 4 x 4 are bits of one number: little memory to go through.
class Cell_set
{
public:
  std::size_t size() const { return size_; }

  /// Forgets all cells and keeps the room.
  void clear()
  {
    blocks_.clear();
    bits_.clear();
    size_ = 0;
  }

  void insert(const Grid_cell& cell)
  {
    const std::size_t b = blocks_.insert(packed({{cell[0] >> 2, cell[1] >> 2, cell[2] >> 2}}));
    if(b == bits_.size())
      bits_.push_back(0);
    const int place = (cell[0] & 3) << 4 | (cell[1] & 3) << 2 | (cell[2] & 3);
    const std::uint64_t bit = std::uint64_t(1) << place;
    size_ += (bits_[b] & bit) == 0 ? 1 : 0;
    bits_[b] |= bit;
  }

  /// Inserts those around packed cells.
  void insert_around(const std::vector<std::uint64_t>& cells, const Cell_around& around)
  {
    for(std::uint64_t cell : cells)
      insert(around(unpacked(cell)));
  }

  /// The cells, packed; those of a block one after the other.
  std::vector<std::uint64_t> cells() const
  {
    std::vector<std::uint64_t> result;
    result.reserve(size_);
    for(std::size_t b = 0; b < bits_.size(); ++b) {
      const Grid_cell block = unpacked(blocks_.cells()[b]);
      std::uint64_t bits = bits_[b];
      for(int place = 0; bits != 0; ++place, bits >>= 1)
        if((bits & 1) != 0)
          result.push_back(packed({{4 * block[0] + (place >> 4), 4 * block[1] + (place >> 2 & 3),
                                    4 * block[2] + (place & 3)}}));
    }
    return result;
  }

private:
  Cell_index blocks_;
  std::vector<std::uint64_t> bits_; ///< Of every block.
  std::size_t size_ = 0;
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CUBIC_GRID_H
