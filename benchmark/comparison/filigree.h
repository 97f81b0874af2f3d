// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_COMPARISON_FILIGREE_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_COMPARISON_FILIGREE_H

#include "generator/families/loops.h"

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

/// A shape like the paper's Filigree (Fig. 5 and 6): a wavy, uneven grid of 5 x 3 holes whose limbs
/// differ in thickness by a factor of two. It has 20 junctions, 15 cycles and no ends. Its limbs
/// are thinner than those of the generator's families, 1.5 to 3.5 % of the diagonal.
inline shapes::Known_shape filigree(unsigned int seed)
{
  using shapes::Vector;
  constexpr int columns = 5, rows = 3;
  const auto corner = [](int x, int y) { return static_cast<std::size_t>(y * (columns + 1) + x); };
  shapes::Random random(seed);
  shapes::Limb corners;
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  for(int y = 0; y <= rows; ++y)
    for(int x = 0; x <= columns; ++x) {
      const double shift_y = random.uniform(-0.12, 0.12), shift_x = random.uniform(-0.12, 0.12);
      corners.push_back({Vector(x + shift_x, y + shift_y, 0.35 * std::sin(1.3 * x + y)),
                         random.uniform(0.09, 0.22)});
      if(x > 0)
        edges.emplace_back(corner(x - 1, y), corner(x, y));
      if(y > 0)
        edges.emplace_back(corner(x, y - 1), corner(x, y));
    }
  shapes::Known_shape shape;
  shapes::families::add_edges(shape, corners, edges);
  shapes::set_counts(shape, 1, columns * rows, 0);
  return shape;
}

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_COMPARISON_FILIGREE_H
