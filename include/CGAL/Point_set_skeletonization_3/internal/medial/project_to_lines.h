// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MEDIAL_PROJECT_TO_LINES_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MEDIAL_PROJECT_TO_LINES_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Dimensionality.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Moments.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/principal_axes.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/Box_tree.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Returns how far a place sees, in spacings: to the first scale at which what is around it is a
/// line, by more than as few places show by chance; else to the last. O(places around).
inline double scale_of_line(const Vector3& place, double spacing, const Box_tree& tree)
{
  constexpr std::array<double, 3> scales{1.3, 1.9, 2.8}; // from the neighbours on a line to
                                                         // what shows the kind of a place
  constexpr double linear = 0.2; // a limb that is not straight, with leaves around it
  constexpr double fewest = 4;   // three are always nearly a line
  for(double scale : scales) {
    Moments moments;
    tree.visit_within(place, scale * spacing, [&](std::size_t k, double) {
      moments.add(1, tree.positions()[k] - place);
    });
    const double number = moments.weight();
    if(number < fewest)
      continue;
    const Dimensionality kind = dimensionality(moments.gaussian(place).covariance, number);
    if(kind.linearity - anisotropy_by_chance(number) > linear)
      return scale;
  }
  return scales.back();
}

/// Returns places moved to the middle of the limbs that they are scattered around: each to the
/// principal axis of what is around it, straight across that axis, as far away as it takes to see a
/// line. It is the L1-medial projection of the paper for limbs of which nothing was seen from all
/// sides, whose kernels stop growing where what is around is anisotropic; as nothing moves along a
/// limb, samples need not repel each other. Where nothing is a line, as in a crown in leaf, places
/// gather where most of them are. O(n log n) in practice.
/// \param spacings distances of neighbouring places, of each
inline std::vector<Vector3> project_to_lines(std::vector<Vector3> places,
                                             const std::vector<double>& spacings,
                                             Concurrency concurrency)
{
  constexpr int rounds = 2; // the first leaves half of the distance, more take twigs to each other
  std::vector<double> reach(places.size());
  for(int round = 0; round < rounds; ++round) {
    const Box_tree tree(places, concurrency);
    std::vector<Vector3> projected(places.size());
    parallel_for(concurrency, places.size(), [&](std::size_t i) {
      if(round == 0)
        reach[i] = spacings[i] * scale_of_line(places[i], spacings[i], tree);
      Moments moments;
      tree.visit_within(places[i], reach[i], [&](std::size_t k, double squared) {
        const double weight = std::exp(-4 * squared / (reach[i] * reach[i])); // below 2 %: none
        moments.add(weight, tree.positions()[k] - places[i]);
      });
      const Gaussian around = moments.gaussian(places[i]);
      const Vector3 axis = principal_axes(around.covariance).directions.col(2);
      const Vector3 offset = around.mean - places[i];
      projected[i] = places[i] + offset - axis.dot(offset) * axis;
    });
    places = std::move(projected);
  }
  return places;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MEDIAL_PROJECT_TO_LINES_H
