// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_SOLID_H
#define POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_SOLID_H

#include "Random.h"
#include "Round_cone.h"
#include "Rounded_box.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <variant>
#include <vector>

namespace shapes {

/// A union of round cones and rounded boxes.
class Solid
{
public:
  using Primitive = std::variant<Round_cone, Rounded_box>;

  void add(const Primitive& primitive)
  {
    primitives_.push_back(primitive);
    total_area_ += area(primitive);
    areas_up_to_.push_back(total_area_);
  }

  /// Negative inside. Exact outside; inside, a lower bound of the depth.
  double signed_distance(const Vector& p) const
  {
    double distance = std::numeric_limits<double>::infinity();
    for(const Primitive& primitive : primitives_)
      distance = std::min(distance, signed_distance(primitive, p));
    return distance;
  }

  /// On the surface, uniform by area.
  Vector random_point(Random& random) const
  {
    for(;;) {
      const double part = random.uniform() * total_area_;
      const auto chosen = std::upper_bound(areas_up_to_.begin(), areas_up_to_.end() - 1, part);
      const std::size_t i = static_cast<std::size_t>(chosen - areas_up_to_.begin());
      const Vector p =
          std::visit([&](const auto& x) { return x.random_point(random); }, primitives_[i]);
      if(!is_covered(p, i))
        return p;
    }
  }

  Eigen::AlignedBox3d bounding_box() const
  {
    Eigen::AlignedBox3d box;
    for(const Primitive& primitive : primitives_)
      box.extend(std::visit([](const auto& x) { return x.bounding_box(); }, primitive));
    return box;
  }

  void rotate(const Eigen::Matrix3d& rotation)
  {
    for(Primitive& primitive : primitives_)
      std::visit([&](auto& x) { x.rotate(rotation); }, primitive);
  }

private:
  static double area(const Primitive& primitive)
  {
    return std::visit([](const auto& x) { return x.area(); }, primitive);
  }

  static double signed_distance(const Primitive& primitive, const Vector& p)
  {
    return std::visit([&](const auto& x) { return x.signed_distance(p); }, primitive);
  }

  /// Whether a point on the surface of primitive `i` is inside another one. What several have in
  /// common, such as the ball where two limbs meet, belongs to the first of them.
  bool is_covered(const Vector& p, std::size_t i) const
  {
    constexpr double rounding_error = 1e-9; // the shapes have a size of about one
    for(std::size_t j = 0; j < primitives_.size(); ++j)
      if(j != i && signed_distance(primitives_[j], p) < (j < i ? rounding_error : -rounding_error))
        return true;
    return false;
  }

  std::vector<Primitive> primitives_;
  std::vector<double> areas_up_to_;
  double total_area_ = 0;
};

} // namespace shapes

#endif // POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_SOLID_H
