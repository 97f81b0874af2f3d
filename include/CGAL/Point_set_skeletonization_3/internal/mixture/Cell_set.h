// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MIXTURE_CELL_SET_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MIXTURE_CELL_SET_H

#include <CGAL/Point_set_skeletonization_3/internal/mixture/Cell_map.h>
#include <CGAL/Point_set_skeletonization_3/internal/mixture/Cubic_grid.h>

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

/// A set of cells. The cells of a block of 4 x 4 x 4 are the bits of one number, which saves
/// memory.
class Cell_set
{
public:
  std::size_t size() const { return size_; }

  /// Number of blocks with cells.
  std::size_t number_of_blocks() const { return blocks_.size(); }

  /// Adds a cell. O(1).
  void insert(const Grid_cell& cell) { insert(Place(cell)); }

  /// Adds the cells `cell(k)` for 0 <= k < `number`. Some blocks are loaded ahead of their turn,
  /// since the cells of a cloud in random order are anywhere in memory. O(number).
  template <typename Cell>
  void insert(std::size_t number, const Cell& cell)
  {
    std::array<Place, 32> places;
    for(std::size_t first = 0; first < number; first += places.size()) {
      const std::size_t size = (std::min)(places.size(), number - first);
      for(std::size_t k = 0; k < size; ++k) {
        places[k] = Place(cell(first + k));
        blocks_.prefetch(places[k].block);
      }
      for(std::size_t k = 0; k < size; ++k)
        insert(places[k]);
    }
  }

  /// Adds the cells of another set. O(blocks of the smaller one).
  void add(Cell_set other)
  {
    if(number_of_blocks() < other.number_of_blocks())
      std::swap(*this, other);
    other.blocks_.for_each([&](std::uint64_t block, std::uint64_t cells) { insert(block, cells); });
  }

  /// Returns the cells of twice the width that contain these. O(blocks).
  Cell_set coarsened() const
  {
    Cell_set result;
    blocks_.for_each([&](std::uint64_t code, std::uint64_t cells) {
      const Grid_cell block = unpacked(code);
      const int place = (block[0] & 1) << 5 | (block[1] & 1) << 3 | (block[2] & 1) << 1;
      result.insert(packed({{block[0] >> 1, block[1] >> 1, block[2] >> 1}}),
                    coarsened(cells) << place);
    });
    return result;
  }

  /// Returns the cells, packed; those of a block are consecutive. O(cells).
  std::vector<std::uint64_t> cells() const
  {
    std::vector<std::uint64_t> result;
    result.reserve(size_);
    blocks_.for_each([&](std::uint64_t code, std::uint64_t cells) {
      const Grid_cell block = unpacked(code);
      for(int place = 0; cells != 0; ++place, cells >>= 1) {
        for(; (cells & 0xFF) == 0; place += 8) // most cells are empty
          cells >>= 8;
        if((cells & 1) != 0)
          result.push_back(packed({{4 * block[0] + (place >> 4), 4 * block[1] + (place >> 2 & 3),
                                    4 * block[2] + (place & 3)}}));
      }
    });
    return result;
  }

private:
  /// Where a cell is: its block, and its bit there.
  struct Place
  {
    Place() = default;
    explicit Place(const Grid_cell& cell)
      : block(packed({{cell[0] >> 2, cell[1] >> 2, cell[2] >> 2}})),
        bit((cell[0] & 3) << 4 | (cell[1] & 3) << 2 | (cell[2] & 3))
    {}

    std::uint64_t block = 0;
    int bit = 0;
  };

  void insert(const Place& place)
  {
    std::uint64_t& cells = blocks_[place.block];
    size_ += ~cells >> place.bit & 1;
    cells |= std::uint64_t(1) << place.bit;
  }

  void insert(std::uint64_t block, std::uint64_t cells)
  {
    std::uint64_t& known = blocks_[block];
    size_ += std::bitset<64>(cells & ~known).count();
    known |= cells;
  }

  /// The cells of a block at twice the width, in its lower corner: merges two along each axis in
  /// turn.
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

  Cell_map<std::uint64_t> blocks_;
  std::size_t size_ = 0;
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MIXTURE_CELL_SET_H
