// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_ASSIGNMENT_3_H
#define CGAL_POINT_ASSIGNMENT_3_H

#include <CGAL/license/Point_set_skeletonization_3.h>

#include <CGAL/Point_set_skeletonization_3/internal/core/Normalization.h>
#include <CGAL/Point_set_skeletonization_3/internal/interface/plain_data.h>
#include <CGAL/Point_set_skeletonization_3/internal/interface/public_data.h>
#include <CGAL/Point_set_skeletonization_3/internal/mixture/Cell_numbers.h>
#include <CGAL/Point_set_skeletonization_3/internal/mixture/Lattice_point.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

namespace CGAL {

/// \ingroup PkgPointSetSkeletonization3Ref
///
/// Tells which vertex of a skeleton a point belongs to, for points that were not kept: those of a
/// `Gaussian_mixture_builder_3`, which are read once more. `L1_medial_skeletonization_3` makes it;
/// it can be serialised by Boost.Serialization, after `boost/serialization/vector.hpp` is included.
///
/// \tparam Traits a model of `L1MedialSkeletonizationTraits_3`
template <typename Traits>
class Point_assignment_3
{
public:
  using Point_3 = typename Traits::Point_3;

  /// The vertex of a point that belongs to none: outliers, and points that were not inserted.
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  /// Of no skeleton.
  Point_assignment_3() = default;

  explicit Point_assignment_3(Point_set_skeletonization_3::internal::Plain_assignment plain)
    : plain_(std::move(plain))
  {}

  /// The number of the vertex. O(log cells).
  std::size_t operator()(const Point_3& point) const
  {
    namespace internal = Point_set_skeletonization_3::internal;
    const auto [x, y, z] = internal::to_plain(point);
    const auto& [lower, upper] = plain_.box;
    const internal::Normalization normalization({lower[0], lower[1], lower[2]},
                                                {upper[0], upper[1], upper[2]});
    const internal::Vector3 p(x, y, z);
    if(!normalization.contains(p)) // nor is it finite, perhaps
      return none;
    const std::size_t cell = plain_.cells.number(internal::lattice_point(normalization.to_unit(p)));
    return cell < plain_.vertex_of_cell.size() ? plain_.vertex_of_cell[cell] : none;
  }

  template <typename Archive>
  void serialize(Archive& archive, unsigned int)
  {
    archive & plain_.box.first & plain_.box.second & plain_.cells.grid.level &
        plain_.cells.grid.factor & plain_.cells.cells & plain_.vertex_of_cell;
  }

private:
  Point_set_skeletonization_3::internal::Plain_assignment plain_;
};

} // namespace CGAL

#endif // CGAL_POINT_ASSIGNMENT_3_H
