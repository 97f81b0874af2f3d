// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PUBLISHED_BRANCH_MERGING_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PUBLISHED_BRANCH_MERGING_H


#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Progress.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Union_find.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/minimum_spanning_forest.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Skeleton_graph.h>
#include <CGAL/Point_set_skeletonization_3/internal/published/gaussian_functions.h>

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Two components of a mixture and the square of their distance d_M.
struct Branch_link
{
  std::size_t a, b;
  double squared_distance;

  bool operator<(const Branch_link& other) const
  {
    return std::tie(squared_distance, a, b) < std::tie(other.squared_distance, other.a, other.b);
  }
};

/// Returns the pairs of components that join branches: a minimum spanning tree of the branches
/// under d_M. The paper repeatedly joins the closest two clusters, which gives the same tree. O(n^2
/// log n).
inline std::vector<Branch_link> branch_links(const Gaussians& mixture,
                                             const std::vector<Branch>& branches)
{
  const Squared_mahalanobis_distances distance(mixture);
  Union_find clusters(mixture.size());
  for(const Branch& branch : branches)
    for(std::size_t i : branch)
      clusters.join(branch.front(), i);
  return minimum_spanning_forest<Branch_link>(
    clusters, mixture.size(), [&](const auto& visit) {
      for(std::size_t p = 0; p < branches.size(); ++p) {
        Progress::poll();
        for(std::size_t q = p + 1; q < branches.size(); ++q)
          if(clusters.find(branches[p].front()) != clusters.find(branches[q].front()))
            for(std::size_t i : branches[p])
              for(std::size_t j : branches[q])
                visit(Branch_link{(std::min)(i, j), (std::max)(i, j), distance(i, j)});
      }
    });
}

/// Returns the skeleton through `branches`: vertices at the means of their components, edges along
/// the branches, and, as the last `branches.size() - 1` edges, links between them at the pairs of
/// components closest under d_M. Always a tree, with radii 0; empty without branches. O(n^2 log n).
/// \pre the branches are disjoint and not empty, as those of `detect_branches()` are
inline Skeleton_graph link_branches(const Gaussians& mixture, const std::vector<Branch>& branches)
{
  Skeleton_graph graph;
  std::vector<std::size_t> vertex_of(mixture.size());
  for(const Branch& branch : branches)
    for(std::size_t k = 0; k < branch.size(); ++k) {
      vertex_of[branch[k]] = graph.vertices.size();
      if(k > 0)
        graph.edges.emplace_back(vertex_of[branch[k - 1]], vertex_of[branch[k]]);
      graph.vertices.push_back({mixture[branch[k]].mean, 0, false});
    }
  for(const Branch_link& link : branch_links(mixture, branches))
    graph.edges.emplace_back(vertex_of[link.a], vertex_of[link.b]);
  return graph;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PUBLISHED_BRANCH_MERGING_H
