// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MEDIAL_SAMPLE_3_H
#define CGAL_MEDIAL_SAMPLE_3_H

#include <CGAL/license/Point_set_skeletonization_3.h>

#include <CGAL/Gaussian_mixture_3.h>
#include <CGAL/Point_set_skeletonization_3/Medial_sample_kind.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Origin.h>

#include <cstddef>
#include <vector>

namespace CGAL {

/// \ingroup PkgPointSetSkeletonization3Ref
///
/// A patch of the surface, and its point in the middle of the shape.
template <typename GeomTraits>
struct Medial_sample_3
{
  /// The patch: the number of its points, their mean after denoising, and the covariance of the
  /// components merged into it (zero for a single one).
  Gaussian_component_3<GeomTraits> patch;

  /// Position of the sample, in the coordinates of the input.
  typename GeomTraits::Point_3 point = typename GeomTraits::Construct_point_3()(ORIGIN);

  /// Distance to the nearest patch visible from inside, in the unit of the input; 0 if none is.
  typename GeomTraits::FT radius = 0;

  /// What the sample is in the middle of. For information: linking goes by positions.
  Medial_sample_kind kind = Medial_sample_kind::solid;

  /// Number of the object of the scene that it is a sample of. Each object is linked by itself.
  std::size_t object = 0;
};

/// \ingroup PkgPointSetSkeletonization3Ref
///
/// A point of the surface: a component of the mixture that is no outlier.
template <typename GeomTraits>
struct Medial_surface_point_3
{
  /// As measured.
  typename GeomTraits::Point_3 point = typename GeomTraits::Construct_point_3()(ORIGIN);

  /// The same without noise.
  typename GeomTraits::Point_3 denoised = typename GeomTraits::Construct_point_3()(ORIGIN);

  /// Number of points of the cloud.
  typename GeomTraits::FT weight = 1;

  /// The sample whose patch it is a part of, by its position in `Medial_samples_3::samples`.
  std::size_t sample = 0;
};

/// \ingroup PkgPointSetSkeletonization3Ref
///
/// The samples of a shape, from `compute_medial_samples()` and for `link_medial_samples()`; data
/// only.
template <typename GeomTraits>
struct Medial_samples_3
{
  std::vector<Medial_sample_3<GeomTraits>> samples;

  /// The bounding box of the points; empty if unknown.
  Bbox_3 bbox;

  /// Strength of the noise removed from the patches of each object, in [0, 1]; 0 if they were not
  /// moved, and for objects beyond the last.
  std::vector<typename GeomTraits::FT> noise;

  /// The points that the patches consist of, in any order. Patches are adjacent where their points
  /// are. If there are none, each patch is one point, its mean.
  std::vector<Medial_surface_point_3<GeomTraits>> surface;
};

} // namespace CGAL

#endif // CGAL_MEDIAL_SAMPLE_3_H
