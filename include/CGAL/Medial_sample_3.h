// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MEDIAL_SAMPLE_3_H
#define CGAL_MEDIAL_SAMPLE_3_H

#include <CGAL/Gaussian_mixture_3.h>

#include <CGAL/Bbox_3.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {

/// A patch of the surface, and where it moved to in the middle of the shape.
template <typename GeomTraits>
struct Medial_sample_3
{
  /// The patch: the number of its points, their mean once noise is taken off, and the covariance of
  /// what was merged into the patch (zero for a single component).
  Gaussian_component_3<GeomTraits> patch;

  /// Where the sample is, in the coordinates of the input.
  typename GeomTraits::Point_3 point{0, 0, 0};

  /// Distance to the nearest patch that the sample sees from inside, in the unit of the input; >= 0,
  /// and 0 if it sees none.
  typename GeomTraits::FT radius = 0;
};

/// The samples of a shape, as `compute_medial_samples()` leaves them and `link_medial_samples()` takes
/// them; data only.
template <typename GeomTraits>
struct Medial_samples_3
{
  std::vector<Medial_sample_3<GeomTraits>> samples;

  /// The bounding box of the points; empty if it is not known.
  Bbox_3 bbox;

  /// How much noise was taken off the patches, in [0, 1]; 0 if their means lie on the surface as it was
  /// read.
  typename GeomTraits::FT noise = 0;

  /// Points of the surface as it was read, noise and all, each with the position of its sample in
  /// `samples`; in any order. If there are none the means of the patches take their place.
  std::vector<std::pair<typename GeomTraits::Point_3, std::size_t>> surface;
};

} // namespace CGAL

#endif // CGAL_MEDIAL_SAMPLE_3_H
