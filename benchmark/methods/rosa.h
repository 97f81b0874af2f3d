// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_ROSA_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_ROSA_H

#include "Method.h"

/// Rotational symmetry axis. A. Tagliasacchi, H. Zhang, D. Cohen-Or: Curve Skeleton Extraction from
/// Incomplete Point Cloud. ACM Transactions on Graphics 28 (3), 2009. Needs points and normals.
///
/// A slab through every point cuts off the part of the surface around it; the slab turns until its
/// axis is equally inclined to the normals of that part. The point of the skeleton is the one
/// nearest to the lines along these normals. These points are thinned to curves and joined.
///
/// What the publication leaves open, with our choice:
/// - The neighbourhood of a point: 10 of its 20 nearest, with distances along the normals counted
///   three times (the metric of J. Lehtinen et al., A meshless hierarchical representation for
///   light transport, 2008) and normals less than 90 degrees apart. A cut is what these neighbours
///   connect within the slab, which is 3 mean distances of neighbours thick.
/// - The first axes come from the normals of the neighbours. There are 6 steps.
/// - A cut has no centre if its normals are too much alike, or if the centre is further away than
///   the cut extends, as in a flat part or at a joint. Such points get the mean of their
///   neighbours'.
/// - Thinning: 3 times every centre moves to the line through the centres within 0.05 of the
///   diagonal of the bounding box, or to their mean if less than 0.8 of their variance is along it.
/// - Joining: centres are sampled at 0.02 of the diagonal; samples of few centres are dropped;
///   samples are joined that stand for adjacent parts of the surface, but not over detours: a cycle
///   has to be more than four times as long as its longest edge. Collapsing triangles instead, as
///   Cao et al. 2010 do, leaves no shape: a few cuts far from their neighbours' join everything.
/// - Re-centring: vertices that are no junctions move to the point nearest to the normals of the
///   points they stand for, by 0.3 towards the mean of these.
///
/// \throws std::runtime_error if no cut has a centre
Method_result rosa(const Method_input& input);

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_ROSA_H
