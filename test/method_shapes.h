// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_TEST_METHOD_SHAPES_H
#define POINT_SET_SKELETONIZATION_3_TEST_METHOD_SHAPES_H

#include "shapes.h"

#include "methods/Method.h"
#include "methods/alpha_wrap.h"

#include <cstddef>
#include <vector>

/// Shapes as the compared methods get them.
namespace shapes {

/// The vector from the nearest point of the axes.
inline Vector from_axes(const Shape& shape, const Vector& p)
{
  const Capsule* nearest = &shape.front();
  for(const Capsule& c : shape)
    if(c.distance_to_axis(p) - c.radius < nearest->distance_to_axis(p) - nearest->radius)
      nearest = &c;
  const Vector along = nearest->b - nearest->a;
  const double t = (p - nearest->a).dot(along) / along.squaredNorm();
  return p - nearest->a - std::min(1.0, std::max(0.0, t)) * along;
}

/// Points of the surface, uniform by area, their normals, and a closed mesh with about as many
/// vertices, which are on the surface.
/// \pre all capsules have the same radius; it should be several times the spacing of the points,
///   0.2 rather than 0.1 for as few as by default
inline Method_input method_input(const Shape& shape, std::size_t number_of_points = 2000,
                                 unsigned int seed = 1)
{
  Method_input input;
  for(const Vector& p : sample(shape, number_of_points, seed)) {
    const Vector normal = from_axes(shape, p).normalized();
    input.points.emplace_back(p.x(), p.y(), p.z());
    input.normals.emplace_back(normal.x(), normal.y(), normal.z());
  }
  constexpr std::size_t factor = 10; // a wrap has far fewer vertices than there are points
  input.components =
      alpha_wrap(to_points<Kernel>(sample(shape, factor * number_of_points, seed + 1)));
  for(Mesh& component : input.components)
    for(const auto v : component.vertices()) {
      Point& p = component.point(v);
      const Vector outward = from_axes(shape, to_vector(p));
      const Vector offset = (shape.front().radius / outward.norm() - 1) * outward;
      p += ::Vector(offset.x(), offset.y(), offset.z());
    }
  return input;
}

} // namespace shapes

#endif // POINT_SET_SKELETONIZATION_3_TEST_METHOD_SHAPES_H
