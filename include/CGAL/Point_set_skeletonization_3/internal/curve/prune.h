// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_PRUNE_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_PRUNE_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Progress.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Curve_options.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Measured_components.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Skeleton_graph.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/branches.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/bridges.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/stray_components.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/surface_quotient.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch_groups.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Returns the graph without the vertices marked `removed` and their edges, in the same order.
/// O(n).
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

/// Marks the piece beyond the last separator of each limb as removed: a cap has no centre, and the
/// tip is found from the separator before it. O(n).
inline void mark_caps(const Skeleton_graph& graph, std::vector<bool>& removed)
{
  std::vector<std::vector<std::size_t>> adjacency(graph.vertices.size());
  for(const Skeleton_graph::Edge& e : graph.edges)
    if(!removed[e.first] && !removed[e.second]) {
      adjacency[e.first].push_back(e.second);
      adjacency[e.second].push_back(e.first);
    }
  const auto is_cap = [&](std::size_t v) {
    return !graph.vertices[v].is_cross_section && adjacency[v].size() == 1;
  };
  for(std::size_t v = 0; v < adjacency.size(); ++v) {
    if(!is_cap(v))
      continue;
    // A single separator between two caps keeps them: one vertex has no direction.
    const std::vector<std::size_t>& next = adjacency[adjacency[v].front()];
    removed[v] = std::count_if(next.begin(), next.end(), is_cap) == 1;
  }
}

/// Finds branches that are no limbs, and bridges of a few outliers.
class Spur_pruning
{
public:
  /// `surface[v]` are the surface points of vertex v. Refers to all arguments.
  Spur_pruning(const Skeleton_graph& graph, const std::vector<std::vector<Vector3>>& surface,
               const Curve_options& options)
    : options_(options), graph_(graph), surface_(surface)
  {}

  /// Returns a mark for each vertex of a spur. The least slender is removed first: then its
  /// junction may have degree 2 and two short branches become a long one. O(n log n) per spur.
  std::vector<bool> spurs() const
  {
    std::vector<bool> removed(graph_.vertices.size(), false);
    for(;;) {
      Progress::poll();
      Skeleton_graph rest = graph_; // with all vertices, so that indices stay
      rest.edges.clear();
      for(const Skeleton_graph::Edge& e : graph_.edges)
        if(!removed[e.first] && !removed[e.second])
          rest.edges.push_back(e);
      const auto adjacency = rest.adjacency();
      // The ends of a branch stay connected without it if it has no bridge.
      const std::vector<std::size_t> part = parts_between_bridges(rest);
      double least = options_.slenderness;
      Branch spur;
      for(Branch branch : branches(rest)) {
        if(adjacency[branch.front()].size() == 1)
          std::reverse(branch.begin(), branch.end());
        if(branch.size() < 2 || adjacency[branch.front()].size() < 3 ||
           adjacency[branch.back()].size() == 2)
          continue;
        const bool ends = adjacency[branch.back()].size() == 1;
        const bool thin =
            static_cast<double>(number_of_points(branch, ends)) < options_.least_points;
        if(!ends && (branch.size() < 3 || !thin || part[branch[0]] != part[branch[1]]))
          continue;
        const double s = thin ? 0 : slenderness(branch);
        if(s < least) {
          least = s;
          spur = branch;
        }
      }
      if(spur.empty())
        return removed;
      for(std::size_t k = 1; k < spur.size(); ++k)
        removed[spur[k]] = adjacency[spur[k]].size() < 3;
    }
  }

private:
  /// Number of surface points of a branch, without its junctions; `ends`: at a tip.
  std::size_t number_of_points(const Branch& branch, bool ends) const
  {
    std::size_t result = 0;
    for(std::size_t k = 1; k + (ends ? 0 : 1) < branch.size(); ++k)
      result += surface_[branch[k]].size();
    return result;
  }

  /// The largest ratio of the length beyond a cross-section of a branch, from junction to tip, to
  /// half its width.
  double slenderness(const Branch& branch) const
  {
    double result = 0;
    for(std::size_t k = 1; k < branch.size(); ++k) {
      if(!graph_.vertices[branch[k]].is_cross_section)
        continue;
      const std::vector<double> width = distances(branch, k, k + 1);
      const std::vector<double> length = distances(branch, k, branch.size());
      // Without the furthest 5 %, at least two: outliers stick out of the surface.
      const std::size_t last = length.size() - 1;
      const std::size_t reached = last - (std::min)(last, (std::max<std::size_t>)(2, last / 20));
      if(width.back() > 0)
        result = (std::max)(result, length[reached] / width.back());
    }
    return result;
  }

  /// Distances of the surface points of the vertices [`k`, `end`) of a branch from the `k`-th,
  /// ascending.
  std::vector<double> distances(const Branch& branch, std::size_t k, std::size_t end) const
  {
    std::vector<double> result;
    for(std::size_t l = k; l < end; ++l)
      for(const Vector3& p : surface_[branch[l]])
        result.push_back((p - graph_.vertices[branch[k]].position).norm());
    std::sort(result.begin(), result.end());
    return result;
  }

  const Curve_options& options_;
  const Skeleton_graph& graph_;
  const std::vector<std::vector<Vector3>>& surface_;
};

/// A quotient graph without spurs and stray components.
struct Pruned_quotient
{
  Skeleton_graph graph;
  std::vector<bool> is_stray; ///< For each vertex of the quotient: it consists of outliers.
};

/// Part 3c: removes stray components, unless they may be fragments, spurs and caps. `components`
/// are the positions of the mixture components, and `groups` those of each patch. O(n log n) per
/// spur.
inline Pruned_quotient prune(const Surface_quotient& quotient, const Patches& patches,
                             const std::vector<Vector3>& components, const Patch_groups& groups,
                             const Curve_options& options)
{
  const Skeleton_graph& graph = quotient.graph;
  std::vector<double> weights(graph.vertices.size(), 0); // numbers of points
  std::vector<std::vector<Vector3>> points(graph.vertices.size());
  for(std::size_t i = 0; i < patches.size(); ++i) {
    const std::size_t v = quotient.vertex_of_patch[i];
    weights[v] += patches[i].weight;
    for(std::size_t k : groups[i])
      points[v].push_back(components[k]);
  }
  Pruned_quotient result;
  result.is_stray = stray_vertices(graph, weights, options.stray_share);
  const Measured_components parts(graph, weights);
  for(std::size_t v = 0; v < weights.size(); ++v) { // fragments may yet be joined
    const Curve_evidence& curve = parts.of(v).curve;
    if(curve.is_open() && curve.evidence() >= options.limb_evidence)
      result.is_stray[v] = false;
  }
  std::vector<bool> removed = Spur_pruning(graph, points, options).spurs();
  for(std::size_t v = 0; v < removed.size(); ++v)
    removed[v] = removed[v] || result.is_stray[v];
  mark_caps(graph, removed);
  result.graph = without(graph, removed);
  return result;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_PRUNE_H
