// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MEDIAL_SAMPLE_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MEDIAL_SAMPLE_H

#include <CGAL/Medial_sample_3.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>

#include <cstddef>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// A medial sample in normalised coordinates; see `Medial_sample_3`.
struct Sample
{
  Vector3 origin = Vector3::Zero();
  Vector3 position = Vector3::Zero();
  double kernel_radius = 0;
  double radius = 0;
  bool frozen = false;
  bool inside = false; ///< Known to be in the shape where it is.
};

/// How a projection ended.
struct Projection_outcome
{
  std::size_t iterations = 0;
  Projection_stop_reason reason = Projection_stop_reason::empty;
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_MEDIAL_SAMPLE_H
