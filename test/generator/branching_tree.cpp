// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "branching_tree.h"

#include "Random.h"
#include "drawing.h"

#include <cstddef>

namespace shapes {
namespace {

/// Two limbs that leave `fork` to both sides, and at their ends all that follow. The directions are
/// those of the coordinate axes in turns.
void add_fork(Known_shape& shape, const Bead& fork, double length, int level, int levels)
{
  constexpr double shrinking = 0.75; // below 0.79, limbs three levels apart do not meet
  for(const double side : {-1.0, 1.0}) {
    const Vector end = fork.centre + side * length * Vector::Unit(level % 3);
    add_limb(shape, {fork, {end, fork.radius}});
    if(level + 1 < levels)
      add_fork(shape, {end, shrinking * fork.radius}, shrinking * length, level + 1, levels);
  }
}

} // namespace


Known_shape branching_tree(int levels, unsigned seed)
{
  constexpr double length = 1, radius = 0.076; // of half of the first limb
  Known_shape shape;
  add_fork(shape, {Vector::Zero(), radius}, length, 0, levels);
  set_counts(shape, 1, 0, std::size_t(1) << levels);
  return finished(shape, Random(seed).rotation(), "branching_tree", seed);
}

} // namespace shapes
