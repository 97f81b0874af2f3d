// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_ROUNDED_BOX_H
#define POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_ROUNDED_BOX_H

#include "Random.h"

#include <algorithm>
#include <stdexcept>

namespace shapes {

/// All points within `rounding` of a box, its core.
class Rounded_box
{
public:
  /// `axes` has the directions of the edges as its columns, `half_extents` are those of the whole.
  /// \throws std::invalid_argument if the rounding is larger than a half extent
  Rounded_box(const Vector& centre, const Eigen::Matrix3d& axes, const Vector& half_extents,
              double rounding)
      : centre_(centre)
      , axes_(axes)
      , core_(half_extents.array() - rounding)
      , rounding_(rounding)
  {
    if(core_.minCoeff() < 0)
      throw std::invalid_argument("Rounded_box: too round");
  }

  /// Exact, negative inside.
  double signed_distance(const Vector& p) const
  {
    const Vector q = (axes_.transpose() * (p - centre_)).cwiseAbs() - core_;
    return q.cwiseMax(0).norm() + std::min(0.0, q.maxCoeff()) - rounding_;
  }

  double area() const { return face_areas().sum() + edge_areas().sum() + corner_area(); }

  /// On the surface, uniform by area.
  Vector random_point(Random& random) const
  {
    const Vector place = 2 * random.uniform_vector().array() - 1;
    const Vector direction = random.direction();
    double part = random.uniform() * area();
    for(int i = 0; i < 3; ++i) {
      if(part < face_areas()[i])
        return on_surface(place, sign(direction[i]) * Vector::Unit(i));
      part -= face_areas()[i];
    }
    for(int i = 0; i < 3; ++i) {
      if(part < edge_areas()[i])
        return on_surface(place, (direction - direction[i] * Vector::Unit(i)).normalized());
      part -= edge_areas()[i];
    }
    return on_surface(place, direction);
  }

  Eigen::AlignedBox3d bounding_box() const
  {
    const Vector half = (axes_.cwiseAbs() * core_).array() + rounding_;
    return Eigen::AlignedBox3d(centre_ - half, centre_ + half);
  }

  void rotate(const Eigen::Matrix3d& rotation)
  {
    centre_ = rotation * centre_;
    axes_ = rotation * axes_;
  }

private:
  static double sign(double x) { return x < 0 ? -1 : 1; }

  /// Both faces across each axis.
  Vector face_areas() const
  {
    return 8 * Vector(core_.y() * core_.z(), core_.z() * core_.x(), core_.x() * core_.y());
  }

  /// The four quarters of a cylinder along each axis.
  Vector edge_areas() const { return 2 * full_turn * rounding_ * core_; }

  /// The eight eighths of a ball.
  double corner_area() const { return 2 * full_turn * rounding_ * rounding_; }

  /// Where the surface has this normal; `place` in [-1, 1]^3 chooses where the normal leaves it
  /// open.
  Vector on_surface(const Vector& place, const Vector& normal) const
  {
    Vector p;
    for(int i = 0; i < 3; ++i)
      p[i] = core_[i] * (normal[i] == 0 ? place[i] : sign(normal[i])) + rounding_ * normal[i];
    return centre_ + axes_ * p;
  }

  Vector centre_;
  Eigen::Matrix3d axes_;
  Vector core_; ///< Half extents.
  double rounding_;
};

} // namespace shapes

#endif // POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_ROUNDED_BOX_H
