// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SKELETON_PRUNING_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SKELETON_PRUNING_H

#include <CGAL/Point_set_skeletonization_3/internal/patch_adjacency.h>
#include <CGAL/Point_set_skeletonization_3/internal/skeleton_branches.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface_quotient.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// A limb is this much longer than half the width of one of its cross-sections. The corner of a
/// plate and a dome are 1, a cone of 60 degrees is 1.7; a finger or toe 3 and more.
constexpr double least_slenderness = 1.25;

/// A limb shows this many patches, a ring around it; fewer are outliers that stick out.
constexpr std::size_t least_patches = 6;

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

/// Removes the ends that are no limbs.
class Spur_pruning
{
public:
  /// The first `separators` vertices of `graph` are cross-sections.
  Spur_pruning(const Skeleton_graph& graph, std::size_t separators,
               const std::vector<Patch>& patches,
               const std::vector<std::vector<std::size_t>>& patches_of)
    : graph_(graph), separators_(separators), patches_(patches), patches_of_(patches_of)
  {}

  /// Marks the vertices of spurs, the least slender first: removing one may turn its junction into a
  /// plain vertex and two short branches into a long one.
  std::vector<bool> spurs() const
  {
    std::vector<bool> removed(graph_.vertices.size(), false);
    for(;;) {
      Skeleton_graph rest = graph_; // with the vertices of `graph_`, so that indices stay
      rest.edges.clear();
      for(const Skeleton_graph::Edge& e : graph_.edges)
        if(!removed[e.first] && !removed[e.second])
          rest.edges.push_back(e);
      const auto adjacency = rest.adjacency();
      double least = least_slenderness;
      Branch spur;
      for(Branch branch : branches(rest)) {
        if(adjacency[branch.front()].size() == 1)
          std::reverse(branch.begin(), branch.end());
        if(branch.size() < 2 || adjacency[branch.front()].size() < 3 ||
           adjacency[branch.back()].size() != 1)
          continue;
        const double s = number_of_patches(branch) < least_patches ? 0 : slenderness(branch);
        if(s < least) {
          least = s;
          spur = branch;
        }
      }
      if(spur.empty())
        return removed;
      for(std::size_t k = 1; k < spur.size(); ++k)
        removed[spur[k]] = true;
    }
  }

private:
  std::size_t number_of_patches(const Branch& branch) const
  {
    std::size_t result = 0;
    for(std::size_t k = 1; k < branch.size(); ++k)
      result += patches_of_[branch[k]].size();
    return result;
  }

  /// The largest ratio of what lies beyond a cross-section of a branch to the width of it, from its
  /// junction to its end.
  double slenderness(const Branch& branch) const
  {
    double result = 0;
    for(std::size_t k = 1; k < branch.size(); ++k) {
      if(branch[k] >= separators_)
        continue;
      const double width = extent(branch[k], branch[k]);
      double length = 0;
      for(std::size_t l = k; l < branch.size(); ++l)
        length = std::max(length, extent(branch[k], branch[l]));
      if(width > 0)
        result = std::max(result, length / width);
    }
    return result;
  }

  /// How far the patches of `w` reach from `v`.
  double extent(std::size_t v, std::size_t w) const
  {
    double result = 0;
    for(std::size_t i : patches_of_[w])
      result = std::max(result, (patches_[i].mean - graph_.vertices[v].position).norm());
    return result;
  }

  const Skeleton_graph& graph_;
  std::size_t separators_;
  const std::vector<Patch>& patches_;
  const std::vector<std::vector<std::size_t>>& patches_of_;
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SKELETON_PRUNING_H
