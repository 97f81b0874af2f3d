// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_ROUND_CONE_H
#define POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_ROUND_CONE_H

#include "Random.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace shapes {

/// The union of the balls along a segment whose radius changes linearly: a cone with two round
/// caps.
class Round_cone
{
public:
  /// \throws std::invalid_argument if one of the two end balls lies in the other
  Round_cone(const Vector& a, const Vector& b, double radius_a, double radius_b)
      : a_(a)
      , b_(b)
      , radius_a_(radius_a)
      , radius_b_(radius_b)
  {
    length_ = (b - a).norm();
    if(length_ <= std::abs(radius_a - radius_b))
      throw std::invalid_argument("Round_cone: a ball");
    along_ = (radius_a - radius_b) / length_;
    across_ = std::sqrt(1 - along_ * along_);
  }

  /// Exact, negative inside.
  double signed_distance(const Vector& p) const
  {
    const Vector offset = p - a_;
    const double y = offset.dot(b_ - a_) / length_;
    const double x = std::sqrt(std::max(0.0, offset.squaredNorm() - y * y));
    const double foot = y - x * along_ / across_; // where the normal through p meets the axis
    if(foot <= 0)
      return offset.norm() - radius_a_;
    if(foot >= length_)
      return (p - b_).norm() - radius_b_;
    return across_ * x + along_ * y - radius_a_;
  }

  double area() const { return cap_area_a() + cap_area_b() + side_area(); }

  /// On the surface, uniform by area.
  Vector random_point(Random& random) const
  {
    const double part = random.uniform() * area();
    const double angle = full_turn * random.uniform();
    const double place = random.uniform();
    if(part < cap_area_a())
      return a_ + radius_a_ * normal(-1 + place * (1 + along_), angle);
    if(part < cap_area_a() + cap_area_b())
      return b_ + radius_b_ * normal(along_ + place * (1 - along_), angle);
    const double t = place_on_side(place);
    return a_ + t * (b_ - a_) + (radius_a_ + t * (radius_b_ - radius_a_)) * normal(along_, angle);
  }

  Eigen::AlignedBox3d bounding_box() const
  {
    const Vector ra = Vector::Constant(radius_a_), rb = Vector::Constant(radius_b_);
    Eigen::AlignedBox3d box(a_ - ra, a_ + ra);
    return box.extend(b_ - rb).extend(b_ + rb);
  }

  void rotate(const Eigen::Matrix3d& rotation)
  {
    a_ = rotation * a_;
    b_ = rotation * b_;
  }

private:
  double cap_area_a() const { return full_turn * radius_a_ * radius_a_ * (1 + along_); }
  double cap_area_b() const { return full_turn * radius_b_ * radius_b_ * (1 - along_); }
  double side_area() const
  {
    return full_turn / 2 * (radius_a_ + radius_b_) * length_ * across_ * across_;
  }

  /// The unit vector with the component `y` along the axis.
  Vector normal(double y, double angle) const
  {
    const Vector axis = (b_ - a_) / length_, u = axis.unitOrthogonal(), v = axis.cross(u);
    const double x = std::sqrt(std::max(0.0, 1 - y * y));
    return y * axis + x * (std::cos(angle) * u + std::sin(angle) * v);
  }

  /// Inverse of the share of the side's area up to a place in [0, 1] on the axis; the area grows as
  /// the radius does.
  double place_on_side(double share) const
  {
    const double difference = radius_b_ - radius_a_, sum = radius_a_ + radius_b_;
    const double root = std::sqrt(radius_a_ * radius_a_ + share * sum * difference);
    return share * sum / (radius_a_ + root);
  }

  Vector a_, b_;
  double radius_a_, radius_b_, length_;
  double along_, across_; ///< Components of the side's normal along the axis and across it.
};

} // namespace shapes

#endif // POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_ROUND_CONE_H
