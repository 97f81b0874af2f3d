// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_TEST_SHAPES_H
#define POINT_SET_SKELETONIZATION_3_TEST_SHAPES_H

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

/// Shapes whose curve skeleton is known: unions of capsules, that is of tubes with round caps.
namespace shapes {

using Vector = Eigen::Vector3d;

constexpr double pi = 3.14159265358979323846;

struct Capsule
{
  Vector a, b; ///< Ends of the axis.
  double radius;

  double length() const { return (b - a).norm(); }
  double area() const { return 2 * pi * radius * (length() + 2 * radius); }

  double distance_to_axis(const Vector& p) const
  {
    const double t = (p - a).dot(b - a) / (b - a).squaredNorm();
    return (p - a - std::min(1.0, std::max(0.0, t)) * (b - a)).norm();
  }
};

using Shape = std::vector<Capsule>;

inline Shape cylinder(double radius = 0.1)
{
  return {{Vector(-0.5, 0, 0), Vector(0.5, 0, 0), radius}};
}

inline Shape y_junction(double radius = 0.1)
{
  Shape shape;
  for(double angle : {0.3, 2.4, 4.5})
    shape.push_back({Vector::Zero(), Vector(std::cos(angle), std::sin(angle), 0), radius});
  return shape;
}

inline Shape ring(double radius = 0.1)
{
  constexpr int sides = 36;
  Shape shape;
  const auto corner = [](int i) {
    return Vector(std::cos(2 * pi * i / sides), std::sin(2 * pi * i / sides), 0);
  };
  for(int i = 0; i < sides; ++i)
    shape.push_back({corner(i), corner((i + 1) % sides), radius});
  return shape;
}

/// The twelve edges of a cube: five independent cycles.
inline Shape cube_frame(double radius = 0.1)
{
  Shape shape;
  for(int corner = 0; corner < 8; ++corner)
    for(int axis = 0; axis < 3; ++axis)
      if((corner & (1 << axis)) == 0) {
        const Vector a(corner & 1, (corner >> 1) & 1, (corner >> 2) & 1);
        shape.push_back({a, a + Vector::Unit(axis), radius});
      }
  return shape;
}

inline Shape two_parts(double radius = 0.1)
{
  return {{Vector(-0.5, 0, 0), Vector(0.5, 0, 0), radius},
          {Vector(-0.3, 1, 0.2), Vector(0.4, 0.9, -0.4), radius}};
}

/// Distance to the nearest axis of the shape.
inline double distance_to_axes(const Shape& shape, const Vector& p)
{
  double distance = shape.front().distance_to_axis(p);
  for(const Capsule& c : shape)
    distance = std::min(distance, c.distance_to_axis(p));
  return distance;
}

inline Vector random_direction(std::mt19937& generator)
{
  std::normal_distribution<double> normal;
  const double x = normal(generator), y = normal(generator), z = normal(generator);
  return Vector(x, y, z).normalized();
}

/// A point on a capsule, uniformly by area.
inline Vector random_point(const Capsule& c, std::mt19937& generator)
{
  std::uniform_real_distribution<double> uniform;
  const Vector direction = random_direction(generator);
  if(uniform(generator) * c.area() < 4 * pi * c.radius * c.radius) {
    const Vector& end = direction.dot(c.b - c.a) > 0 ? c.b : c.a;
    return end + c.radius * direction;
  }
  const Vector side = (c.b - c.a).cross(direction).normalized();
  return c.a + uniform(generator) * (c.b - c.a) + c.radius * side;
}

/// `size` points on the surface of the union, uniformly by area.
inline std::vector<Vector> sample(const Shape& shape, std::size_t size, unsigned int seed)
{
  std::mt19937 generator(seed);
  std::vector<double> areas;
  for(const Capsule& c : shape)
    areas.push_back(c.area());
  std::discrete_distribution<std::size_t> choice(areas.begin(), areas.end());
  std::vector<Vector> points;
  while(points.size() < size) {
    const std::size_t chosen = choice(generator);
    const Vector p = random_point(shape[chosen], generator);
    bool inside = false;
    for(std::size_t i = 0; i < shape.size(); ++i)
      inside = inside || (i != chosen && shape[i].distance_to_axis(p) < shape[i].radius);
    if(!inside)
      points.push_back(p);
  }
  return points;
}

template <typename Kernel>
std::vector<typename Kernel::Point_3> to_points(const std::vector<Vector>& points)
{
  using FT = typename Kernel::FT;
  std::vector<typename Kernel::Point_3> result;
  for(const Vector& p : points)
    result.emplace_back(static_cast<FT>(p.x()), static_cast<FT>(p.y()), static_cast<FT>(p.z()));
  return result;
}

template <typename Point_3>
Vector to_vector(const Point_3& p)
{
  return Vector(p.x(), p.y(), p.z());
}

} // namespace shapes

#endif // POINT_SET_SKELETONIZATION_3_TEST_SHAPES_H
