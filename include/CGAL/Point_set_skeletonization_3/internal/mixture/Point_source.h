// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MIXTURE_POINT_SOURCE_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MIXTURE_POINT_SOURCE_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Normalization.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel_for.h>

#include <boost/container/static_vector.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// The points of a cloud in normalised coordinates, a block at a time: no copy of all is needed.
class Point_blocks
{
public:
  /// Points in a block, which fits into the first cache; the last one may have fewer.
  static constexpr std::size_t block_size = 1 << 8;

  /// On the stack: there is one for every few hundred points.
  using Block = boost::container::static_vector<Vector3, block_size>;

  virtual ~Point_blocks() = default;

  /// Number of points.
  virtual std::size_t size() const = 0;

  /// The `b`-th block; may be called concurrently. \pre `b < number_of_blocks()`
  virtual Block block(std::size_t b) const = 0;

  std::size_t number_of_blocks() const { return (size() + block_size - 1) / block_size; }

  /// Calls `visit(i, point)` for the points of the `k`-th of `parts` parts of the cloud, in order.
  template <typename Visit>
  void visit_part(std::size_t k, std::size_t parts, const Visit& visit) const
  {
    const std::size_t end = (k + 1) * number_of_blocks() / parts;
    for(std::size_t b = k * number_of_blocks() / parts; b < end; ++b) {
      std::size_t i = b * block_size;
      for(const Vector3& point : block(b))
        visit(i++, point);
    }
  }
};

/// The points of a range through a property map. Refers to the range.
template <typename PointRange, typename PointMap>
class Range_blocks : public Point_blocks
{
public:
  /// \throws std::invalid_argument that names the first point with a coordinate that is not finite
  template <typename ConcurrencyTag>
  Range_blocks(const PointRange& points, const PointMap& map, ConcurrencyTag)
    : map_(map), size_(static_cast<std::size_t>(std::distance(std::begin(points), std::end(points))))
  {
    auto item = std::begin(points);
    for(std::size_t b = 0; b < number_of_blocks(); ++b) {
      first_.push_back(item);
      std::advance(item, static_cast<std::ptrdiff_t>(size_of_block(b)));
    }
    const Extent extent = parallel_sum<ConcurrencyTag>(
      number_of_blocks(), Extent(), [this](std::size_t b, Extent& part) {
        auto p = first_[b];
        for(std::size_t i = 0; i < size_of_block(b); ++i)
          part.add(b * block_size + i, Normalization::vector(get(map_, *p++)));
      });
    normalization_ = extent.normalization();
  }

  const Normalization& normalization() const { return normalization_; }

  std::size_t size() const override { return size_; }

  Block block(std::size_t b) const override
  {
    Block result(size_of_block(b), boost::container::default_init);
    auto item = first_[b];
    for(Vector3& p : result)
      p = normalization_.to_unit(Normalization::vector(get(map_, *item++)));
    return result;
  }

private:
  using Iterator = decltype(std::begin(std::declval<const PointRange&>()));

  std::size_t size_of_block(std::size_t b) const
  {
    return std::min(block_size, size_ - b * block_size);
  }

  PointMap map_;
  std::size_t size_;
  std::vector<Iterator> first_; ///< Of every block.
  Normalization normalization_;
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MIXTURE_POINT_SOURCE_H
