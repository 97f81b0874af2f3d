// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_LAPCON08_VC_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_LAPCON08_VC_H

#include "Method.h"

/// A mesh contracted to a curve, and its vertices clustered: Au, Tai, Chu, Cohen-Or, Lee, "Skeleton
/// Extraction by Mesh Contraction", SIGGRAPH 2008, with the clusters that Lengauer, Houska and
/// Preiner compare with instead of edge collapses. Reads the components.
///
/// The vertices of the contracted mesh are clustered such that each is within a distance of the
/// seed of its cluster along the edges. Clusters that an edge of the mesh joins are joined; a
/// vertex of the skeleton is at the mean of its cluster.
///
/// Left open there, and chosen here:
/// - The contraction stops where Au et al. stop it, at a millionth of the volume, or earlier where
///   it no longer shrinks the surface.
/// - The distance: 0.02 diagonals of the mesh's box, as for the samples of Cao et al. 2010.
/// - The seeds: each is the vertex farthest from those before. Clusters that grow one after the
/// other
///   leave scraps between them, and spurs.
/// - How the clusters become a curve where three and more of them meet: as those of Cao et al., by
///   collapsing the shortest edge that is in a triangle. (The library that was used there takes a
///   spanning tree, which opens every loop.)
Method_result lapcon08_vc(const Method_input& input);

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_LAPCON08_VC_H
