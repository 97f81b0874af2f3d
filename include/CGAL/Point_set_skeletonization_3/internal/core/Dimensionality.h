// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_DIMENSIONALITY_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_DIMENSIONALITY_H

#include <CGAL/Point_set_skeletonization_3/Medial_sample_kind.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/principal_axes.h>

#include <algorithm>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// How much some patches are like a line, a sheet, or scattered; together 1 (Demantke et al. 2011,
/// from the standard deviations along the principal axes).
struct Dimensionality
{
  double linearity = 0, planarity = 0, scattering = 0;
  double components = 0; ///< How many mixture components they are made of.

  /// Whichever is greatest; they are a line or a sheet if it is more than what as few scattered
  /// components show by chance.
  Medial_sample_kind kind() const
  {
    if((std::max)(linearity, planarity) - anisotropy_by_chance(components) <= scattering)
      return Medial_sample_kind::scatter;
    return linearity > planarity ? Medial_sample_kind::line : Medial_sample_kind::sheet;
  }
};

/// Returns what patches of this covariance are like. O(1).
inline Dimensionality dimensionality(const Matrix3& covariance, double components)
{
  const Vector3 deviations = principal_axes(covariance).variances.cwiseSqrt(); // ascending
  if(!(deviations[2] > 0))
    return {0, 0, 0, components};
  return {(deviations[2] - deviations[1]) / deviations[2],
          (deviations[1] - deviations[0]) / deviations[2], deviations[0] / deviations[2],
          components};
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_DIMENSIONALITY_H
