// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SKELETON_PRUNING_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SKELETON_PRUNING_H

#include <CGAL/Point_set_skeletonization_3/internal/skeleton_branches.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// A limb's end reaches out of every other ball of the skeleton by this factor; less is a bump of
/// the surface, or what is left of a thick body's medial sheet.
constexpr double prominence = 1.25;

/// The graph without the vertices marked `removed` and their edges; the order of the rest is kept.
inline Skeleton_graph without(const Skeleton_graph& graph, const std::vector<bool>& removed)
{
  std::vector<std::size_t> index(graph.vertices.size(), 0);
  Skeleton_graph result;
  for(std::size_t v = 0; v < graph.vertices.size(); ++v)
    if(!removed[v]) {
      index[v] = result.vertices.size();
      result.vertices.push_back(graph.vertices[v]);
    }
  for(const Skeleton_graph::Edge& e : graph.edges)
    if(!removed[e.first] && !removed[e.second])
      result.edges.emplace_back(index[e.first], index[e.second]);
  return result;
}

/// The values of the vertices not marked `removed`.
template <typename T>
std::vector<T> without(const std::vector<T>& values, const std::vector<bool>& removed)
{
  std::vector<T> result;
  for(std::size_t v = 0; v < values.size(); ++v)
    if(!removed[v])
      result.push_back(values[v]);
  return result;
}

/// How far a branch that hangs on a junction reaches out of the balls of all other vertices, in
/// radii of the ball that holds it best; infinite for branches between two junctions or two ends.
inline double branch_prominence(const Branch& branch, const Skeleton_graph& graph,
                                const std::vector<std::vector<std::size_t>>& adjacency)
{
  constexpr double none = std::numeric_limits<double>::infinity();
  const std::size_t a = branch.front(), b = branch.back();
  const bool ends_at_a = adjacency[a].size() == 1 && adjacency[b].size() > 2;
  const bool ends_at_b = adjacency[b].size() == 1 && adjacency[a].size() > 2;
  if(!ends_at_a && !ends_at_b)
    return none;
  const Skeleton_graph::Vertex& end = graph.vertices[ends_at_a ? a : b];
  std::vector<bool> in_branch(graph.vertices.size(), false);
  for(std::size_t v : branch)
    in_branch[v] = adjacency[v].size() < 3;
  double least = none;
  for(std::size_t v = 0; v < graph.vertices.size(); ++v)
    if(!in_branch[v] && graph.vertices[v].radius > 0)
      least = std::min(least, ((end.position - graph.vertices[v].position).norm() + end.radius) /
                                graph.vertices[v].radius);
  return least;
}

/// The surface that a vertex stands for.
struct Surface_share
{
  double patches = 0;                ///< Number of patches.
  Vector3 normals = Vector3::Zero(); ///< Sum of their normals, each as long as it can be trusted.
};

/// Patches that a branch of its own shows at the least: a ring around it. Fewer are a fold of the
/// surface or a twig of a flat part.
constexpr double least_patches = 6;

/// Normals around a limb cancel, up to its cone's; a spur into a fold or a bump has the surface on
/// one side. Length of the mean normal across the branch from which on it is a spur: 0 a full ring,
/// 0.64 the normals of half a ring, 1 a plane.
constexpr double one_sided = 0.5;

/// How much a branch that ends stands out, 1 being just enough to stay; infinite for others.
inline double branch_salience(const Branch& branch, const Skeleton_graph& graph,
                              const std::vector<std::vector<std::size_t>>& adjacency,
                              const std::vector<Surface_share>& surface)
{
  const double p = branch_prominence(branch, graph, adjacency);
  if(p == std::numeric_limits<double>::infinity())
    return p;
  Surface_share sum;
  for(std::size_t v : branch)
    if(adjacency[v].size() < 3) {
      sum.patches += surface[v].patches;
      sum.normals += surface[v].normals;
    }
  const Vector3 axis = (graph.vertices[branch.back()].position -
                        graph.vertices[branch.front()].position).normalized();
  const double across = (sum.normals - axis.dot(sum.normals) * axis).norm();
  const double sidedness = sum.patches > 0 ? across / sum.patches : 0;
  return std::min({p / prominence, sum.patches / least_patches, one_sided / sidedness});
}

/// Removes spurs, the least salient first: removing one may turn its junction into a plain vertex
/// and two short branches into a long one. `surface` tells what every vertex stands for.
inline Skeleton_graph pruned(Skeleton_graph graph, std::vector<Surface_share> surface)
{
  for(;;) {
    const auto adjacency = graph.adjacency();
    double least = 1;
    Branch spur;
    for(const Branch& branch : branches(graph)) {
      const double salience = branch_salience(branch, graph, adjacency, surface);
      if(salience < least) {
        least = salience;
        spur = branch;
      }
    }
    if(spur.empty())
      return graph;
    std::vector<bool> removed(graph.vertices.size(), false);
    for(std::size_t v : spur)
      removed[v] = adjacency[v].size() < 3;
    surface = without(surface, removed);
    graph = without(graph, removed);
  }
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SKELETON_PRUNING_H
