// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PUBLISHED_BRANCH_MERGING_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PUBLISHED_BRANCH_MERGING_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Skeleton_graph.h>
#include <CGAL/Point_set_skeletonization_3/internal/published/branch_detection.h>
#include <CGAL/Point_set_skeletonization_3/internal/published/gaussian_functions.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Joins the branches of `link_branches()`: a minimum spanning tree of the branches under d_M, by
/// Prim's algorithm. The paper joins the closest two of all clusters at a time, which is Kruskal's
/// and gives the same tree, since ties are broken in the same way throughout.
class Branch_merging
{
  /// A squared distance and the components that have it, the smaller index first.
  using Link = std::tuple<double, std::size_t, std::size_t>;

public:
  Branch_merging(const Gaussians& mixture, const std::vector<Branch>& branches)
    : distance_(mixture), branches_(branches)
  {
    for(std::size_t b = 0; b < branches.size(); ++b)
      for(std::size_t i : branches[b])
        outside_.push_back({i, b, Link(std::numeric_limits<double>::infinity(), i, i)});
  }

  /// Pairs of components to link, one fewer than there are branches.
  std::vector<Skeleton_graph::Edge> run()
  {
    std::vector<Skeleton_graph::Edge> links;
    for(std::size_t newest = 0; newest < branches_.size();) {
      absorb(newest);
      if(outside_.empty())
        break;
      const Outsider& closest =
        *std::min_element(outside_.begin(), outside_.end(),
                          [](const Outsider& a, const Outsider& b) { return a.link < b.link; });
      links.emplace_back(std::get<1>(closest.link), std::get<2>(closest.link));
      newest = closest.branch;
    }
    return links;
  }

private:
  /// A component that is not yet part of the tree, and its shortest link into the tree.
  struct Outsider
  {
    std::size_t component;
    std::size_t branch;
    Link link;
  };

  /// Moves branch `b` into the tree.
  void absorb(std::size_t b)
  {
    outside_.erase(std::remove_if(outside_.begin(), outside_.end(),
                                  [&](const Outsider& o) { return o.branch == b; }),
                   outside_.end());
    for(Outsider& o : outside_)
      for(std::size_t i : branches_[b])
        o.link = (std::min)(o.link, Link(distance_(o.component, i), (std::min)(o.component, i),
                                         (std::max)(o.component, i)));
  }

  Squared_mahalanobis_distances distance_;
  const std::vector<Branch>& branches_;
  std::vector<Outsider> outside_;
};

/// The skeleton through `branches`: vertices at the means of their components, branch by branch,
/// edges along the branches, and links between them at the pairs of components that are closest
/// under d_M, until everything is connected. Always a tree, whose radii are left 0; empty if there
/// are no branches.
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
      graph.vertices.push_back({mixture[branch[k]].mean, 0});
    }
  for(const Skeleton_graph::Edge& link : Branch_merging(mixture, branches).run())
    graph.edges.emplace_back(vertex_of[link.first], vertex_of[link.second]);
  return graph;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PUBLISHED_BRANCH_MERGING_H
