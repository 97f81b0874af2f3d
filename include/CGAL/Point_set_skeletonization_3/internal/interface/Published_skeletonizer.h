// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_INTERFACE_PUBLISHED_SKELETONIZER_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_INTERFACE_PUBLISHED_SKELETONIZER_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Point_source.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Progress.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/linkage.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/interface/plain_data.h>
#include <CGAL/Point_set_skeletonization_3/internal/published/Published_options.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// The stages of the published method and their results; otherwise as `Skeletonizer`.
class Published_skeletonizer
{
public:
  Published_skeletonizer(Concurrency concurrency, const Published_options& options);
  Published_skeletonizer(Published_skeletonizer&&) noexcept;
  Published_skeletonizer& operator=(Published_skeletonizer&&) noexcept;
  ~Published_skeletonizer();

  /// Stage 1: kNN Gaussians and hierarchical EM. O(n log n) in practice.
  /// \throws std::invalid_argument that names the first point with a coordinate that is not finite
  void fit_mixture(const Point_source& points, const Progress& progress);
  /// Stage 2: moves samples to L1-medians of the mixture.
  void project(const Progress& progress);
  /// Stage 3: Algorithm 1 of the paper. O(k^2 log k) for k components of the mixture of the
  /// samples.
  void link(const Progress& progress);

  /// Results of the stages, in the coordinates of the input.
  Plain_mixture mixture() const;
  std::vector<Plain_l1_sample> samples() const;
  Plain_skeleton skeleton() const;

  /// Number of components of the coarsest level of the mixture, of samples, and of the iterations
  /// that moved them.
  std::size_t number_of_components() const;
  std::size_t number_of_samples() const;
  std::size_t number_of_iterations() const;
  std::size_t number_of_points() const;
  /// Number of points far from the bulk, which belong to no vertex.
  std::size_t number_of_outliers() const;

  /// Fills the list of points of each vertex. \pre `link()` is done
  void fill_point_indices(const Index_lists& lists) const;

private:
  struct State;
  std::unique_ptr<State> state_;
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_COMPILED
#include <CGAL/Point_set_skeletonization_3/internal/interface/Published_skeletonizer_impl.h>
#endif

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_INTERFACE_PUBLISHED_SKELETONIZER_H
