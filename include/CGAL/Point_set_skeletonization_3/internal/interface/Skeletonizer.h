// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_INTERFACE_SKELETONIZER_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_INTERFACE_SKELETONIZER_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Point_source.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Progress.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/linkage.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/interface/plain_data.h>

#include <cstddef>
#include <memory>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

class Moment_grid;
class Normalization;
struct Options;

/// The stages of the default method and what each of them leaves, behind an interface without a kernel:
/// what is behind it is compiled once, whatever the user's points are.
class Skeletonizer
{
public:
  explicit Skeletonizer(Concurrency concurrency, bool single_component = false);
  Skeletonizer(Skeletonizer&&) noexcept;
  Skeletonizer& operator=(Skeletonizer&&) noexcept;
  ~Skeletonizer();

  /// The same with other options than the defaults.
  Skeletonizer(Concurrency concurrency, const Options& options);

  // The stages throw `Cancelled` if the callback cancels, and leave nothing of a stage then.

  /// Stage 1, of points, which are read twice and normalised by their bounding box.
  /// \throws std::invalid_argument that names the first point with a coordinate that is not finite
  void fit_mixture(const Point_source& points, const Progress& progress);

  /// Stage 1, of points that were streamed.
  void fit_mixture(const Moment_grid& points, const Normalization& normalization);

  /// Stage 1, of a mixture from elsewhere.
  void set_mixture(const Plain_mixture& mixture);

  /// Stage 2. Of no points there are no samples.
  void project(const Progress& progress);

  /// Stage 2, of samples from elsewhere.
  void set_samples(const Plain_samples& samples);

  /// Stage 3. Of no samples the skeleton is empty.
  void link(const Progress& progress);

  Plain_mixture mixture() const;
  Plain_samples samples() const;
  Plain_skeleton skeleton() const;

  /// Number of components of the finest level of the mixture, and of samples.
  std::size_t number_of_components() const;
  std::size_t number_of_samples() const;

  /// Number of points that belong to no vertex.
  std::size_t number_of_outliers() const;

  /// Number of points whose vertex is known: none that were streamed.
  std::size_t number_of_points() const;

  /// Fills the lists of the points of every vertex. \pre `link()` is done
  void fill_point_indices(const Index_lists& lists) const;

  /// The same; forgets the points, whose memory goes back to the system meanwhile.
  void fill_point_indices_and_forget(const Index_lists& lists);

  /// Fills the lists of the samples of every vertex. \pre `link()` is done
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
