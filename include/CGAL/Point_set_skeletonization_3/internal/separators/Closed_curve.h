// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SEPARATORS_CLOSED_CURVE_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SEPARATORS_CLOSED_CURVE_H


#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/squared_distance_to_segment.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Surface.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Winding_number.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// A closed curve in the solid, which may be contractible there. Discrete curve shortening: points
/// move towards the mean of their neighbours while they stay in the solid. A curve around a hole of
/// the shape stops at the hole; any other shrinks to a point. A hole of the data does not stop it:
/// the winding number closes it.
class Closed_curve
{
public:
  /// Resamples a closed polygon to 32 points of equal arc length. Refers to `surface`.
  /// \pre `curve` is not empty; `resolution`, a length, is positive
  Closed_curve(const std::vector<Vector3>& curve, double resolution, const Surface& surface)
      : resolution_(resolution)
      , winding_number_(surface.winding_number)
  {
    double length = 0;
    for(std::size_t i = 0; i < curve.size(); ++i)
      length += (curve[i] - next(curve, i)).norm();
    double arc = 0;
    std::size_t k = 0;
    for(std::size_t i = 0; i < curve.size(); ++i) {
      const double step = (curve[i] - next(curve, i)).norm();
      for(; k < size && at(k) * length <= arc + step; ++k) {
        const double t = step > 0 ? (at(k) * length - arc) / step : 0;
        points_[k] = curve[i] + t * (next(curve, i) - curve[i]);
      }
      arc += step;
    }
    for(; k < size; ++k) // rounding
      points_[k] = curve.front();
    const std::vector<double> values = winding_number_.at_places(
      std::vector<Vector3>(points_.begin(), points_.end()), Concurrency::sequential);
    for(k = 0; k < size; ++k)
      is_inside_[k] = values[k] >= half_inside;
  }

  /// Whether all points are in the solid.
  bool is_solid() const
  {
    return std::all_of(is_inside_.begin(), is_inside_.begin() + size_, [](bool in) { return in; });
  }

  /// Whether the curve can be moved onto `other` inside the solid, each point straight to its
  /// counterpart: then the two are homotopic, and both or neither are contractible. \pre
  /// `other.is_solid()`
  bool can_be_moved_onto(const Closed_curve& other) const
  {
    const std::array<Vector3, size> target = other.points_beside(*this);
    for(std::size_t k = 0; k < size; ++k)
      if(!is_solid_before(points_[k], target[k]))
        return false;
    return true;
  }

  /// Whether the curve runs along `other` within half a resolution: between them is nothing that
  /// the points tell, so both or neither are contractible, even through gaps of the data.
  bool is_along(const Closed_curve& other) const
  {
    const double most = (std::min)(resolution_, other.resolution_) / 2;
    for(const Vector3& p : points_) // most curves are told apart by their first point
      if(!other.is_near(p, most))
        return false;
    const std::array<Vector3, size> beside = other.points_beside(*this);
    for(std::size_t k = 0; k < size; ++k) { // counterparts are half a step off, at most
      const Vector3 &last = beside[(k + size - 1) % size], &next = beside[(k + 1) % size];
      if(squared_distance_to_segment(points_[k], last, beside[k]) >= most * most &&
         squared_distance_to_segment(points_[k], beside[k], next) >= most * most)
        return false;
    }
    return true;
  }

  /// Whether curve shortening shrinks the curve to a point, in 60 steps at most.
  bool is_contractible() const { return Closed_curve(*this).contract(); }

private:
  /// Shortens the curve until it is a point or stops. Returns whether it is a point.
  bool contract()
  {
    constexpr int most_steps = 60; // about six are usual
    constexpr double slow = 0.98;  // greater share of the least length: no progress
    constexpr int patience = 3;    // steps without progress: the curve may slide around a corner
    const double point = CGAL_PI * resolution_; // circle as wide as the resolution
    double length = this->length(), shortest = length; // the length is not monotonic
    for(int step = 0, stuck = 0; step < most_steps && stuck < patience; ++step) {
      drop_points(length);
      const bool moved = shorten();
      length = this->length();
      if(length < point)
        return true;
      if(!moved)
        break;
      stuck = length > slow * shortest ? stuck + 1 : 0;
      shortest = (std::min)(shortest, length);
    }
    return length < 2 * point;
  }

  // Initial number of points: holes are assumed wider than 1/32 of the length of the curve.
  static constexpr std::size_t size = 32;

  static double at(std::size_t k) { return static_cast<double>(k) / size; }

  static const Vector3& next(const std::vector<Vector3>& curve, std::size_t i)
  {
    return curve[i + 1 < curve.size() ? i + 1 : 0];
  }

  /// The points, shifted and perhaps reversed so that they are closest to those of `other` (least
  /// squares).
  std::array<Vector3, size> points_beside(const Closed_curve& other) const
  {
    double least = std::numeric_limits<double>::infinity();
    std::array<Vector3, size> result;
    for(const std::size_t direction : {std::size_t(1), size - 1})
      for(std::size_t first = 0; first < size; ++first) {
        double sum = 0;
        for(std::size_t k = 0; k < size && sum < least; ++k)
          sum += (points_[(first + k * direction) % size] - other.points_[k]).squaredNorm();
        if(sum < least) {
          least = sum;
          for(std::size_t k = 0; k < size; ++k)
            result[k] = points_[(first + k * direction) % size];
        }
      }
    return result;
  }

  /// Whether a place is nearer to the curve than `most`. \pre the curve was not shortened
  bool is_near(const Vector3& place, double most) const
  {
    for(std::size_t k = 0; k < size; ++k)
      if(squared_distance_to_segment(place, points_[k], points_[(k + 1) % size]) < most * most)
        return true;
    return false;
  }

  double length() const
  {
    double result = (points_.front() - points_[size_ - 1]).norm();
    for(std::size_t k = 1; k < size_; ++k)
      result += (points_[k] - points_[k - 1]).norm();
    return result;
  }

  /// Drops every other point of a curve of this length while the rest is closer than two
  /// resolutions: no obstacle is thinner.
  void drop_points(double length)
  {
    constexpr std::size_t least = 16; // with eight, a curve cuts through corners of an obstacle
    while(size_ > least && length < static_cast<double>(size_) * resolution_) {
      size_ /= 2;
      for(std::size_t k = 0; k < size_; ++k) {
        points_[k] = points_[2 * k];
        is_inside_[k] = is_inside_[2 * k];
      }
    }
  }

  /// Moves each point to the mean of the longest part of the curve around it that the solid
  /// permits. A point at the boundary, inside or next to one inside, slides along it. Returns
  /// whether any point moved.
  bool shorten()
  {
    bool any_moved = false;
    for(std::size_t i = 0; i < size_; ++i) {
      std::array<Vector3, 4> means; // a quarter of the curve to either side, half of that, ...
      for(std::size_t k = 0; k < means.size(); ++k)
        means[k] = mean_around(i, (std::max<std::size_t>)(1, size_ >> (k + 2)));
      const std::array<double, 4> winding_numbers = winding_number_(means);
      bool moved = false;
      for(std::size_t k = 0; k < 4 && !moved; ++k)
        moved = winding_numbers[k] >= half_inside && move(i, means[k]);
      if(!moved && (is_inside_[i] || is_inside_[(i + 1) % size_] ||
                    is_inside_[(i + size_ - 1) % size_])) {
        const Vector3 beside = means[3] + resolution_ / 2 * away_from_air(points_[i]);
        moved = winding_number_(beside) >= half_inside && move(i, beside);
      }
      any_moved |= moved;
    }
    return any_moved;
  }

  Vector3 mean_around(std::size_t i, std::size_t reach) const
  {
    Vector3 mean = Vector3::Zero();
    for(std::size_t k = size_ - reach; k <= size_ + reach; ++k)
      mean += points_[(i + k) % size_];
    return mean / static_cast<double>(2 * reach + 1);
  }

  /// Unit gradient of the winding number at `p`, from the corners of a tetrahedron.
  Vector3 away_from_air(const Vector3& p) const
  {
    const double h = resolution_ / (2 * std::sqrt(3.0));
    const std::array<Vector3, 4> corners = {
      {{h, h, h}, {h, -h, -h}, {-h, h, -h}, {-h, -h, h}}};
    std::array<Vector3, 4> places;
    for(std::size_t k = 0; k < 4; ++k)
      places[k] = p + corners[k];
    const std::array<double, 4> values = winding_number_(places);
    Vector3 gradient = Vector3::Zero();
    for(std::size_t k = 0; k < 4; ++k)
      gradient += values[k] * corners[k];
    return gradient.normalized();
  }

  /// Moves the `i`-th point if the segment to `to` is in the solid. Returns whether it moved.
  /// \pre `to` is in the solid
  bool move(std::size_t i, const Vector3& to)
  {
    if(!is_solid_before(points_[i], to))
      return false;
    points_[i] = to;
    is_inside_[i] = true;
    return true;
  }

  /// Whether the segment between two places is in the solid, tested at up to 16 places.
  bool is_solid_before(const Vector3& from, const Vector3& to) const
  {
    constexpr double most_places = 16;
    const double steps =
        1 + (std::min)(most_places - 1, std::floor((to - from).norm() / resolution_));
    for(double step = 1; step < steps; step += 4) {
      std::array<Vector3, 4> places;
      for(std::size_t k = 0; k < 4; ++k)
        places[k] = from + (std::min)(1.0, (step + static_cast<double>(k)) / steps) * (to - from);
      const std::array<double, 4> values = winding_number_(places);
      if(*std::min_element(values.begin(), values.end()) < half_inside)
        return false;
    }
    return true;
  }

  /// Winding number on the surface and in the middle of a hole of the data, which a curve must not
  /// pass through: it is 1 inside and 0 outside.
  static constexpr double half_inside = 0.5;

  std::size_t size_ = size; ///< Number of points left.
  double resolution_;
  const Winding_number& winding_number_;
  std::array<Vector3, size> points_;
  std::array<bool, size> is_inside_; ///< Whether each point is in the solid.
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SEPARATORS_CLOSED_CURVE_H
