// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_REFINE_CURVE_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_REFINE_CURVE_H


#include <CGAL/Point_set_skeletonization_3/internal/curve/Skeleton_graph.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/branches.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Smooths branches; tips, junctions and points of lines stay. Alternates shrinking and slightly
/// larger growing steps (Taubin 1995): bends stay, the zigzag between samples goes. A cycle of few
/// vertices would shrink, and stays. O(n).
inline void smooth(Skeleton_graph& graph)
{
  constexpr int rounds = 10; // smooths over about three vertices to either side
  constexpr double shrink = 0.5, grow = -0.53;
  constexpr std::size_t fewest = 8; // a cycle of seven vertices would shrink by a quarter
  const auto adjacency = graph.adjacency();
  std::vector<bool> moves(graph.vertices.size());
  for(std::size_t v = 0; v < moves.size(); ++v)
    moves[v] = adjacency[v].size() == 2 && !graph.vertices[v].is_on_line;
  for(const Branch& branch : branches(graph))
    if(is_closed(branch) && branch.size() <= fewest) // which names one vertex twice
      for(std::size_t v : branch)
        moves[v] = false;
  for(int step = 0; step < 2 * rounds; ++step) {
    const std::vector<Skeleton_graph::Vertex> old = graph.vertices;
    for(std::size_t v = 0; v < old.size(); ++v)
      if(moves[v]) {
        const Vector3 middle =
          (old[adjacency[v][0]].position + old[adjacency[v][1]].position) / 2;
        graph.vertices[v].position += (step % 2 ? grow : shrink) * (middle - old[v].position);
      }
  }
}

/// Returns the length of each edge of a branch, in steps of its ends.
template <typename Step>
std::vector<double> numbers_of_steps(const Branch& branch, const Skeleton_graph& graph,
                                     const Step& step)
{
  std::vector<double> result;
  for(std::size_t k = 1; k < branch.size(); ++k) {
    const Skeleton_graph::Vertex &a = graph.vertices[branch[k - 1]],
                                 &b = graph.vertices[branch[k]];
    result.push_back(2 * (b.position - a.position).norm() / (step(a) + step(b)));
  }
  return result;
}

/// Returns the graph with vertices about `step(vertex)` apart; tips and junctions stay. A closed
/// branch keeps at least three edges and one between two junctions two: no loops, no parallel
/// edges. O(n + number of steps). \pre `step` is positive
template <typename Step>
Skeleton_graph resampled(const Skeleton_graph& graph, const Step& step)
{
  const auto adjacency = graph.adjacency();
  Skeleton_graph result;
  constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();
  std::vector<std::size_t> index(graph.vertices.size(), none);
  const auto node = [&](std::size_t v) {
    if(index[v] == none) {
      index[v] = result.vertices.size();
      result.vertices.push_back(graph.vertices[v]);
    }
    return index[v];
  };
  for(const Branch& branch : branches(graph)) {
    std::size_t previous = node(branch.front());
    if(branch.size() == 1)
      continue;
    const std::vector<double> steps = numbers_of_steps(branch, graph, step);
    const double total = std::accumulate(steps.begin(), steps.end(), 0.0);
    const bool between_junctions =
      adjacency[branch.front()].size() > 2 && adjacency[branch.back()].size() > 2;
    const double least = is_closed(branch) ? 3 : between_junctions ? 2 : 1;
    const double pieces = (std::max)(least, std::round(total));
    std::size_t edge = 0;
    double before = 0; // steps
    for(double k = 1; k < pieces; ++k) {
      const double there = total * k / pieces;
      for(; edge + 1 < steps.size() && before + steps[edge] < there; ++edge)
        before += steps[edge];
      const double t = steps[edge] > 0 ? (there - before) / steps[edge] : 0;
      result.vertices.push_back(
        between(graph.vertices[branch[edge]], graph.vertices[branch[edge + 1]], t));
      result.edges.emplace_back(previous, result.vertices.size() - 1);
      previous = result.vertices.size() - 1;
    }
    result.edges.emplace_back(previous, node(branch.back()));
  }
  return result;
}

/// Returns the unit direction in which a branch leaves its tip `v`, over a chord of two radii: the
/// last edge alone is unreliable. \pre `v` has degree 1
inline Vector3 tip_direction(std::size_t v, const Skeleton_graph& graph,
                             const std::vector<std::vector<std::size_t>>& adjacency)
{
  const Skeleton_graph::Vertex& end = graph.vertices[v];
  const Branch branch = follow(v, adjacency[v][0], adjacency);
  std::size_t k = 1;
  while(k + 1 < branch.size() &&
        (graph.vertices[branch[k]].position - end.position).norm() < 2 * end.radius)
    ++k;
  return (end.position - graph.vertices[branch[k]].position).normalized();
}

/// Returns how far surface points lie beyond a tip in some direction; 0 if they do not, or if there
/// are fewer than three. O(points).
inline double reach_beyond(const Vector3& tip, const Vector3& direction,
                           const std::vector<Vector3>& points)
{
  std::vector<double> reach;
  for(const Vector3& p : points)
    reach.push_back(direction.dot(p - tip));
  if(reach.size() < 3)
    return 0;
  // The third furthest: two points may be outliers.
  std::nth_element(reach.begin(), reach.begin() + 2, reach.end(), std::greater<double>());
  return (std::max)(0.0, reach[2]);
}

/// Moves tips along their branches until the ball there reaches the furthest of the surface points
/// `surface[v]` of the tip. Halves the step, four times at most, while its end is not `inside`, as
/// in a limb that bends at its end. O(n).
inline void extend_tips(Skeleton_graph& graph, const std::vector<std::vector<Vector3>>& surface,
                        const std::function<bool(const Vector3&)>& inside)
{
  const auto adjacency = graph.adjacency();
  for(std::size_t v = 0; v < adjacency.size(); ++v) {
    if(adjacency[v].size() != 1)
      continue;
    Skeleton_graph::Vertex& end = graph.vertices[v];
    const Vector3 direction = tip_direction(v, graph, adjacency);
    const double reach = reach_beyond(end.position, direction, surface[v]);
    Vector3 step = (std::max)(0.0, reach - end.radius) * direction;
    constexpr int halvings = 4; // the rest is negligible
    for(int halving = 0; halving < halvings && !inside(end.position + step); ++halving)
      step /= 2;
    end.position += step;
  }
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_REFINE_CURVE_H
