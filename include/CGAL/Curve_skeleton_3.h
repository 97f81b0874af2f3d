// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVE_SKELETON_3_H
#define CGAL_CURVE_SKELETON_3_H

#include <CGAL/license/Point_set_skeletonization_3.h>

#include <CGAL/Origin.h>

#include <boost/graph/adjacency_list.hpp>

#include <cstdint>
#include <vector>

namespace CGAL {

/// \ingroup PkgPointSetSkeletonization3Ref
///
/// The properties of a vertex of a curve skeleton.
template <typename GeomTraits>
struct Curve_skeleton_vertex_3
{
  /// Position, in the coordinates of the input.
  typename GeomTraits::Point_3 point = typename GeomTraits::Construct_point_3()(ORIGIN);

  /// Distance to the nearest surface visible from the vertex, or, where the other side of the surface
  /// was not seen, the spread of the points around, of which 63 % are nearer to the skeleton: the
  /// deviation of scattered points, about two thirds of half the width of a leaf. >= 0, in the unit
  /// of the input.
  typename GeomTraits::FT radius = 0;

  /// Positions in the input range, ascending, of the points of this vertex. Each input point
  /// belongs to at most one vertex, an outlier to none. As wide as an index of a `Point_set_3`:
  /// with ten million points they take most of the memory of a skeleton.
  std::vector<std::uint32_t> indices;
};

/// \ingroup PkgPointSetSkeletonization3Ref
///
/// The properties of an edge of a curve skeleton.
struct Curve_skeleton_edge_3
{
  /// Whether it was added by the published method to merge separate branches: there may be no
  /// points along it.
  bool is_bridge = false;
};

/// \ingroup PkgPointSetSkeletonization3Ref
///
/// A curve skeleton: an undirected BGL graph with the same layout as
/// `Mean_curvature_flow_skeletonization::Skeleton`, so that `skeleton[v].point` and
/// `split_graph_into_polylines()` work on both.
template <typename GeomTraits>
using Curve_skeleton_3 = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS,
                                               Curve_skeleton_vertex_3<GeomTraits>,
                                               Curve_skeleton_edge_3>;

} // namespace CGAL

#endif // CGAL_CURVE_SKELETON_3_H
