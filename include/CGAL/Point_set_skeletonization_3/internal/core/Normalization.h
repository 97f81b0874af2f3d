// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_NORMALIZATION_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_NORMALIZATION_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// The similarity that maps the bounding box of the input to one centred at the origin with a
/// diagonal of length 1, and its inverse. All stages use these coordinates, so that neither offset
/// nor unit of the input affects precision or results.
class Normalization
{
public:
  Normalization() = default;

  /// `lower` and `upper` are the corners of the bounding box of the input. Computes with halves, so
  /// that no finite box overflows; a diagonal that does counts as the largest number.
  Normalization(const Vector3& lower, const Vector3& upper)
    : lower_(lower), upper_(upper), half_extent_(upper / 2 - lower / 2)
  {
    // No overflow, and unlike Eigen's stableNorm() no dependence on memory alignment.
    const double half_diagonal =
      std::hypot(half_extent_.x(), half_extent_.y(), half_extent_.z());
    if(half_diagonal > 0)
      diagonal_ = 2 * (std::min)(half_diagonal, (std::numeric_limits<double>::max)() / 2);
  }

  /// The corners of the bounding box of the input.
  const Vector3& lower() const { return lower_; }
  const Vector3& upper() const { return upper_; }

  /// Length of the diagonal of the bounding box of the input; 1 if all points are equal.
  double diagonal() const { return diagonal_; }

  /// Maps a point to normalised coordinates. Subtracts a corner of the box first: that difference
  /// is exact far from the origin, unlike that to the centre, so that translated points give the
  /// same bits.
  Vector3 to_unit(const Vector3& p) const
  {
    return ((p / 2 - lower_ / 2) - half_extent_ / 2) / (diagonal_ / 2);
  }

  /// Maps a point to the coordinates of the input.
  Vector3 from_unit(const Vector3& p) const { return p * diagonal_ + (lower_ + half_extent_); }

  /// The same for a point of the shape: it is where the input is, so in its bounding box, whatever
  /// was rounded, extrapolated or smoothed.
  Vector3 from_unit_in_box(const Vector3& p) const
  {
    return from_unit(p).cwiseMax(lower_).cwiseMin(upper_);
  }

  /// Maps a length to the unit of the input; one that is no number there is the largest.
  double length_from_unit(double length) const
  {
    return (std::min)(length * diagonal_, (std::numeric_limits<double>::max)());
  }

  /// Whether a point of the input is in the box.
  bool contains(const Vector3& p) const
  {
    return (lower_.array() <= p.array()).all() && (p.array() <= upper_.array()).all();
  }

  /// Maps a covariance to the unit of the input, and back. Two factors, as the square of the
  /// diagonal may overflow.
  Matrix3 covariance_from_unit(const Matrix3& c) const { return c * diagonal_ * diagonal_; }
  Matrix3 covariance_to_unit(const Matrix3& c) const { return c / diagonal_ / diagonal_; }

private:
  Vector3 lower_ = Vector3::Zero(), upper_ = Vector3::Zero();
  Vector3 half_extent_ = Vector3::Zero();
  double diagonal_ = 1;
};

/// A bounding box, without points at first.
class Box
{
public:
  void add(const Vector3& p)
  {
    lower_ = lower_.cwiseMin(p);
    upper_ = upper_.cwiseMax(p);
  }

  void add(const Box& other)
  {
    lower_ = lower_.cwiseMin(other.lower_);
    upper_ = upper_.cwiseMax(other.upper_);
  }

  bool is_empty() const { return lower_.x() > upper_.x(); }

  bool contains(const Vector3& p) const
  {
    return (lower_.array() <= p.array()).all() && (p.array() <= upper_.array()).all();
  }

  /// The corners. \pre it is not empty
  const Vector3& lower() const { return lower_; }
  const Vector3& upper() const { return upper_; }

  /// Writes or reads the box, for archives as those of Boost.Serialization.
  template <typename Archive>
  void serialize(Archive& archive, unsigned int)
  {
    for(Vector3* corner : {&lower_, &upper_})
      for(Eigen::Index k = 0; k < 3; ++k)
        archive&(*corner)[k];
  }

  /// The similarity that normalises the points.
  Normalization normalization() const
  {
    return is_empty() ? Normalization() : Normalization(lower_, upper_);
  }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  Vector3 lower_ = Vector3::Constant(infinity), upper_ = Vector3::Constant(-infinity);
};

/// No point, as the first with a coordinate that is not finite.
constexpr std::size_t none_not_finite = (std::numeric_limits<std::size_t>::max)();

/// \throws std::invalid_argument that names the first point with a coordinate that is not finite,
///         if there is one
inline void check_finite(std::size_t first_not_finite)
{
  if(first_not_finite != none_not_finite)
    throw std::invalid_argument("point " + std::to_string(first_not_finite) +
                                " has a coordinate that is not finite; remove or repair it");
}

/// The bounding box of points that may not be finite; boxes of parts can be added up.
class Extent
{
public:
  /// Adds the `i`-th point.
  void add(std::size_t i, const Vector3& p)
  {
    if(!p.allFinite())
      not_finite_ = (std::min)(not_finite_, i);
    box_.add(p);
  }

  void add(const Extent& other)
  {
    not_finite_ = (std::min)(not_finite_, other.not_finite_);
    box_.add(other.box_);
  }

  /// The similarity that normalises the points.
  /// \throws std::invalid_argument that names the first point with a coordinate that is not finite
  Normalization normalization() const
  {
    check_finite(not_finite_);
    return box_.normalization();
  }

private:
  std::size_t not_finite_ = none_not_finite;
  Box box_;
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_NORMALIZATION_H
