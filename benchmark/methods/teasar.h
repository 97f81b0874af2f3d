// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_TEASAR_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_TEASAR_H

#include "Method.h"

/// Paths over a surface to whatever is far from the paths before: Sato, Bitter, Bender, Kaufman,
/// Nakajima, "TEASAR: Tree-structure Extraction Algorithm for Accurate and Robust Skeletons",
/// Pacific Graphics 2000, on the edges of a mesh instead of voxels, as Lengauer, Houska and Preiner
/// compare with it. Reads the components.
///
/// The shortest path from a root to the vertex that is farthest from it is the first branch. Then,
/// until none is left, the vertex farthest from the root among those that are more than a given
/// distance away from all branches is joined to them by the shortest path. The result is a tree and
/// lies on the surface.
///
/// Left open there, and chosen here:
/// - The root is the vertex farthest from an arbitrary one, as Sato et al. have it: an end.
/// - The given distance, which there depends on the distance to the boundary inside and has two
///   parameters: on a surface it has to reach around to the far side of a limb. It is half the
///   girth of a tube that has the volume and the area of the component without its noise, and half
///   as much again.
Method_result teasar(const Method_input& input);

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_TEASAR_H
