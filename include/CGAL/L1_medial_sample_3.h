// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L1_MEDIAL_SAMPLE_3_H
#define CGAL_L1_MEDIAL_SAMPLE_3_H

#include <CGAL/license/Point_set_skeletonization_3.h>

#include <CGAL/Origin.h>

namespace CGAL {

/// \ingroup PkgPointSetSkeletonization3Ref
///
/// A point of the input that the published method moved to the middle of the shape. Lengths are in
/// the unit of the input.
template <typename GeomTraits>
struct L1_medial_sample_3
{
  using FT = typename GeomTraits::FT;
  using Point_3 = typename GeomTraits::Point_3;

  /// Start: a point of the input.
  Point_3 origin = typename GeomTraits::Construct_point_3()(ORIGIN);

  /// Final position.
  Point_3 point = typename GeomTraits::Construct_point_3()(ORIGIN);

  FT kernel_radius = 0; ///< Support radius h of its kernel, > 0 (Eq. 10).
  FT radius = 0;        ///< Distance to the nearest component of the mixture.
};

} // namespace CGAL

#endif // CGAL_L1_MEDIAL_SAMPLE_3_H
