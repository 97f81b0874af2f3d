// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_WAVE_FRONTS_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_WAVE_FRONTS_H

#include "Method.h"

/// Rings of a front that runs over a mesh, collapsed to their centres: Lengauer, Houska, Preiner,
/// "Efficient Point Cloud Skeletonization with Locally Adaptive L1-Medial Projection", section 4.1.
/// Reads the components.
///
/// A wave starts at a seed vertex and takes in n more rings of neighbours at every step. The
/// vertices that it reaches in one step and that hang together are a ring; its centre, the mean of
/// them, is a vertex of the skeleton, and rings that an edge of the mesh joins are joined.
///
/// Left open there, and chosen here:
/// - The seed, "random" there, is a vertex farthest from the first one: the tip of a limb.
/// - n is 3: the last vertices of a front, which no further ones follow, are often no ring but bits
///   of one, and each makes a spur; a wider step leaves fewer of them.
/// - Whether loops stay. They do: a loop of rings is always a loop of the surface. (The library
/// that
///   was used there goes on to a spanning tree, which opens every loop.)
Method_result wave_fronts(const Method_input& input);

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_WAVE_FRONTS_H
