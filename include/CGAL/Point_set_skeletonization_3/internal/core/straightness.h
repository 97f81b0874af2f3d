// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_STRAIGHTNESS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_STRAIGHTNESS_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/principal_axes.h>

#include <cstddef>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// A place and its nearest neighbours, of which there are enough to see a line: two of each side.
/// More of them see the next twig as well, as sparse points of a twig are further apart than twigs.
constexpr std::size_t places_of_line = 5;

/// Whether a few places are straight: across, their standard deviation is less than 0.4 of that
/// along them. O(number of places).
/// \param place `place(k)` is the `k`-th of them, relative to any place near them
template <typename Place>
bool are_straight(std::size_t number, const Place& place)
{
  constexpr double most = 0.4;
  if(number < 3)
    return false;
  Vector3 sum = Vector3::Zero();
  Matrix3 products = Matrix3::Zero();
  for(std::size_t k = 0; k < number; ++k) {
    const Vector3& p = place(k);
    sum += p;
    products += p * p.transpose();
  }
  const auto n = static_cast<double>(number);
  const Vector3 variances =
    principal_axes(products / n - sum * sum.transpose() / (n * n)).variances; // ascending
  return variances[1] < most * most * variances[2];
}

/// Counts how many of the places in some surroundings are straight with their nearest neighbours.
/// One alone is straight by chance; of sparse samples of trees 34 to 71 % are, of places at random
/// in a plane 30 %, and in space 10 %.
struct Straightness
{
  double straight = 0, number = 0;

  void add(bool is_straight)
  {
    straight += is_straight ? 1 : 0;
    ++number;
  }

  /// Whether they are on lines, one or several: more are straight than in a plane.
  bool is_on_lines() const { return straight > 0.35 * number; }
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_STRAIGHTNESS_H
