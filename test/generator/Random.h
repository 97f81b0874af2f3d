// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_RANDOM_H
#define POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_RANDOM_H

#include <Eigen/Dense>

#include <cmath>
#include <random>

namespace shapes {

using Vector = Eigen::Vector3d;

constexpr double full_turn = 6.28318530717958647692;

/// Random numbers that do not depend on the standard library: its engines are specified to the bit,
/// its distributions are not. For the same reason no two draws may be operands of one expression or
/// arguments of one call: their order would be the compiler's choice.
class Random
{
public:
  explicit Random(unsigned seed)
      : seed_(seed)
      , engine_(seed)
  {}

  /// In [0, 1).
  double uniform() { return static_cast<double>(engine_()) / 4294967296.0; }

  double uniform(double low, double high) { return low + (high - low) * uniform(); }

  /// In {low, ..., high}.
  int integer(int low, int high)
  {
    return low + static_cast<int>(uniform() * static_cast<double>(high - low + 1));
  }

  /// As `integer()`, but seeds that follow each other take turns: few are enough to see all kinds.
  int in_turn(int low, int high) const
  {
    return low + static_cast<int>(seed_ % static_cast<unsigned>(high - low + 1));
  }

  /// Standard normal, after Box and Muller.
  double normal()
  {
    const double radius = std::sqrt(-2 * std::log(1 - uniform()));
    return radius * std::cos(full_turn * uniform());
  }

  Vector normal_vector()
  {
    const double x = normal(), y = normal(), z = normal();
    return Vector(x, y, z);
  }

  /// Uniform on the unit sphere.
  Vector direction() { return normal_vector().normalized(); }

  /// Uniform in [0, 1)^3.
  Vector uniform_vector()
  {
    const double x = uniform(), y = uniform(), z = uniform();
    return Vector(x, y, z);
  }

  Eigen::Matrix3d rotation()
  {
    const double w = normal();
    const Vector v = normal_vector();
    return Eigen::Quaterniond(w, v.x(), v.y(), v.z()).normalized().toRotationMatrix();
  }

private:
  unsigned seed_;
  std::mt19937 engine_;
};

} // namespace shapes

#endif // POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_RANDOM_H
