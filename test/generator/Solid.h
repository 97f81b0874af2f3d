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
#include <optional>
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
    boxes_.push_back(enlarged_box(primitive));
    total_area_ += area(primitive);
    areas_up_to_.push_back(total_area_);
  }

  const std::vector<Primitive>& primitives() const { return primitives_; }

  /// Negative inside. Exact outside; inside, a lower bound of the depth.
  double signed_distance(const Vector& p) const
  {
    double distance = std::numeric_limits<double>::infinity();
    for(const Primitive& primitive : primitives_)
      distance = std::min(distance, signed_distance(primitive, p));
    return distance;
  }

  /// On the surface, uniform by area. \pre there is a primitive
  Vector random_point(Random& random) const
  {
    for(;;)
      if(const std::optional<Vector> p = random_uncovered_point(random))
        return *p;
  }

  /// Of the surface; estimated by the share of the primitives that is not inside others.
  double area(Random& random) const
  {
    if(primitives_.empty())
      return 0;
    constexpr int tries = 20000; // within one per cent, even if half of them are covered
    int uncovered = 0;
    for(int i = 0; i < tries; ++i)
      uncovered += random_uncovered_point(random) ? 1 : 0;
    return total_area_ * uncovered / tries;
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
    std::transform(primitives_.begin(), primitives_.end(), boxes_.begin(), enlarged_box);
  }

private:
  static constexpr double rounding_error = 1e-9; // the shapes have a size of about one

  static double area(const Primitive& primitive)
  {
    return std::visit([](const auto& x) { return x.area(); }, primitive);
  }

  static double signed_distance(const Primitive& primitive, const Vector& p)
  {
    return std::visit([&](const auto& x) { return x.signed_distance(p); }, primitive);
  }

  /// Contains all that is no further from the primitive than rounding errors.
  static Eigen::AlignedBox3d enlarged_box(const Primitive& primitive)
  {
    const Vector margin = Vector::Constant(2 * rounding_error);
    const auto box = std::visit([](const auto& x) { return x.bounding_box(); }, primitive);
    return Eigen::AlignedBox3d(box.min() - margin, box.max() + margin);
  }

  /// Uniform by area on the surfaces of all primitives; nothing where it is inside another one.
  std::optional<Vector> random_uncovered_point(Random& random) const
  {
    const double part = random.uniform() * total_area_;
    const auto chosen = std::upper_bound(areas_up_to_.begin(), areas_up_to_.end() - 1, part);
    const std::size_t i = static_cast<std::size_t>(chosen - areas_up_to_.begin());
    const Vector p =
        std::visit([&](const auto& x) { return x.random_point(random); }, primitives_[i]);
    return is_covered(p, i) ? std::nullopt : std::optional<Vector>(p);
  }

  /// Whether a point on the surface of primitive `i` is inside another one. What several have in
  /// common, such as the ball where two limbs meet, belongs to the first of them.
  bool is_covered(const Vector& p, std::size_t i) const
  {
    for(std::size_t j = 0; j < primitives_.size(); ++j)
      if(j != i && boxes_[j].contains(p) &&
         signed_distance(primitives_[j], p) < (j < i ? rounding_error : -rounding_error))
        return true;
    return false;
  }

  std::vector<Primitive> primitives_;
  std::vector<Eigen::AlignedBox3d> boxes_; ///< of the primitives; most are far from a point
  std::vector<double> areas_up_to_;
  double total_area_ = 0;
};

} // namespace shapes

#endif // POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_SOLID_H
