// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_POINT_SOURCE_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_POINT_SOURCE_H

#include <cstddef>
#include <functional>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// The points of a cloud, independent of the range, property map and kernel of the caller. Refers
/// to them.
struct Point_source
{
  /// Number of points of a block, which fits into the L1 cache; the last one may have fewer.
  static constexpr std::size_t block_size = 256;

  /// Number of points.
  std::size_t size = 0;

  /// `read(b, xyz)` writes the coordinates of the points of the `b`-th block to `xyz`, three
  /// numbers per point. May be called concurrently.
  std::function<void(std::size_t, double*)> read;

  std::size_t number_of_blocks() const { return (size + block_size - 1) / block_size; }

  std::size_t size_of_block(std::size_t b) const
  {
    return b + 1 < number_of_blocks() ? block_size : size - b * block_size;
  }
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_POINT_SOURCE_H
