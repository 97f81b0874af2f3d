// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_NORMALIZED_POINTS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_NORMALIZED_POINTS_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Bulk.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Normalization.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Per_thread.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Progress.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Point_source.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>

#include <boost/container/static_vector.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// A block of points, on the stack: blocks are too small for heap allocations.
using Point_block = boost::container::static_vector<Vector3, Point_source::block_size>;

/// Returns the points of the `b`-th block, in the coordinates of the input. O(block).
inline Point_block read_block(const Point_source& points, std::size_t b)
{
  Point_block result(points.size_of_block(b), boost::container::default_init);
  points.read(b, result.data()->data());
  return result;
}

/// Returns the bulk of a cloud, which is read once, and again if there are points far away. O(n).
/// \throws std::invalid_argument that names the first point with a coordinate that is not finite
inline Bulk bulk_of(const Point_source& points, Concurrency concurrency,
                    const Progress& progress = Progress())
{
  Bulk bulk;
  for(double done = 0;;) {
    // A pass more is rare: the progress of half of what is left will do.
    const double next = (1 + done) / 2;
    Bulk pass = parallel_sum(
      concurrency, points.number_of_blocks(), bulk,
      [&](std::size_t b, Bulk& part) {
        std::size_t i = b * Point_source::block_size;
        for(const Vector3& p : read_block(points, b))
          part.add(i++, p);
      },
      progress.part(done, next));
    const bool is_found = pass.end_pass();
    bulk = std::move(pass);
    if(is_found)
      return bulk;
    done = next;
  }
}

/// The points of a cloud in normalised coordinates, block by block without a copy of all.
struct Normalized_points
{
  Point_source source;
  Normalization normalization;
  std::size_t number_of_far = 0; ///< Points outside of the normalised box, see `Bulk`.

  std::size_t size() const { return source.size; }
  std::size_t number_of_blocks() const { return source.number_of_blocks(); }

  /// Number of points in the normalised box.
  std::size_t bulk_size() const { return source.size - number_of_far; }

  /// Calls `visit(i, point)` for each point in the `b`-th block that is in the normalised box, the
  /// `i`-th of the cloud. May be called concurrently. \pre `b < number_of_blocks()`
  template <typename Visit>
  void visit_block(std::size_t b, const Visit& visit) const
  {
    std::size_t i = b * Point_source::block_size;
    for(const Vector3& p : read_block(source, b)) {
      if(number_of_far == 0 || normalization.contains(p))
        visit(i, normalization.to_unit(p));
      ++i;
    }
  }

  /// The points of the `b`-th block that are in the normalised box, and their numbers in the cloud.
  struct Block
  {
    boost::container::static_vector<std::size_t, Point_source::block_size> numbers;
    Point_block points;
  };

  /// Returns the `b`-th block. May be called concurrently. \pre `b < number_of_blocks()`
  Block block(std::size_t b) const
  {
    Block result;
    visit_block(b, [&](std::size_t i, const Vector3& p) {
      result.numbers.push_back(i);
      result.points.push_back(p);
    });
    return result;
  }

  /// Calls `visit(b)` for each block, concurrently. O(n).
  template <typename Visit>
  void visit_blocks(const Visit& visit, Concurrency concurrency, const Progress& progress) const
  {
    constexpr std::size_t slice = 1 << 10; // takes milliseconds
    for(std::size_t first = 0; first < number_of_blocks(); first += slice) {
      const std::size_t end = (std::min)(number_of_blocks(), first + slice);
      parallel_for(concurrency, end - first, [&](std::size_t k) { visit(first + k); });
      progress(static_cast<double>(end) / static_cast<double>(number_of_blocks()));
    }
  }
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_NORMALIZED_POINTS_H
