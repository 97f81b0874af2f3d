// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MEDIAL_SAMPLE_KINDS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MEDIAL_SAMPLE_KINDS_H

#include <CGAL/Point_set_skeletonization_3/Medial_sample_kind.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/principal_axes.h>
#include <CGAL/Point_set_skeletonization_3/internal/medial/Sample.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Surface.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Returns what the patches around patch `i` are like: a line, a sheet or scattered, whichever of
/// linearity, planarity and scattering is greatest (Demantke et al. 2011, from the standard
/// deviations along the principal axes). O(patches around).
inline Medial_sample_kind kind_of_neighborhood(const Surface& surface, std::size_t i)
{
  constexpr double reach = 3; // spacings: about 30 patches of a sheet, 6 of a line
  const Patch& patch = surface.patches[i];
  Vector3 sum = Vector3::Zero();
  Matrix3 products = Matrix3::Zero();
  double number = 0;
  surface.tree.visit_within(patch.mean, reach * patch.spacing, [&](std::size_t k, double) {
    const Gaussian& component = surface.gaussians[surface.tree.order()[k]];
    const Vector3 offset = component.mean - patch.mean;
    sum += offset;
    products += component.covariance + offset * offset.transpose();
    ++number;
  });
  const Matrix3 covariance = products / number - sum * sum.transpose() / (number * number);
  const Vector3 deviations = principal_axes(covariance).variances.cwiseSqrt(); // ascending
  const double linearity = deviations[2] - deviations[1],
               planarity = deviations[1] - deviations[0], scattering = deviations[0];
  if(linearity > planarity && linearity > scattering)
    return Medial_sample_kind::line;
  return planarity > scattering ? Medial_sample_kind::sheet : Medial_sample_kind::scatter;
}

/// Returns what each sample is in the middle of. O(n log n).
inline std::vector<Medial_sample_kind> sample_kinds(const Surface& surface, const Samples& samples)
{
  std::vector<Medial_sample_kind> result;
  for(std::size_t i = 0; i < samples.size(); ++i)
    result.push_back(is_off_surface(samples[i], surface.patches[i])
                       ? Medial_sample_kind::solid
                       : kind_of_neighborhood(surface, i));
  return result;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MEDIAL_SAMPLE_KINDS_H
