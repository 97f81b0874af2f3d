// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_BRANCHES_MEASURE_BRANCH_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_BRANCHES_MEASURE_BRANCH_H

#include <CGAL/Point_set_skeletonization_3/internal/interface/plain_data.h>
#include <CGAL/Skeleton_branch_3.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

using Plain_branch = Skeleton_branch_3<std::size_t>;

inline Plain_point difference(const Plain_point& a, const Plain_point& b)
{
  return {{a[0] - b[0], a[1] - b[1], a[2] - b[2]}};
}

inline double dot(const Plain_point& a, const Plain_point& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline double distance(const Plain_point& a, const Plain_point& b)
{
  const Plain_point d = difference(a, b);
  return std::sqrt(dot(d, d));
}

/// Sets what can be measured on a branch alone. O(vertices of the branch).
inline void measure_branch(const Plain_skeleton& skeleton, Plain_branch& branch)
{
  const auto at = [&](std::size_t i) -> const Plain_vertex& {
    return skeleton.vertices[branch.vertices[i]];
  };
  double radius_by_length = 0;
  for(std::size_t i = 1; i < branch.vertices.size(); ++i) {
    const double length = distance(at(i - 1).point, at(i).point);
    const double r = at(i - 1).radius, s = at(i).radius;
    branch.length += length;
    radius_by_length += length * (r + s) / 2;
    branch.volume += CGAL_PI / 3 * length * (r * r + r * s + s * s);
  }
  const std::size_t last = branch.vertices.size() - 1;
  branch.chord = distance(at(0).point, at(last).point);
  branch.mean_radius = branch.length > 0 ? radius_by_length / branch.length : at(0).radius;
}

/// Returns the point at a length along a path; its end if that is shorter.
template <typename Iterator>
Plain_point point_along(const Plain_skeleton& skeleton, Iterator begin, Iterator end, double length)
{
  Plain_point at = skeleton.vertices[*begin].point;
  for(Iterator v = std::next(begin); v != end && length > 0; ++v) {
    const Plain_point next = skeleton.vertices[*v].point;
    const double edge = distance(at, next);
    const double share = edge <= length ? 1 : length / edge;
    for(std::size_t k = 0; k < 3; ++k)
      at[k] += share * (next[k] - at[k]);
    length -= edge;
  }
  return at;
}

/// Returns the direction in which a path leaves a junction of this radius. The path bends inside
/// the limbs that meet there, so it is that of the chord from two to five radii: on round limbs
/// that meet at 45 to 120 degrees within a degree, where the first three radii are 15
/// degrees off.
template <typename Iterator>
Plain_point direction_from(const Plain_skeleton& skeleton, Iterator begin, Iterator end,
                           double length, double radius)
{
  constexpr double first = 2, last = 5; // radii
  const double reach = radius > 0 ? (std::min)(last * radius, length) : length;
  const double start = (std::min)(first * radius, reach / 2);
  return difference(point_along(skeleton, begin, end, reach),
                    point_along(skeleton, begin, end, start));
}

/// Returns the angle between the end of one branch and the start of another, see
/// `Skeleton_branch_3::angle`.
inline double angle_between(const Plain_skeleton& skeleton, const Plain_branch& parent,
                            const Plain_branch& branch)
{
  const double radius = skeleton.vertices[branch.vertices.front()].radius;
  const auto& before = parent.vertices;
  const auto& after = branch.vertices;
  const Plain_point u =
      direction_from(skeleton, before.rbegin(), before.rend(), parent.length, radius);
  const Plain_point v = direction_from(skeleton, after.begin(), after.end(), branch.length, radius);
  if(dot(u, u) == 0 || dot(v, v) == 0)
    return std::numeric_limits<double>::quiet_NaN();
  const Plain_point cross{
      {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]}};
  // `u` points back along the parent.
  return std::atan2(std::sqrt(dot(cross, cross)), -dot(u, v)) * 180 / CGAL_PI;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_BRANCHES_MEASURE_BRANCH_H
