// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_LAPCON10_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_LAPCON10_H

#include "Method.h"

/// A cloud contracted to a curve: Cao, Tagliasacchi, Olson, Zhang, Su, "Point Cloud Skeletons via
/// Laplacian-Based Contraction", Shape Modeling International 2010. Reads the points.
///
/// The triangles at a point are those of the Delaunay triangulation of its nearest neighbours in
/// their plane. With the cotangent Laplacian of these the points are contracted as the vertices of
/// a mesh are in Au et al. 2008, with s_L = 3, until a step does little. Farthest point samples of
/// what is left own the points nearest to them; samples are joined if they own neighbours in
/// triangles, and the shortest edges that are in triangles of samples are collapsed.
///
/// Left open there, and chosen here:
/// - The neighbours: 0.012 of all points, but 8 to 30, as in the authors' program. So is the
///   distance of samples, 0.02 diagonals.
/// - The extent of a neighbourhood: the root of the area of the triangles at the point.
/// - That a step does little if the sum of the extents falls by less than 0.02 of what it was in
/// the
///   beginning. (0.01 in the program, with extents to the nearest neighbour. With ours, one step
///   too many can contract a limb to a point.)
Method_result lapcon10(const Method_input& input);

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_LAPCON10_H
