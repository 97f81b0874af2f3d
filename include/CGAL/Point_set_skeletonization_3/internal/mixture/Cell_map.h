// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MIXTURE_CELL_MAP_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MIXTURE_CELL_MAP_H

#include <CGAL/Point_set_skeletonization_3/internal/core/prefetch.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// A hash table from packed cells to small values, with open addressing and Fibonacci hashing
/// (Knuth, The Art of Computer Programming 6.4). At most half of its slots are taken, so that a
/// cell is nearly always in the first or second slot probed.
template <typename Value>
class Cell_map
{
public:
  Cell_map() = default;

  /// With room for `size` cells.
  explicit Cell_map(std::size_t size)
  {
    while(capacity() < 2 * size)
      --shift_;
    slots_.resize(capacity());
  }

  /// Number of cells.
  std::size_t size() const { return size_; }

  /// The value of a cell, which is added with a default value if it is new. O(1).
  Value& operator[](std::uint64_t cell)
  {
    if(2 * size_ >= slots_.size())
      grow();
    Slot& slot = slots_[slot_of(cell)];
    if(slot.cell == empty) {
      slot.cell = cell;
      ++size_;
    }
    return slot.value;
  }

  /// The value of a cell. O(1). \pre it is in the table
  const Value& at(std::uint64_t cell) const { return slots_[slot_of(cell)].value; }

  /// The value of a cell; a null pointer if it is not in the table. O(1).
  const Value* find(std::uint64_t cell) const
  {
    if(slots_.empty())
      return nullptr;
    const Slot& slot = slots_[slot_of(cell)];
    return slot.cell == cell ? &slot.value : nullptr;
  }

  /// Begins to load the value of a cell. O(1).
  void prefetch(std::uint64_t cell) const
  {
    if(!slots_.empty())
      internal::prefetch(slots_[first_slot_of(cell)]);
  }

  /// Calls `visit(cell, value)` for each cell, in unspecified order. It is not that of the hashes:
  /// a table that is filled in the order of another one fills up from one end, and searches
  /// become linear there until it grows.
  template <typename Visit>
  void for_each(const Visit& visit) const
  {
    const std::size_t step = golden_ratio >> shift_ | 1; // odd: visits all slots
    constexpr std::size_t ahead = 16;
    const auto nth = [&](std::size_t k) -> const Slot& {
      return slots_[k * step & (slots_.size() - 1)];
    };
    for(std::size_t k = 0; k < slots_.size(); ++k) {
      internal::prefetch(nth(k + ahead));
      if(const Slot& slot = nth(k); slot.cell != empty)
        visit(slot.cell, slot.value);
    }
  }

private:
  static constexpr std::uint64_t empty = ~std::uint64_t(0); // a packed cell has fewer bits
  static constexpr std::uint64_t golden_ratio = 0x9E3779B97F4A7C15u; // times 2^64

  struct Slot
  {
    std::uint64_t cell = empty;
    Value value = Value();
  };

  std::size_t capacity() const { return std::size_t(1) << (64 - shift_); }

  /// The slot at which the search for a cell begins.
  std::size_t first_slot_of(std::uint64_t cell) const { return cell * golden_ratio >> shift_; }

  /// The slot of a cell, or the free slot where it would be.
  std::size_t slot_of(std::uint64_t cell) const
  {
    std::size_t slot = first_slot_of(cell);
    while(slots_[slot].cell != empty && slots_[slot].cell != cell)
      slot = (slot + 1) & (slots_.size() - 1);
    return slot;
  }

  void grow()
  {
    if(!slots_.empty())
      --shift_;
    std::vector<Slot> old(capacity());
    old.swap(slots_);
    for(const Slot& slot : old)
      if(slot.cell != empty)
        slots_[slot_of(slot.cell)] = slot;
  }

  std::vector<Slot> slots_; ///< Their number is a power of two.
  int shift_ = 64 - 7;      ///< 64 minus log2 of the capacity: shifts a hash to a slot.
  std::size_t size_ = 0;
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MIXTURE_CELL_MAP_H
