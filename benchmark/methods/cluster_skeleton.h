// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_CLUSTER_SKELETON_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_CLUSTER_SKELETON_H

#include "Method.h"
#include "neighborhoods.h"

#include <Eigen/Core>

#include <cstddef>
#include <limits>
#include <set>
#include <tuple>
#include <vector>

namespace methods {

/// Of points that no cluster owns.
constexpr std::size_t no_cluster = std::numeric_limits<std::size_t>::max();

/// A vertex of the skeleton to be, and the input points it stands for.
struct Cluster
{
  Eigen::Vector3d center;
  double radius = 0;
  std::vector<std::size_t> points;
};

/// Points without a cluster get that of the nearest point, in steps to the next, that has one.
void spread(std::vector<std::size_t>& owner, const Neighbors& neighbors);

/// Clusters of points joined to a graph, which is then thinned to a curve skeleton: clusters are
/// adjacent if points of them are.
class Cluster_graph
{
public:
  /// `owner[i]` is the cluster of point `i` or `no_cluster`, `neighbors[i]` the points next to it.
  Cluster_graph(std::vector<Cluster> clusters, const std::vector<std::size_t>& owner,
                const Neighbors& neighbors);

  /// Collapses edges of triangles, the shortest first, until there is no triangle left: the
  /// topological thinning of Cao et al., Point Cloud Skeletons via Laplacian Based Contraction,
  /// 2010.
  void collapse_triangles();

  /// Keeps of the edges, the shortest first, those whose ends are not yet joined by a path at most
  /// `stretch` times as long: the greedy spanner of Althöfer et al., On sparse spanners of weighted
  /// graphs, 1993. It has no cycles shorter than 1 + `stretch` times their longest edge.
  void keep_spanner(double stretch);

  /// Clusters that are still there, in order. A collapsed one has no points.
  std::vector<Cluster>& clusters() { return clusters_; }

  /// Positions in `clusters()` of those adjacent to `c`.
  const std::set<std::size_t>& adjacent(std::size_t c) const { return adjacent_[c]; }

  Skeleton skeleton() const;

private:
  using Edge = std::tuple<double, std::size_t, std::size_t>; // squared length, smaller, larger end

  Edge edge(std::size_t a, std::size_t b) const;
  bool has_path(std::size_t from, std::size_t to, double max_length) const;
  bool in_triangle(std::size_t a, std::size_t b) const;
  void collapse(std::size_t kept, std::size_t gone);

  std::vector<Cluster> clusters_;
  std::vector<std::set<std::size_t>> adjacent_;
};

} // namespace methods

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_CLUSTER_SKELETON_H
