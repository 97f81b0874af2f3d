// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_INTERFACE_SKELETONIZATION_STAGES_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_INTERFACE_SKELETONIZATION_STAGES_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/mixture/Point_source.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Progress.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Skeleton_graph.h>
#include <CGAL/Point_set_skeletonization_3/internal/medial/Sample.h>

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

  /// Takes from the points what it needs of them; before all stages.
  virtual void read(const Point_blocks& points) = 0;

  virtual bool fit(const Progress& progress) = 0;
  virtual bool project(const Progress& progress) = 0;
  virtual bool link(const Progress& progress) = 0;

  /// The level of the mixture that the projection reads. \pre `mixture` is not empty
  virtual const Gaussians& components() const = 0;

  /// Number of points that it can tell the vertex of: none that were streamed.
  virtual std::size_t number_of_points() const = 0;

  /// The vertex of the `p`-th point; `none`: an outlier. \pre the last stage is done
  virtual std::size_t vertex_of_point(std::size_t p) const = 0;

  /// May give back memory: the vertices of the points below `end` will not be asked for again.
  virtual void forget_points_below(std::size_t /* end */) {}

  std::vector<Gaussians> mixture; ///< Finest level first.
  std::vector<Sample> samples;
  Projection_outcome outcome;
  Skeleton_graph graph;
  std::size_t number_of_outliers = 0;
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_INTERFACE_SKELETONIZATION_STAGES_H
