// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tangent_ball.h"

#include "cluster_skeleton.h"
#include "neighborhoods.h"

#include <CGAL/number_type_config.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <utility>
#include <vector>

namespace {

using Eigen::Vector3d;
using methods::Point_search;
using methods::no_cluster;

constexpr std::size_t surface_neighbors = 8;     // a ring of them on an even surface
constexpr int max_shrinkings = 50;               // a few are enough; ends what rounding repeats
constexpr double least_shrinking = 1e-6;         // share of the radius
constexpr double least_separation = CGAL_PI / 6; // below, the surface is taken to be uneven
constexpr double dilation = 1.25;                // of a ball that covers others

struct Ball
{
  Vector3d center;
  double radius;
};

// The ball that touches the surface at point `i` and at the point that shrunk it last; its radius
// is 0 if there is no such point, or if its centre is outside by the normal there or by the box.
Ball shrunk_ball(const Point_search& search, const std::vector<Vector3d>& points,
                 const std::vector<Vector3d>& normals, const Eigen::AlignedBox3d& box,
                 std::size_t i)
{
  double radius = box.diagonal().norm();
  const Vector3d& p = points[i];
  std::size_t other = i;
  for(int step = 0; step < max_shrinkings; ++step) {
    const std::size_t nearest = search.nearest(p - radius * normals[i]).index;
    const Vector3d to_p = p - points[nearest];
    const double height = to_p.dot(normals[i]);
    if(height <= 0) // the point itself, or a copy of it
      break;
    const double next = to_p.squaredNorm() / (2 * height); // touches both
    // With the separation angle a seen from the centre, the chord is 2 * next * sin(a / 2).
    const bool is_noise = to_p.norm() < 2 * next * std::sin(least_separation / 2);
    if(is_noise || next > (1 - least_shrinking) * radius)
      break;
    radius = next;
    other = nearest;
  }
  const Vector3d center = p - radius * normals[i];
  const bool is_inside =
      other != i && normals[other].dot(points[other] - center) > 0 && box.contains(center);
  return {center, is_inside ? radius : 0};
}

// Calls `work(j, distance of the centres)` for every ball `j` that is within dilated ball `i`.
template <typename Work>
void for_each_covered(const std::vector<Ball>& balls, const Point_search& centers, std::size_t i,
                      const Work& work)
{
  std::vector<std::size_t> candidates;
  centers.within(balls[i].center, dilation * balls[i].radius, candidates);
  for(const std::size_t j : candidates) {
    const double distance = (balls[j].center - balls[i].center).norm();
    if(distance + balls[j].radius < dilation * balls[i].radius)
      work(j, distance);
  }
}

// Those that are within no larger one, dilated.
std::vector<std::size_t> kept_balls(const std::vector<Ball>& balls, const Point_search& centers)
{
  std::vector<std::size_t> order(balls.size()), kept;
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return balls[a].radius > balls[b].radius; });
  std::vector<char> is_covered(balls.size(), 0);
  for(const std::size_t i : order) {
    if(is_covered[i] || balls[i].radius == 0)
      continue;
    kept.push_back(i);
    for_each_covered(balls, centers, i, [&](std::size_t j, double) { is_covered[j] = 1; });
  }
  return kept;
}

// For every point the nearest of the kept balls, as position in `kept`, that cover its own.
std::vector<std::size_t> owners(const std::vector<Ball>& balls,
                                const std::vector<std::size_t>& kept,
                                const Point_search& centers)
{
  std::vector<std::size_t> owner(balls.size(), no_cluster);
  std::vector<double> least(balls.size(), std::numeric_limits<double>::infinity());
  for(std::size_t k = 0; k < kept.size(); ++k)
    for_each_covered(balls, centers, kept[k], [&](std::size_t j, double distance) {
      if(distance < least[j]) {
        least[j] = distance;
        owner[j] = k;
      }
    });
  return owner;
}

} // namespace

Method_result tangent_ball(const Method_input& input)
{
  Method_result result;
  const std::vector<Vector3d> points = methods::to_eigen(input.points);
  const std::vector<Vector3d> normals = methods::to_eigen(input.normals);
  Eigen::AlignedBox3d box;
  for(const Vector3d& p : points)
    box.extend(p);

  std::vector<Ball> balls;
  timed_stage(result, "balls", [&] {
    const Point_search search(points);
    for(std::size_t i = 0; i < points.size(); ++i)
      balls.push_back(shrunk_ball(search, points, normals, box, i));
  });
  timed_stage(result, "joining", [&] {
    std::vector<Vector3d> centers;
    for(const Ball& ball : balls)
      centers.push_back(ball.center);
    const Point_search center_search(centers);
    const std::vector<std::size_t> kept = kept_balls(balls, center_search);
    if(kept.empty())
      throw std::runtime_error("no ball touches the surface at two points from inside");
    std::vector<std::size_t> owner = owners(balls, kept, center_search);
    const methods::Neighbors neighbors =
        methods::nearest_others(methods::Point_search(points), points, surface_neighbors);
    methods::spread(owner, neighbors);
    std::vector<methods::Cluster> clusters;
    for(const std::size_t k : kept)
      clusters.push_back({balls[k].center, balls[k].radius, {}});
    methods::Cluster_graph graph(std::move(clusters), owner, neighbors);
    graph.collapse_triangles();
    result.skeleton = graph.skeleton();
  });
  return result;
}
