// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_BRANCHING_TREE_H
#define POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_BRANCHING_TREE_H

#include "Known_shape.h"

namespace shapes {

/// A tree that shows how fine the details are that a skeleton still has: a limb has a fork at each
/// end, `levels` times; from level to level limbs are shorter and thinner by a quarter. There is no
/// root: both ends of the first limb are forks, so that there are 2^`levels` ends and two junctions
/// less. The seed turns the tree. Limbs that do not meet are far apart. \pre `levels` > 0
Known_shape branching_tree(int levels, unsigned seed);

} // namespace shapes

#endif // POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_BRANCHING_TREE_H
