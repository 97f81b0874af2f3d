// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_INTERFACE_SKELETONIZER_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_INTERFACE_SKELETONIZER_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Point_source.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Progress.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/linkage.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/interface/plain_data.h>
#include <CGAL/Point_set_skeletonization_3/internal/pipeline/Known_topology.h>

#include <cstddef>
#include <memory>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

class Moment_grid;
class Normalization;
struct Options;

/// The stages of the default method and their results, without a kernel: compiled once for all
/// types of points.
class Skeletonizer
{
public:
  /// With the default options.
  explicit Skeletonizer(Concurrency concurrency, const Known_topology& known = Known_topology());

  /// Bounds the number of components of the mixture of points; that of a builder has its own bound.
  void limit_cells(std::size_t maximum_cells);

  /// Makes the cells of the mixture coarser if limbs of this thickness, in the unit of the input,
  /// are found all the same. \pre it is positive and finite
  void limit_features(double smallest_feature);

  Skeletonizer(Skeletonizer&&) noexcept;
  Skeletonizer& operator=(Skeletonizer&&) noexcept;
  ~Skeletonizer();

  /// With other options than the defaults.
  Skeletonizer(Concurrency concurrency, const Options& options);

  // If the callback cancels, a stage throws `Cancelled` and has no result.

  /// Stage 1. Reads the points three times: for the bounding box of their bulk, which normalises
  /// them, for the width of the cells, and for the moments. O(n).
  /// \throws std::invalid_argument that names the first point with a coordinate that is not finite
  void fit_mixture(const Point_source& points, const Progress& progress);

  /// Stage 1 for the moments of a builder, which left out some points far away. O(cells) per step
  /// of the search for the width.
  void fit_mixture(const Moment_grid& points, const Normalization& normalization,
                   std::size_t number_of_far);

  /// Takes a mixture from elsewhere as the result of stage 1.
  /// \throws std::invalid_argument that names the first mean that is not finite
  void set_mixture(const Plain_mixture& mixture);

  /// Stage 2; no samples without points. O(n log n) for n components.
  void project(const Progress& progress);

  /// Takes samples from elsewhere as the result of stage 2. O(n log n).
  /// \throws std::invalid_argument that names the first mean that is not finite
  void set_samples(const Plain_samples& samples);

  /// Stage 3; an empty skeleton without samples. O(n log n) in practice for n samples.
  void link(const Progress& progress);

  /// Results of the stages, in the coordinates of the input.
  Plain_mixture mixture() const;
  Plain_samples samples() const;
  Plain_skeleton skeleton() const;

  /// Which vertex the points of a builder belong to. \pre `link()` is done, after
  /// `fit_mixture()` of a builder
  Plain_assignment assignment() const;

  /// Number of components of the finest level of the mixture, and of samples.
  std::size_t number_of_components() const;
  std::size_t number_of_samples() const;

  /// Number of points that belong to no vertex.
  std::size_t number_of_outliers() const;

  /// Number of points whose vertex is known; 0 for points from a builder.
  std::size_t number_of_points() const;

  /// Fills the list of points of each vertex. O(points). \pre `link()` is done
  void fill_point_indices(const Index_lists& lists) const;

  /// The same. Forgets mixture and samples before, and returns the memory of the points to the
  /// system on the way.
  void fill_point_indices_and_forget(const Index_lists& lists);

  /// Fills the list of samples of each vertex. O(samples). \pre `link()` is done
  void fill_sample_indices(const Index_lists& lists) const;

private:
  struct State;
  std::unique_ptr<State> state_;
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_COMPILED
#include <CGAL/Point_set_skeletonization_3/internal/interface/Skeletonizer_impl.h>
#endif

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_INTERFACE_SKELETONIZER_H
