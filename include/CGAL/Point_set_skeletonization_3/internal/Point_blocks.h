// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_POINT_BLOCKS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_POINT_BLOCKS_H

#include <CGAL/Point_set_skeletonization_3/internal/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/Normalization.h>

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

  virtual ~Point_blocks() = default;

  /// Number of points.
  virtual std::size_t size() const = 0;

  /// The `b`-th block; may be called concurrently. \pre `b < number_of_blocks()`
  virtual std::vector<Vector3> block(std::size_t b) const = 0;

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
  Range_blocks(const PointRange& points, const PointMap& map) : map_(map)
  {
    Extent extent;
    for(auto item = std::begin(points); item != std::end(points); ++item) {
      if(extent.size() % block_size == 0)
        first_.push_back(item);
      extent.add(Normalization::vector(get(map_, *item)));
    }
    size_ = extent.size();
    normalization_ = extent.normalization();
  }

  const Normalization& normalization() const { return normalization_; }

  std::size_t size() const override { return size_; }

  std::vector<Vector3> block(std::size_t b) const override
  {
    std::vector<Vector3> result(std::min(block_size, size_ - b * block_size));
    auto item = first_[b];
    for(Vector3& p : result)
      p = normalization_.to_unit(Normalization::vector(get(map_, *item++)));
    return result;
  }

private:
  using Iterator = decltype(std::begin(std::declval<const PointRange&>()));

  PointMap map_;
  std::vector<Iterator> first_; ///< Of every block.
  std::size_t size_ = 0;
  Normalization normalization_;
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_POINT_BLOCKS_H
