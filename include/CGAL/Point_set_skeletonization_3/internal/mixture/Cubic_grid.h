// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MIXTURE_CUBIC_GRID_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MIXTURE_CUBIC_GRID_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>

#include <algorithm>
#include <array>
#include <bitset>
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

/// What spreads cells over a hash table, if the first bits of the product are taken (Knuth).
constexpr std::uint64_t golden_ratio = 0x9E3779B97F4A7C15u;

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
    std::size_t slot = cell * golden_ratio >> shift_;
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

/// A set of cells: a hash table like that of an index. Those of a block of 4 x 4 x 4 are bits of one
/// number: little memory to go through.
class Cell_set
{
public:
  std::size_t size() const { return size_; }

  /// Number of blocks that have cells.
  std::size_t blocks() const { return blocks_; }

  void insert(const Grid_cell& cell)
  {
    const int place = (cell[0] & 3) << 4 | (cell[1] & 3) << 2 | (cell[2] & 3);
    std::uint64_t& cells = cells_of({{cell[0] >> 2, cell[1] >> 2, cell[2] >> 2}});
    size_ += ~cells >> place & 1;
    cells |= std::uint64_t(1) << place;
  }

  /// Adds the cells of another set.
  void add(Cell_set other)
  {
    if(blocks_ < other.blocks_)
      std::swap(*this, other);
    other.for_each_block([&](const Grid_cell& block, std::uint64_t cells) { insert(block, cells); });
  }

  /// The cells twice as wide around them.
  Cell_set coarsened() const
  {
    Cell_set result;
    for_each_block([&](const Grid_cell& block, std::uint64_t cells) {
      const int place = (block[0] & 1) << 5 | (block[1] & 1) << 3 | (block[2] & 1) << 1;
      result.insert({{block[0] >> 1, block[1] >> 1, block[2] >> 1}}, coarsened(cells) << place);
    });
    return result;
  }

  /// The cells, packed; those of a block one after the other.
  std::vector<std::uint64_t> cells() const
  {
    std::vector<std::uint64_t> result;
    result.reserve(size_);
    for_each_block([&](const Grid_cell& block, std::uint64_t cells) {
      for(int place = 0; cells != 0; ++place, cells >>= 1) {
        for(; (cells & 0xFF) == 0; place += 8) // few are occupied
          cells >>= 8;
        if((cells & 1) != 0)
          result.push_back(packed({{4 * block[0] + (place >> 4), 4 * block[1] + (place >> 2 & 3),
                                    4 * block[2] + (place & 3)}}));
      }
    });
    return result;
  }

private:
  struct Slot
  {
    std::uint64_t block = 0; ///< Packed.
    std::uint64_t cells = 0; ///< None: the slot is empty.
  };

  template <typename Visit>
  void for_each_block(const Visit& visit) const
  {
    for(const Slot& slot : slots_)
      if(slot.cells != 0)
        visit(unpacked(slot.block), slot.cells);
  }

  void insert(const Grid_cell& block, std::uint64_t cells)
  {
    std::uint64_t& known = cells_of(block);
    size_ += std::bitset<64>(cells & ~known).count();
    known |= cells;
  }

  /// The cells of a block. If there are none, some must be added.
  std::uint64_t& cells_of(const Grid_cell& block)
  {
    constexpr std::size_t room = 2; // slots of a block, at least: it is nearly always in the first two
    if(slots_.size() < room * (blocks_ + 1))
      grow();
    Slot& slot = slots_[slot_of(packed(block))];
    if(slot.cells == 0) {
      slot.block = packed(block);
      ++blocks_;
    }
    return slot.cells;
  }

  /// Where a block is, or would be.
  std::size_t slot_of(std::uint64_t block) const
  {
    std::size_t slot = block * golden_ratio >> shift_;
    while(slots_[slot].cells != 0 && slots_[slot].block != block)
      slot = (slot + 1) & (slots_.size() - 1);
    return slot;
  }

  void grow()
  {
    --shift_;
    std::vector<Slot> old(std::size_t(1) << (64 - shift_));
    old.swap(slots_);
    for(const Slot& slot : old)
      if(slot.cells != 0)
        slots_[slot_of(slot.block)] = slot;
  }

  /// The cells of a block twice as wide, in its corner: two become one along every axis in turn.
  static std::uint64_t coarsened(std::uint64_t cells)
  {
    constexpr std::array<std::pair<int, std::uint64_t>, 3> axes = {
      {{1, 0x1111111111111111u}, {4, 0x000F000F000F000Fu}, {16, 0x000000000000FFFFu}}};
    for(const auto& [step, first] : axes) {
      cells |= cells >> step;
      cells = (cells & first) | (cells >> step & first << step);
    }
    return cells;
  }

  std::vector<Slot> slots_; ///< Of a power of two.
  int shift_ = 64 - 6;      ///< As that of an index.
  std::size_t blocks_ = 0, size_ = 0;
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MIXTURE_CUBIC_GRID_H
