// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GAUSSIAN_MIXTURE_BUILDER_3_H
#define CGAL_GAUSSIAN_MIXTURE_BUILDER_3_H

#include <CGAL/license/Point_set_skeletonization_3.h>

#include <CGAL/Bulk_bbox_3.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Normalization.h>
#include <CGAL/Point_set_skeletonization_3/internal/interface/named_parameters.h>
#include <CGAL/Point_set_skeletonization_3/internal/interface/public_data.h>
#include <CGAL/Point_set_skeletonization_3/internal/mixture/Grid_mixture.h>
#include <CGAL/Point_set_skeletonization_3/internal/mixture/Moment_grid.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <cstddef>
#include <stdexcept>
#include <string>

namespace CGAL {

template <typename Traits, typename ConcurrencyTag>
class L1_medial_skeletonization_3;

/// \ingroup PkgPointSetSkeletonization3Ref
///
/// Takes the points of a cloud chunk after chunk and stores their moments only, so that a cloud
/// larger than memory can be skeletonised: pass it to `extract_l1_medial_skeleton()`,
/// `L1_medial_skeletonization_3` or `fit_gaussian_mixture()` in place of the points.
///
/// The moments are those of the cells of a grid over a given box. When more than 524 288 cells are
/// occupied, 2 x 2 x 2 are merged into one, which is exact. So memory is bounded by about 200 MB
/// for any number of points.
///
/// The result does not depend on how the points are divided into chunks, bit for bit. If the box is
/// the bounding box of the points, it has the moments of the whole range given at once, up to
/// rounding. A different order of the points, or merging builders (one per thread or machine),
/// changes them by rounding only.
///
/// \tparam Traits a model of `L1MedialSkeletonizationTraits_3`
template <typename Traits>
class Gaussian_mixture_builder_3
{
  using Normalization = Point_set_skeletonization_3::internal::Normalization;
  using Vector3 = Point_set_skeletonization_3::internal::Vector3;

public:
  using FT = typename Traits::FT;
  using Point_3 = typename Traits::Point_3;

  /// \param box contains all points, best their bounding box. A larger one gives a coarser grid: no
  ///        cell is narrower than 1/4096 of the diagonal. An empty box contains no points.
  /// \throws std::invalid_argument if the box is not finite, or a least coordinate greater than the
  ///         greatest
  explicit Gaussian_mixture_builder_3(const Bbox_3& box)
    : box_(box), normalization_(normalization_of(box))
  {}

  /// The same for the box of the bulk of the points: those outside are not refused, but counted as
  /// outliers.
  explicit Gaussian_mixture_builder_3(const Bulk_bbox_3<Traits>& bulk)
    : Gaussian_mixture_builder_3(bulk.bbox())
  {
    leaves_out_far_ = true;
  }

  /// Adds the points of a range, which is read once. O(1) amortised per point.
  /// \param points the range
  /// \param np
  ///   \cgalNamedParamsBegin
  ///     \cgalParamNBegin{point_map} \cgalParamDescription{gives the `Point_3` of an element}
  ///       \cgalParamDefault{`Identity_property_map`} \cgalParamNEnd
  ///   \cgalNamedParamsEnd
  /// \throws std::invalid_argument if a coordinate is not finite or a point outside the box. The
  ///         message names the point by its number in the order of insertion; the points before it
  ///         stay inserted.
  template <typename PointRange, typename NamedParameters = parameters::Default_named_parameters>
  void insert(const PointRange& points, const NamedParameters& np = parameters::default_values())
  {
    namespace internal = Point_set_skeletonization_3::internal;
    static_assert(internal::Maps_to_points<PointRange, NamedParameters>::value,
                  "the elements of the range are not 3D points: pass point_map(MAP)");
    if constexpr(internal::Maps_to_points<PointRange, NamedParameters>::value) {
      const auto map = internal::point_map_of(points, np);
      for(const auto& item : points)
        insert(get(map, item));
    }
  }

  /// Adds one point.
  /// \throws std::invalid_argument as above
  void insert(const Point_3& point)
  {
    const auto [x, y, z] = Point_set_skeletonization_3::internal::to_plain(point);
    const Vector3 p(x, y, z);
    if(!p.allFinite())
      fail("has a coordinate that is not finite; remove or repair it");
    const bool inside = box_.xmin() <= p.x() && p.x() <= box_.xmax() && //
                        box_.ymin() <= p.y() && p.y() <= box_.ymax() && //
                        box_.zmin() <= p.z() && p.z() <= box_.zmax();
    if(!inside && !leaves_out_far_)
      fail("is outside the given box; enlarge the box");
    if(inside)
      moments_.add(normalization_.to_unit(p));
    else
      ++number_of_far_;
    ++number_of_points_;
  }

  /// Adds the points of another builder. O(cells).
  /// \pre `other` has the same box
  void merge(const Gaussian_mixture_builder_3& other)
  {
    CGAL_precondition(other.box_ == box_);
    moments_.add(other.moments_);
    number_of_points_ += other.number_of_points_;
    number_of_far_ += other.number_of_far_;
  }

  const Bbox_3& box() const { return box_; }

  /// Number of points inserted, those far from all others included.
  std::size_t number_of_points() const { return number_of_points_; }

private:
  template <typename T, typename ConcurrencyTag>
  friend class L1_medial_skeletonization_3;

  static Normalization normalization_of(const Bbox_3& box)
  {
    if(box == Bbox_3()) // empty
      return Normalization();
    const Vector3 lower(box.xmin(), box.ymin(), box.zmin());
    const Vector3 upper(box.xmax(), box.ymax(), box.zmax());
    if(!(lower.array() <= upper.array()).all())
      throw std::invalid_argument("the box of the points is no box: a least coordinate is greater "
                                  "than the greatest, or no number");
    if(!lower.allFinite() || !upper.allFinite())
      throw std::invalid_argument("the box of the points is not finite");
    return Normalization(lower, upper);
  }

  [[noreturn]] void fail(const std::string& why) const
  {
    throw std::invalid_argument("point " + std::to_string(number_of_points()) + ' ' + why);
  }

  Bbox_3 box_;
  Normalization normalization_;
  std::size_t number_of_points_ = 0;
  bool leaves_out_far_ = false;
  std::size_t number_of_far_ = 0; ///< Of the points.
  Point_set_skeletonization_3::internal::Moment_grid moments_{
    Point_set_skeletonization_3::internal::Grid_options().maximum_fine_cells()};
};

} // namespace CGAL

#endif // CGAL_GAUSSIAN_MIXTURE_BUILDER_3_H
