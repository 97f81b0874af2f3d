// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PUBLISHED_KERNEL_GROWTH_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PUBLISHED_KERNEL_GROWTH_H


#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/principal_axes.h>
#include <CGAL/Point_set_skeletonization_3/internal/published/attraction.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Returns the growth factor nu in [0, 1] of a kernel (Eq. 11 to 13): 1 in isotropic surroundings,
/// near 0 where the samples within the kernel radius `h` are collinear. `near` are those samples,
/// including the one at `center`.
inline double growth_factor(const Vector3& center, double h, const std::vector<Vector3>& positions,
                            const std::vector<std::size_t>& near)
{
  const double n = static_cast<double>(near.size()) - 1;
  if(n <= 2)
    return 1;
  Matrix3 covariance = Matrix3::Zero();
  for(std::size_t j : near) {
    const Vector3 d = center - positions[j];
    covariance += theta(d.squaredNorm(), h) * d * d.transpose();
  }
  const double trace = covariance.trace();
  const double sigma = trace > 0 ? principal_axes(covariance).variances[2] / trace : 0;
  return 1 - (n - 2) / (n - 1) * sigma;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PUBLISHED_KERNEL_GROWTH_H
