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

/// Returns the direction of a path of some length from one place on it to another: that of the
/// chord between them. If it is too short, that of its far half.
template <typename Iterator>
Plain_point direction_between(const Plain_skeleton& skeleton, Iterator begin, Iterator end,
                              double length, double first, double last)
{
  const double reach = last > 0 ? (std::min)(last, length) : length;
  const double start = (std::min)(first, reach / 2);
  return difference(point_along(skeleton, begin, end, reach),
                    point_along(skeleton, begin, end, start));
}

/// Returns the angle between two directions, in degrees, in [0, 180]; not a number if one of them
/// is none.
inline double angle_between(const Plain_point& u, const Plain_point& v)
{
  if(dot(u, u) == 0 || dot(v, v) == 0)
    return std::numeric_limits<double>::quiet_NaN();
  const Plain_point cross{
      {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]}};
  return std::atan2(std::sqrt(dot(cross, cross)), dot(u, v)) * 180 / CGAL_PI;
}

/// Where the angles at a junction are measured, in radii: the path bends inside the limbs that meet
/// there, so directions are those of chords from two to five radii. On round limbs that meet at 12
/// to 120 degrees that is within two degrees, where the first three radii are 15 degrees off.
constexpr double angle_from = 2, angle_to = 5;

/// Returns the radius of a branch near a junction. That of the junction alone would be too small
/// where it lies in a thin limb on a thick one.
inline double radius_near(const Plain_skeleton& skeleton, const Plain_branch& branch,
                          std::size_t junction)
{
  return (std::max)(skeleton.vertices[junction].radius, branch.mean_radius);
}

/// Returns the direction in which a branch leaves the junction where it starts.
inline Plain_point direction_after(const Plain_skeleton& skeleton, const Plain_branch& branch)
{
  const double radius = radius_near(skeleton, branch, branch.vertices.front());
  return direction_between(skeleton, branch.vertices.begin(), branch.vertices.end(), branch.length,
                           angle_from * radius, angle_to * radius);
}

/// Returns the direction in which a branch comes to the junction where it ends, measured `shared`
/// farther away than `direction_after()`, if that is more than its two radii.
inline Plain_point direction_before(const Plain_skeleton& skeleton, const Plain_branch& branch,
                                    double shared)
{
  const double radius = radius_near(skeleton, branch, branch.vertices.back());
  const double first = (std::max)(angle_from * radius, shared);
  const Plain_point back =
      direction_between(skeleton, branch.vertices.rbegin(), branch.vertices.rend(), branch.length,
                        first, first + (angle_to - angle_from) * radius);
  return {{-back[0], -back[1], -back[2]}};
}

/// Returns over which length before a junction the path of the parent runs between the axes of the
/// limbs that part there: where a limb of radius r leaves at an angle a to the one that goes on, it
/// is half inside over 2 r / sin(a).
/// \param directions of the branches that start there, see `direction_after()`
/// \param on the one that goes on
inline double shared_length(const std::vector<const Plain_branch*>& branches,
                            const std::vector<Plain_point>& directions, std::size_t on)
{
  double result = 0;
  for(std::size_t i = 0; i < branches.size(); ++i) {
    const double angle = angle_between(directions[i], directions[on]);
    if(i != on && angle > 0)
      result = (std::max)(result, 2 * branches[i]->mean_radius /
                                      std::sin((std::min)(angle, 90.) * CGAL_PI / 180));
  }
  return result;
}

/// Sets the angles of the branches that start where a parent ends, see `Skeleton_branch_3::angle`.
inline void measure_angles(const Plain_skeleton& skeleton, const Plain_branch& parent,
                           const std::vector<Plain_branch*>& branches)
{
  std::vector<Plain_point> directions;
  for(const Plain_branch* branch : branches)
    directions.push_back(direction_after(skeleton, *branch));
  const auto set_angles = [&](double shared) {
    const Plain_point before = direction_before(skeleton, parent, shared);
    for(std::size_t i = 0; i < branches.size(); ++i)
      branches[i]->angle = angle_between(before, directions[i]);
  };
  set_angles(0);
  const auto straightest = std::min_element(
      branches.begin(), branches.end(),
      [](const Plain_branch* a, const Plain_branch* b) { return a->angle < b->angle; });
  set_angles(shared_length({branches.begin(), branches.end()}, directions,
                           static_cast<std::size_t>(straightest - branches.begin())));
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_BRANCHES_MEASURE_BRANCH_H
