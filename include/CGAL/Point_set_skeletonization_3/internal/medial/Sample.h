// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MEDIAL_SAMPLE_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MEDIAL_SAMPLE_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch.h>

#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// A point in the middle of the shape that belongs to a patch, in normalised coordinates.
struct Sample
{
  Vector3 position = Vector3::Zero();
  double radius = 0; ///< Distance to the nearest patch visible from inside; 0: none is.
};

/// Whether a sample is off its patch, the centre of a medial ball: the other side of the limb was
/// seen.
inline bool is_off_surface(const Sample& sample, const Patch& patch)
{
  constexpr double rounding = 0.01; // spacings
  return (sample.position - patch.mean).norm() > rounding * patch.spacing;
}

using Samples = std::vector<Sample>; ///< One per patch, in their order.

/// Returns the positions, in the same order. O(n).
inline std::vector<Vector3> positions_of(const Samples& samples)
{
  std::vector<Vector3> result;
  result.reserve(samples.size());
  for(const Sample& sample : samples)
    result.push_back(sample.position);
  return result;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MEDIAL_SAMPLE_H
