// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PUBLISHED_L1_MEDIAL_SKELETONIZATION_3_H
#define CGAL_PUBLISHED_L1_MEDIAL_SKELETONIZATION_3_H

#include <CGAL/license/Point_set_skeletonization_3.h>

#include <CGAL/Curve_skeleton_3.h>
#include <CGAL/Gaussian_mixture_3.h>
#include <CGAL/L1_medial_sample_3.h>
#include <CGAL/Point_set_skeletonization_3/internal/interface/Published_skeletonizer.h>
#include <CGAL/Point_set_skeletonization_3/internal/interface/Steps.h>
#include <CGAL/Point_set_skeletonization_3/internal/interface/named_parameters.h>
#include <CGAL/Point_set_skeletonization_3/internal/interface/public_data.h>
#include <CGAL/Point_set_skeletonization_3/internal/interface/published_options_of.h>
#include <CGAL/Point_set_skeletonization_3/published_parameters.h>

#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL {

/// \ingroup PkgPointSetSkeletonization3Ref
///
/// Computes a curve skeleton by the method of Lengauer, Houska and Preiner as published, step by
/// step: the reference for `L1_medial_skeletonization_3`, with the same interface.
///
/// Hierarchical expectation maximization from the nearest neighbours of the points; samples drawn
/// from the points and moved to L1-medians of the mixture with growing kernels; Algorithm 1 of the
/// paper. The result is always a tree.
///
/// \tparam Traits a model of `L1MedialSkeletonizationTraits_3`: any CGAL kernel with inexact
///         constructions over `float` or `double`
/// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` (needs TBB) or
///         `Parallel_if_available_tag`; the result does not depend on it, bit for bit
template <typename Traits, typename ConcurrencyTag = Sequential_tag>
class Published_l1_medial_skeletonization_3
{
  using Progress = Point_set_skeletonization_3::internal::Progress;
  using Skeletonizer = Point_set_skeletonization_3::internal::Published_skeletonizer;
  using Index_lists = Point_set_skeletonization_3::internal::Index_lists;

public:
  using FT = typename Traits::FT;
  using Point_3 = typename Traits::Point_3;
  using Mixture = Gaussian_mixture_3<Traits>;
  using Sample = L1_medial_sample_3<Traits>;
  using Skeleton = Curve_skeleton_3<Traits>;

  /// Refers to the points, which must not change until `fit_mixture()` returns. See
  /// `extract_published_l1_medial_skeleton()` for the named parameters.
  template <typename PointRange, typename NamedParameters = parameters::Default_named_parameters>
  explicit Published_l1_medial_skeletonization_3(
    const PointRange& points, const NamedParameters& np = parameters::default_values())
    : traits_(Point_set_skeletonization_3::internal::traits_of<Traits>(np)),
      steps_(Point_set_skeletonization_3::internal::progress_of(np)),
      skeletonizer_(Point_set_skeletonization_3::internal::concurrency_of<ConcurrencyTag>(),
                    Point_set_skeletonization_3::internal::published_options_of(np))
  {
    namespace internal = Point_set_skeletonization_3::internal;
    static_assert(internal::Has_only_published<NamedParameters>::value,
                  "unknown named parameter: known are point_map, geom_traits, callback, "
                  "maximum_running_time, "
                  "number_of_iterations, random_seed, and those of parameters::published");
    static_assert(internal::Maps_to_points<PointRange, NamedParameters>::value,
                  "the elements of the range are not 3D points: pass point_map(MAP)");
    if constexpr(internal::Maps_to_points<PointRange, NamedParameters>::value) {
      const auto source = internal::point_source(points, internal::point_map_of(points, np));
      fit_ = [source](Skeletonizer& skeletonizer, const Progress& progress) {
        skeletonizer.fit_mixture(source, progress);
      };
    }
  }

  /// Step 1: fits a hierarchy of mixtures to the points.
  /// \returns `false` if the callback cancelled
  /// \throws std::invalid_argument if a coordinate is not finite; the message names the point
  bool fit_mixture()
  {
    return steps_.run(1, 0, 0.1, [this](const Progress& progress) {
      progress(0);
      fit_(skeletonizer_, progress);
      progress(1);
    });
  }

  /// Step 2: moves samples to L1-medians of the mixture.
  /// \returns `false` if the callback cancelled
  /// \pre `fit_mixture()` returned `true`
  bool project()
  {
    CGAL_precondition(steps_.done() >= 1);
    return steps_.run(2, 0.1, 0.8, [this](const Progress& progress) {
      skeletonizer_.project(progress);
      progress(1);
    });
  }

  /// Step 3: links the samples to a tree.
  /// \returns `false` if the callback cancelled
  /// \pre `project()` returned `true`
  bool link()
  {
    CGAL_precondition(steps_.done() >= 2);
    return steps_.run(3, 0.8, 1, [this](const Progress& progress) {
      skeletonizer_.link(progress);
      progress(1);
    });
  }

  /// All steps. \returns `false` if the callback cancelled
  bool run() { return fit_mixture() && project() && link(); }

  /// The mixtures of step 1, in the coordinates of the input, finest level first.
  Mixture mixture() const
  {
    return Point_set_skeletonization_3::internal::to_public(skeletonizer_.mixture(), traits_);
  }

  /// The samples of step 2, a subset of the points, in the coordinates of the input.
  std::vector<Sample> samples() const
  {
    namespace internal = Point_set_skeletonization_3::internal;
    std::vector<Sample> result;
    for(const internal::Plain_l1_sample& s : skeletonizer_.samples())
      result.push_back({internal::to_public(s.origin, traits_),
                        internal::to_public(s.point, traits_), static_cast<FT>(s.kernel_radius),
                        static_cast<FT>(s.radius)});
    return result;
  }

  /// Number of components of the coarsest level of the mixture, the input of step 2.
  std::size_t number_of_components() const { return skeletonizer_.number_of_components(); }

  /// Number of samples.
  std::size_t number_of_samples() const { return skeletonizer_.number_of_samples(); }

  /// Number of input points that belong to no vertex, as they are far from all others.
  std::size_t number_of_outliers() const { return skeletonizer_.number_of_outliers(); }

  /// Number of iterations of step 2 so far.
  std::size_t number_of_iterations() const { return skeletonizer_.number_of_iterations(); }

  /// Replaces `skeleton` by the result of step 3; see `L1_medial_skeletonization_3`.
  /// \returns `false` if the callback cancelled
  /// \throws std::length_error if the points outnumber the values of an index
  /// \pre `link()` returned `true`
  template <typename SkeletonGraph>
  bool extract_skeleton(SkeletonGraph& skeleton) const
  {
    CGAL_precondition(steps_.done() == 3);
    return steps_.run_polled([&] {
      Point_set_skeletonization_3::internal::set_public_skeleton(
        skeletonizer_.skeleton(), skeletonizer_.number_of_points(),
        [this](const Index_lists& lists) { skeletonizer_.fill_point_indices(lists); }, traits_,
        skeleton);
    });
  }

private:
  Traits traits_;
  Point_set_skeletonization_3::internal::Steps steps_;
  Skeletonizer skeletonizer_;
  std::function<void(Skeletonizer&, const Progress&)> fit_;
};

} // namespace CGAL

#endif // CGAL_PUBLISHED_L1_MEDIAL_SKELETONIZATION_3_H
