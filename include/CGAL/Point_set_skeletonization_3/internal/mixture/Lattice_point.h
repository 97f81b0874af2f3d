// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MIXTURE_LATTICE_POINT_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MIXTURE_LATTICE_POINT_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>

#include <array>
#include <cstdint>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// A point in normalised coordinates, rounded to multiples of 2^-`lattice_level`: integers, whose
/// sums do not depend on the order.
using Lattice_point = std::array<std::int64_t, 3>;

/// A step of the lattice is a 2^28th of the finest cell, so less than a nanometre in a box of ten
/// kilometres; and the squares of 2^40 points add up in 128 bits.
constexpr int lattice_level = 44;
constexpr double lattice_steps = 0x1p44; ///< Per unit of length.

/// Rounds a point to the nearest place of the lattice. \pre its coordinates are in [-1, 1]
inline Lattice_point lattice_point(const Vector3& p)
{
  // Rounds a number of less than 52 bits; std::llrint() would be a function call.
  constexpr double to_integer = 0x1.8p52;
  const auto rounded = [](double x) {
    return static_cast<std::int64_t>((x * lattice_steps + to_integer) - to_integer);
  };
  return {{rounded(p[0]), rounded(p[1]), rounded(p[2])}};
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MIXTURE_LATTICE_POINT_H
