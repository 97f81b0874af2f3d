// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_DEPTH_IMAGE_H
#define POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_DEPTH_IMAGE_H

#include "Random.h"
#include "Ray.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace shapes {

/// A column and a row; negative ones are left of the middle or below it.
using Pixel = Eigen::Array2i;

/// What is seen from a place: distances along rays whose two angles are on a grid. A grid of angles
/// of planes through the place, not of longitudes and latitudes: so what a box covers is a
/// rectangle.
class Depth_image
{
public:
  /// \param scene the part that the image has to show \param step angle between neighbouring rays
  /// \pre the place is further from the middle of the scene than its corners are
  Depth_image(const Vector& place, const Eigen::AlignedBox3d& scene, double step)
      : place_(place)
      , step_(step)
  {
    axes_.col(2) = (scene.center() - place).normalized();
    axes_.col(0) = axes_.col(2).unitOrthogonal();
    axes_.col(1) = axes_.col(2).cross(axes_.col(0));
    const auto [begin, end] = covered_by(scene);
    begin_ = begin;
    size_ = end - begin;
    distances_.assign(static_cast<std::size_t>(size_.prod()), no_hit);
  }

  /// The first pixel, and the one behind the last.
  Pixel begin() const { return begin_; }
  Pixel end() const { return begin_ + size_; }

  /// To what is seen there; `no_hit` if it is nothing, or beside the image.
  double distance(const Pixel& pixel) const
  {
    const Pixel place = pixel - begin_;
    return (place >= 0).all() && (place < size_).all() ? distances_[index(pixel)] : no_hit;
  }

  /// The ray through a place on the image; the middle of a pixel is half a unit from its index.
  Ray ray(const Eigen::Array2d& at) const
  {
    const Vector direction(std::tan(at.x() * step_), std::tan(at.y() * step_), 1);
    return {place_, axes_ * direction.normalized()};
  }

  /// Shows something that has a `bounding_box()` and a `first_hit()`, where nothing is before it.
  template <typename Primitive>
  void draw(const Primitive& primitive)
  {
    const auto [begin, end] = covered_by(primitive.bounding_box());
    for(int y = begin.y(); y < end.y(); ++y)
      for(int x = begin.x(); x < end.x(); ++x) {
        double& distance = distances_[index(Pixel(x, y))];
        distance = std::min(distance, first_hit(primitive, ray(Eigen::Array2d(x + 0.5, y + 0.5))));
      }
  }

private:
  struct Rectangle
  {
    Pixel begin, end;
  };

  /// The pixels whose rays may meet a box.
  Rectangle covered_by(const Eigen::AlignedBox3d& box) const
  {
    constexpr int corners = 8;
    Eigen::Array2d low = Eigen::Array2d::Constant(no_hit), high = -low;
    for(int i = 0; i < corners; ++i) {
      const auto corner = box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i));
      const Vector p = axes_.transpose() * (corner - place_);
      const Eigen::Array2d at(std::atan2(p.x(), p.z()), std::atan2(p.y(), p.z()));
      low = low.min(at / step_);
      high = high.max(at / step_);
    }
    return {low.floor().cast<int>(), high.ceil().cast<int>()};
  }

  std::size_t index(const Pixel& pixel) const
  {
    const Pixel place = pixel - begin_;
    return static_cast<std::size_t>(place.y() * size_.x() + place.x());
  }

  Vector place_;
  Eigen::Matrix3d axes_; ///< right, up, forwards
  double step_;
  Pixel begin_, size_;
  std::vector<double> distances_;
};

} // namespace shapes

#endif // POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_DEPTH_IMAGE_H
