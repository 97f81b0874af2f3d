// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_L1_WLOP_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_L1_WLOP_H

#include "Method.h"

/// L1-medial skeleton. H. Huang, S. Wu, D. Cohen-Or, M. Gong, H. Zhang, G. Li, B. Chen: L1-Medial
/// Skeleton of Point Cloud. ACM Transactions on Graphics 32 (4), 2013. Needs points only.
///
/// Samples of the cloud contract to local L1-medians, with a repulsion that keeps those apart that
/// are along a line. Where they are, they become a branch and stay. Then the neighbourhoods grow,
/// for the parts that are thicker. The samples next to the ends of a branch, its bridges, go on
/// contracting; the branch grows over them, and meets others there.
///
/// What the publication leaves open, with our choice, most of it after the authors' program:
/// - 1000 samples. The least radius is 2 diagonals of the bounding box by the cube root of the
///   number of points, and grows by half of that, both as published, up to the longest side of the
///   box.
/// - With every radius, samples contract until they go 0.0005 of half the longest side (below: the
///   unit) on average, but 30 times at most.
/// - Branches: from the sample of the highest sigma on, over the nearest sample ahead within 0.4
///   units, as long as sigma > 0.9 and the direction turns by less than 25 degrees. 5 samples make
///   a branch, and one more for every time the radius is the least one.
/// - A bridge is the sample ahead, less than 80 degrees aside and 0.33 units away. The branch grows
///   over it if its sigma > 0.8 and the turn is less than 25 degrees.
/// - Samples within 0.05 units of a branch are removed, except for bridges; of two within 0.01
///   units one is. A bridge within 0.08 units of another branch is joined to it; so are ends,
///   finally. Where that would close a loop shorter than 0.5 units it is not done: branches that
///   are side by side would make many.
/// - Samples that never become part of a branch are left out: branches they would join stay apart.
/// - The ellipses that re-centre branches of incomplete clouds are left out.
///
/// \throws std::runtime_error if there is no branch
Method_result l1_wlop(const Method_input& input);

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_L1_WLOP_H
