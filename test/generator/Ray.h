// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_RAY_H
#define POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_RAY_H

#include "Random.h"
#include "Triangle.h"

#include <algorithm>
#include <limits>

namespace shapes {

struct Ray
{
  Vector origin, direction; ///< the direction has length 1

  Vector at(double distance) const { return origin + distance * direction; }
};

constexpr double no_hit = std::numeric_limits<double>::infinity();

/// Distance along the ray to where it meets a sheet; `no_hit` if it does not. The distance and two
/// coordinates in the triangle solve a linear system (T. Moeller and B. Trumbore).
inline double first_hit(const Triangle& triangle, const Ray& ray)
{
  const Vector u = triangle.b - triangle.a, v = triangle.c - triangle.a;
  const Vector across = ray.direction.cross(v);
  const double determinant = u.dot(across);
  if(determinant == 0)
    return no_hit;
  const Vector offset = ray.origin - triangle.a, moment = offset.cross(u);
  const double s = offset.dot(across) / determinant;
  const double t = ray.direction.dot(moment) / determinant;
  const double distance = v.dot(moment) / determinant;
  return s >= 0 && t >= 0 && s + t <= 1 && distance > 0 ? distance : no_hit;
}

/// As above, for a primitive of a solid: in steps of its distance, which cannot jump over it.
template <typename Primitive>
double first_hit(const Primitive& primitive, const Ray& ray)
{
  constexpr double precision = 1e-7; // of the distance along the ray
  const Eigen::AlignedBox3d box = primitive.bounding_box();
  const Vector inverse = ray.direction.cwiseInverse();
  const Vector to_low = (box.min() - ray.origin).cwiseProduct(inverse);
  const Vector to_high = (box.max() - ray.origin).cwiseProduct(inverse);
  const double end = to_low.cwiseMax(to_high).minCoeff();            // where the ray leaves the box
  double place = std::max(0.0, to_low.cwiseMin(to_high).maxCoeff()); // where it enters
  while(place <= end) {
    const double distance = primitive.signed_distance(ray.at(place));
    if(distance <= precision * place)
      return place;
    place += distance;
  }
  return no_hit;
}

} // namespace shapes

#endif // POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_RAY_H
