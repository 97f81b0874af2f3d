// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_LAPCON08_EC_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_LAPCON08_EC_H

#include "Method.h"

/// A mesh contracted to a curve, and its edges collapsed: Au, Tai, Chu, Cohen-Or, Lee, "Skeleton
/// Extraction by Mesh Contraction", SIGGRAPH 2008. Reads the components.
///
/// The contracted mesh is collapsed until it has no triangles. Then a vertex of the skeleton moves
/// back by what contraction moved its region: by the mean over the boundaries to the neighbouring
/// regions of the mean displacement there; at an end, by that of the whole region.
///
/// Left open there, and chosen here:
/// - The contraction stops where Au et al. stop it, at a millionth of the volume, or earlier where
///   it no longer shrinks the surface. (Lengauer, Houska and Preiner leave the contraction out.)
/// - A boundary is the vertices of the region that are next to one other region, and in the means
///   all of them count alike.
/// - Vertices at a junction are not merged: that changes no topology.
Method_result lapcon08_ec(const Method_input& input);

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_LAPCON08_EC_H
