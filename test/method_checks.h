// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_TEST_METHOD_CHECKS_H
#define POINT_SET_SKELETONIZATION_3_TEST_METHOD_CHECKS_H

#include "catch2.h"
#include "graph_counts.h"
#include "shapes.h"
#include "skeleton_checks.h"

#include "methods/Method.h"

#include <algorithm>
#include <cstddef>
#include <vector>

/// What the compared methods have to make of the shapes.
namespace shapes {

/// The topology of a valid skeleton; its stages are named.
inline Graph_counts counts_of(const Method_result& result, const Method_input& input)
{
  check_valid(result.skeleton, input.points.size());
  REQUIRE(!result.stages.empty());
  for(const auto& stage : result.stages)
    CHECK(stage.second >= 0);
  return count_graph(result.skeleton);
}

/// Distances of the vertices to the nearest axis, in radii, ascending.
inline std::vector<double> off_axis(const Skeleton& skeleton, const Shape& shape)
{
  std::vector<double> distances;
  for(const auto v : boost::make_iterator_range(vertices(skeleton)))
    distances.push_back(distance_to_axes(shape, to_vector(skeleton[v].point)) /
                        shape.front().radius);
  std::sort(distances.begin(), distances.end());
  return distances;
}

inline double median_off_axis(const Skeleton& skeleton, const Shape& shape)
{
  const std::vector<double> distances = off_axis(skeleton, shape);
  REQUIRE(!distances.empty());
  return distances[distances.size() / 2];
}

/// Checks what a method made of a shape: its components, cycles and ends, and how far its vertices
/// are off the axis in the median, in radii.
inline void check_skeleton(const Method_result& result, const Method_input& input,
                           const Shape& shape, std::size_t components, std::size_t cycles,
                           std::size_t ends, double off)
{
  const Graph_counts counts = counts_of(result, input);
  CHECK(counts.components == components);
  CHECK(counts.cycles == cycles);
  CHECK(counts.ends == ends);
  CHECK(median_off_axis(result.skeleton, shape) < off);
}

/// How far off the axis the vertices of a method may be on simple shapes, in radii.
struct Off_axis
{
  double worst_of_cylinder;
  double median_of_tree; ///< Of a cylinder and a Y.
  double median_of_ring;
};

/// Checks a method on simple shapes: a cylinder is one branch, a Y has three ends that meet in one
/// junction, a ring is one cycle. `input_of(shape)` makes its input.
template <typename Method, typename Input_of>
void check_simple_shapes(const Method& method, const Input_of& input_of, const Off_axis& off)
{
  const auto check = [&](const Shape& shape, std::size_t cycles, std::size_t ends, double median) {
    const Method_input input = input_of(shape);
    const Method_result result = method(input);
    check_skeleton(result, input, shape, 1, cycles, ends, median);
    return result.skeleton;
  };
  const Skeleton straight = check(cylinder(), 0, 2, off.median_of_tree);
  CHECK(off_axis(straight, cylinder()).back() < off.worst_of_cylinder);
  CHECK(count_graph(check(y_junction(), 0, 3, off.median_of_tree)).junctions == 1);
  check(ring(), 1, 0, off.median_of_ring);
}

} // namespace shapes

#endif // POINT_SET_SKELETONIZATION_3_TEST_METHOD_CHECKS_H
