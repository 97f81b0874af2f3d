// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_EDGE_COLLAPSE_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_EDGE_COLLAPSE_H

#include "laplacian_contraction.h"

#include <Eigen/Core>

#include <cstddef>
#include <map>
#include <set>
#include <vector>

namespace methods {

/// Vertices, edges and triangles whose edges are collapsed until there is no triangle left: the
/// connectivity surgery of Au, Tai, Chu, Cohen-Or, Lee, "Skeleton Extraction by Mesh Contraction",
/// SIGGRAPH 2008, section 5. The vertex i goes to a neighbour j where that costs least:
/// - the shape cost, the squared distances of j to the lines of all edges that went to i and j;
/// - 0.1 times the sampling cost, the length of ij times those of all edges at i.
/// Only edges of triangles collapse; one that has lost its triangles stays, as part of the curve.
/// Triangles at the edge become edges, equal triangles one.
///
/// The condition that a neighbour of both i and j has to be in a triangle with them is left out:
/// with it, no tube becomes thinner than three edges around.
class Edge_collapse
{
public:
  Edge_collapse(const Positions& points, const std::vector<Fan>& fans);

  void collapse_all();

  /// The vertices that are left, ascending.
  std::vector<std::size_t> vertices() const;

  /// Whom `i`, which is left, is joined to.
  std::vector<std::size_t> neighbors(std::size_t i) const;

  /// The vertices that went to `i`, and itself.
  const std::vector<std::size_t>& region(std::size_t i) const { return regions_[i]; }

private:
  /// For every neighbour the third vertices of the triangles at that edge.
  using Star = std::map<std::size_t, std::set<std::size_t>>;

  bool is_collapsible(std::size_t i, std::size_t j) const;
  double cost(std::size_t i, std::size_t j) const;
  void collapse(std::size_t i, std::size_t j);
  void add_quadric(std::size_t i, std::size_t j);

  std::vector<Eigen::Vector3d> points_;
  std::vector<Star> stars_;
  std::vector<Eigen::Matrix4d> quadrics_; ///< squared distances to lines
  std::vector<std::vector<std::size_t>> regions_;
};

} // namespace methods

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_EDGE_COLLAPSE_H
