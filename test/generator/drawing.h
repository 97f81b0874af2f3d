// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_DRAWING_H
#define POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_DRAWING_H

#include "Known_shape.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

/// What the families are drawn with.
namespace shapes {

/// A ball on the axis of a limb.
struct Bead
{
  Vector centre;
  double radius;
};

/// The balls along a limb, from end to end.
using Limb = std::vector<Bead>;

inline void add_axis(Known_shape& shape, const Limb& limb)
{
  for(std::size_t i = 1; i < limb.size(); ++i)
    shape.axis.push_back({limb[i - 1].centre, limb[i].centre, limb[i - 1].radius, limb[i].radius});
}

inline void add_limb(Known_shape& shape, const Limb& limb)
{
  for(std::size_t i = 1; i < limb.size(); ++i)
    shape.solid.add(
        Round_cone(limb[i - 1].centre, limb[i].centre, limb[i - 1].radius, limb[i].radius));
  add_axis(shape, limb);
}

/// The limb along `curve`, which maps [0, 1] to beads, in straight pieces.
template <typename Curve>
Limb along(const Curve& curve, int pieces)
{
  Limb limb;
  for(int i = 0; i <= pieces; ++i)
    limb.push_back(curve(static_cast<double>(i) / pieces));
  return limb;
}

/// As above, for a curve that ends where it starts.
template <typename Curve>
Limb along_closed(const Curve& curve, int pieces)
{
  Limb limb = along(curve, pieces);
  limb.back() = limb.front();
  return limb;
}

/// As above, but from and to given points, where other limbs are attached.
template <typename Curve>
Limb along_between(const Vector& begin, const Curve& curve, const Vector& end, int pieces)
{
  Limb limb = along(curve, pieces);
  limb.front().centre = begin;
  limb.back().centre = end;
  return limb;
}

/// From `begin` to `end`, bent towards `bend`, by its length at the middle.
inline Limb bent_limb(const Bead& begin, const Bead& end, const Vector& bend)
{
  constexpr int pieces = 8;
  const auto curve = [&](double t) {
    return Bead{begin.centre + t * (end.centre - begin.centre) + 4 * t * (1 - t) * bend,
                begin.radius + t * (end.radius - begin.radius)};
  };
  return along_between(begin.centre, curve, end.centre, pieces);
}

/// A junction wherever at least three pieces of the axis meet, except where the family has put one.
inline void add_junctions(Known_shape& shape)
{
  std::vector<std::pair<Junction, int>> nodes;
  const auto count = [&](const Vector& position, double radius) {
    const auto known = std::find_if(nodes.begin(), nodes.end(), [&](const auto& node) {
      return node.first.position == position;
    });
    if(known == nodes.end()) {
      nodes.push_back({{position, radius}, 1});
      return;
    }
    known->first.radius = std::max(known->first.radius, radius);
    ++known->second;
  };
  for(const Axis_segment& segment : shape.axis) {
    count(segment.a, segment.radius_a);
    count(segment.b, segment.radius_b);
  }
  const auto is_known = [&](const Vector& position) {
    return std::any_of(shape.junctions.begin(), shape.junctions.end(),
                       [&](const Junction& junction) { return junction.position == position; });
  };
  for(const auto& node : nodes)
    if(node.second >= 3 && !is_known(node.first.position))
      shape.junctions.push_back(node.first);
}

inline void set_counts(Known_shape& shape, std::size_t components, std::size_t cycles,
                       std::size_t ends)
{
  shape.components = components;
  shape.cycles = cycles;
  shape.ends = ends;
}

/// The shape turned about the origin.
inline void rotate(Known_shape& shape, const Eigen::Matrix3d& rotation)
{
  shape.solid.rotate(rotation);
  for(Triangle& triangle : shape.sheets)
    triangle.rotate(rotation);
  for(Axis_segment& segment : shape.axis) {
    segment.a = rotation * segment.a;
    segment.b = rotation * segment.b;
  }
  for(Junction& junction : shape.junctions)
    junction.position = rotation * junction.position;
}

/// What every shape gets when it is drawn.
inline Known_shape finished(Known_shape shape, const Eigen::Matrix3d& rotation,
                            const std::string& family, unsigned seed)
{
  add_junctions(shape);
  rotate(shape, rotation);
  shape.family = family;
  shape.seed = seed;
  return shape;
}

} // namespace shapes

#endif // POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_DRAWING_H
