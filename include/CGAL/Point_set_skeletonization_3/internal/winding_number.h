// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_WINDING_NUMBER_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_WINDING_NUMBER_H

#include <CGAL/Point_set_skeletonization_3/internal/parallel_for.h>
#include <CGAL/Point_set_skeletonization_3/internal/patch_adjacency.h>

#include <CGAL/number_utils.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// The generalised winding number of oriented patches at `q` (Barill et al. 2018, dipole terms):
/// 1 inside, 0 outside, in between near holes. Patches closer than half their spacing are left out:
/// a dipole says nothing about its own neighbourhood.
inline double winding_number(const std::vector<Patch>& patches, const Vector3& q)
{
  double sum = 0;
  for(const Patch& patch : patches) {
    const Vector3 d = patch.mean - q;
    const double squared = d.squaredNorm();
    if(squared > 0.25 * patch.spacing * patch.spacing)
      sum += patch.planarity * patch.area * patch.normal.dot(d) / (squared * std::sqrt(squared));
  }
  return sum / (4 * CGAL_PI);
}

/// Turns the patches around that have more inside in front of them than behind: the spanning tree
/// of the orientation may have taken a wrong turn at a thin or sharp place, the rest of the surface
/// outvotes it.
template <typename ConcurrencyTag>
void settle_orientation(std::vector<Patch>& patches)
{
  std::vector<char> wrong(patches.size(), 0);
  parallel_for<ConcurrencyTag>(patches.size(), [&](std::size_t i) {
    const Vector3 step = patches[i].spacing * patches[i].normal;
    wrong[i] = winding_number(patches, patches[i].mean + step) >
               winding_number(patches, patches[i].mean - step);
  });
  for(std::size_t i = 0; i < patches.size(); ++i)
    if(wrong[i])
      patches[i].normal = -patches[i].normal;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_WINDING_NUMBER_H
