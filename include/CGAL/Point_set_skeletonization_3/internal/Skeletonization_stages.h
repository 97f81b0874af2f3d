// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SKELETONIZATION_STAGES_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SKELETONIZATION_STAGES_H

#include <CGAL/Point_set_skeletonization_3/internal/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/Progress.h>
#include <CGAL/Point_set_skeletonization_3/internal/Skeleton_graph.h>
#include <CGAL/Point_set_skeletonization_3/internal/samples.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// The stages points -> mixture -> samples -> graph and what they hand on; one implementation for
/// the default and one for the published method. Every stage returns `false` if it was cancelled.
class Skeletonization_stages
{
public:
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  virtual ~Skeletonization_stages() = default;

  /// `points` in normalised coordinates; kept by reference until the last stage is done.
  virtual bool fit(const std::vector<Vector3>& points, const Progress& progress) = 0;
  virtual bool project(const Progress& progress) = 0;
  virtual bool link(const Progress& progress) = 0;

  /// The level of the mixture that the projection reads. \pre `mixture` is not empty
  virtual const Gaussians& components() const = 0;

  std::vector<Gaussians> mixture; ///< Finest level first.
  std::vector<Sample> samples;
  Projection_outcome outcome;
  Skeleton_graph graph;
  std::vector<std::size_t> vertex_of_point; ///< `none`: an outlier. Empty of streamed points.
  std::size_t number_of_outliers = 0;
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SKELETONIZATION_STAGES_H
