// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_TANGENT_BALL_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_TANGENT_BALL_H

#include "Method.h"

/// Tangent balls. J. Ma, S. W. Bae, S. Choi: 3D medial axis point approximation using nearest
/// neighbors and the normal field. The Visual Computer 28, 2012. Needs points and normals.
///
/// For every point a ball that touches the surface there, on the inner side, is shrunk until no
/// point is in it. Its centre is near the medial axis, which is a surface in general.
///
/// The publication ends with these centres. They are joined to a skeleton as in the skeletor
/// library (https://navis-org.github.io/skeletor), which drops the balls whose centres are in
/// others and contracts the surface onto those that stay. Our choices:
/// - Every ball is shrunk from the diagonal of the bounding box. It does not shrink further when
/// the
///   two points it touches are less than 30 degrees apart, as seen from its centre: they are then
///   neighbours on an uneven surface (R. Peters, Geographical point cloud modelling with the 3D
///   medial axis transform, 2018). Without this, most balls of estimated normals end up tiny.
/// - A ball counts only if it is inside by both normals and its centre is in the bounding box.
/// - Larger balls are kept first. A ball is dropped if it is within a kept one that is dilated by
///   1.25: of the balls of a tube those off the axis are (B. Miklos, J. Giesen, M. Pauly, Discrete
///   scale axis representations for 3D geometry, 2010). Dropped if only its centre were in the
///   other, half of the kept balls would be next to the surface.
/// - A point belongs to the nearest of the kept balls that cover its own, and without such a ball
/// to
///   that of the nearest point that has one. There are no faces to tell what is next to what: a
///   point is next to its 8 nearest.
/// - Skeletor keeps a minimum spanning tree, which breaks every cycle. Here the graph is thinned
///   instead (see `Cluster_graph`), so that a ring stays one.
///
/// \throws std::runtime_error if no ball counts
Method_result tangent_ball(const Method_input& input);

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_TANGENT_BALL_H
