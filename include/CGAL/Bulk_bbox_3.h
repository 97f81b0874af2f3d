// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_BULK_BBOX_3_H
#define CGAL_BULK_BBOX_3_H

#include <CGAL/license/Point_set_skeletonization_3.h>

#include <CGAL/Point_set_skeletonization_3/internal/core/Bulk.h>
#include <CGAL/Point_set_skeletonization_3/internal/interface/public_data.h>

#include <CGAL/Bbox_3.h>

#include <cstddef>

namespace CGAL {

/// Finds the bounding box of the bulk of a cloud, the box for a `Gaussian_mixture_builder_3`, in
/// memory that does not depend on the number of points.
///
/// The bulk is all points but at most a thousandth of them that are farther away from the rest than
/// the rest is large: measuring errors, at any finite distance. It does not depend on the order of
/// the points, and is what `extract_l1_medial_skeleton()` finds for the points of a range.
///
/// Insert all points, call `end_pass()`, and if it returns `false`, which is rare, do so again.
///
/// \tparam Traits a model of `L1MedialSkeletonizationTraits_3`
template <typename Traits>
class Bulk_bbox_3
{
public:
  using Point_3 = typename Traits::Point_3;

  /// Adds a point. O(1) amortised.
  void insert(const Point_3& point)
  {
    const auto [x, y, z] = Point_set_skeletonization_3::internal::to_plain(point);
    bulk_.add(number_of_points_++, {x, y, z});
  }

  /// Adds the points of another part of the same pass, of another thread or machine. O(1)
  void merge(const Bulk_bbox_3& other)
  {
    bulk_.add(other.bulk_);
    number_of_points_ += other.number_of_points_;
  }

  /// Ends a pass over the points.
  /// \returns whether the box is found
  /// \throws std::invalid_argument that names the first point with a coordinate that is not finite
  bool end_pass()
  {
    number_of_points_ = 0;
    return bulk_.end_pass();
  }

  /// The box, empty without points. \pre `end_pass()` returned `true`
  Bbox_3 bbox() const
  {
    const auto& box = bulk_.box();
    return box.is_empty() ? Bbox_3()
                          : Bbox_3(box.lower().x(), box.lower().y(), box.lower().z(),
                                   box.upper().x(), box.upper().y(), box.upper().z());
  }

  /// Writes or reads what is known of the points, for archives as those of Boost.Serialization: for
  /// `merge()` in another process.
  template <typename Archive>
  void serialize(Archive& archive, unsigned int)
  {
    archive & bulk_ & number_of_points_;
  }

  /// Number of points outside of it. \pre `end_pass()` returned `true`
  std::size_t number_of_far_points() const { return bulk_.number_of_far(); }

private:
  Point_set_skeletonization_3::internal::Bulk bulk_;
  std::size_t number_of_points_ = 0; ///< Of this pass.
};

} // namespace CGAL

#endif // CGAL_BULK_BBOX_3_H
