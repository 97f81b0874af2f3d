// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L1_MEDIAL_SKELETONIZATION_3_H
#define CGAL_L1_MEDIAL_SKELETONIZATION_3_H

#include <CGAL/license/Point_set_skeletonization_3.h>

#include <CGAL/Curve_skeleton_3.h>
#include <CGAL/Gaussian_mixture_3.h>
#include <CGAL/Medial_sample_3.h>
#include <CGAL/Point_assignment_3.h>
#include <CGAL/Point_set_skeletonization_3/internal/interface/Skeletonizer.h>
#include <CGAL/Point_set_skeletonization_3/internal/interface/Steps.h>
#include <CGAL/Point_set_skeletonization_3/internal/interface/named_parameters.h>
#include <CGAL/Point_set_skeletonization_3/internal/interface/public_data.h>
#include <CGAL/Point_set_skeletonization_3/parameters.h>

#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>

namespace CGAL {

template <typename Traits>
class Gaussian_mixture_builder_3;

/// \ingroup PkgPointSetSkeletonization3Ref
///
/// Computes the curve skeleton of a point set, step by step.
///
/// Stores all intermediate results. `run()` does all steps; or call `fit_mixture()`, `project()`
/// and `link()` in this order and read their results.
///
/// Removes noise and outliers, makes the rest the oriented patches of a surface, places a sample at
/// the centre of the medial ball of each patch, and cuts the surface along local separators, rings
/// of patches around limbs (Baerentzen and Rotenberg 2021). Separators and the pieces between them
/// are connected as on the surface, so cycles are preserved.
/// `Published_l1_medial_skeletonization_3` is the method of Lengauer, Houska and Preiner.
///
/// \tparam Traits a model of `L1MedialSkeletonizationTraits_3`: any CGAL kernel with inexact
///         constructions over `float` or `double`
/// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` (needs TBB) or
///         `Parallel_if_available_tag`; the result does not depend on it, bit for bit
template <typename Traits, typename ConcurrencyTag = Sequential_tag>
class L1_medial_skeletonization_3
{
  using Progress = Point_set_skeletonization_3::internal::Progress;
  using Skeletonizer = Point_set_skeletonization_3::internal::Skeletonizer;
  using Index_lists = Point_set_skeletonization_3::internal::Index_lists;

public:
  using FT = typename Traits::FT;
  using Point_3 = typename Traits::Point_3;
  using Mixture = Gaussian_mixture_3<Traits>;
  using Samples = Medial_samples_3<Traits>;
  using Skeleton = Curve_skeleton_3<Traits>;

  /// Refers to the points, which must not change until `fit_mixture()` returns. See
  /// `extract_l1_medial_skeleton()` for the named parameters.
  template <typename PointRange, typename NamedParameters = parameters::Default_named_parameters>
  explicit L1_medial_skeletonization_3(const PointRange& points,
                                       const NamedParameters& np = parameters::default_values())
    : L1_medial_skeletonization_3(np, 0)
  {
    namespace internal = Point_set_skeletonization_3::internal;
    static_assert(internal::Maps_to_points<PointRange, NamedParameters>::value,
                  "the elements of the range are not 3D points: pass point_map(MAP)");
    if constexpr(internal::Maps_to_points<PointRange, NamedParameters>::value) {
      const auto source = internal::point_source(points, internal::point_map_of(points, np));
      // With so many points reading them takes about as long as all the rest.
      constexpr double points_like_the_rest = 1.5e6;
      const double size = static_cast<double>(source.size);
      reading_share_ = size / (size + points_like_the_rest);
      fit_ = [source](Skeletonizer& skeletonizer, const Progress& progress) {
        skeletonizer.fit_mixture(source, progress);
      };
    }
  }

  /// For the points of a builder, which must not change until `fit_mixture()` returns. All
  /// `indices` of the skeleton are empty.
  template <typename NamedParameters = parameters::Default_named_parameters>
  explicit L1_medial_skeletonization_3(const Gaussian_mixture_builder_3<Traits>& points,
                                       const NamedParameters& np = parameters::default_values())
    : L1_medial_skeletonization_3(np, 0)
  {
    fit_ = [&points](Skeletonizer& skeletonizer, const Progress&) {
      skeletonizer.fit_mixture(points.moments_, points.normalization_, points.number_of_far_);
    };
  }

  /// Step 1: fits a Gaussian mixture to the points, which are read three times. O(n).
  /// \returns `false` if the callback cancelled
  /// \throws std::invalid_argument if a coordinate is not finite; the message names the point
  bool fit_mixture()
  {
    return steps_.run(1, 0, reading_share_, [this](const Progress& progress) {
      progress(0);
      fit_(skeletonizer_, progress);
      progress(1);
    });
  }

  /// Step 2: removes noise, builds the surface and computes medial samples. O(m log m) for m
  /// components.
  /// \returns `false` if the callback cancelled
  /// \pre `fit_mixture()` returned `true`
  bool project()
  {
    CGAL_precondition(steps_.done() >= 1);
    return steps_.run(2, reading_share_, half(), [this](const Progress& progress) {
      skeletonizer_.project(progress);
      progress(1);
    });
  }

  /// Step 3: links the samples to a curve skeleton. O(m log m) in practice for m samples.
  /// \returns `false` if the callback cancelled
  /// \pre `project()` returned `true`
  bool link()
  {
    CGAL_precondition(steps_.done() >= 2);
    return steps_.run(3, half(), 1, [this](const Progress& progress) {
      skeletonizer_.link(progress);
      progress(1);
    });
  }

  /// All steps. \returns `false` if the callback cancelled
  bool run() { return fit_mixture() && project() && link(); }

  /// The mixture of step 1, in the coordinates of the input, finest level first.
  Mixture mixture() const
  {
    return Point_set_skeletonization_3::internal::to_public(skeletonizer_.mixture(), traits_);
  }

  /// The samples of step 2, in the coordinates of the input: one per patch of the surface. With
  /// noise or outliers there are fewer than components.
  Samples samples() const
  {
    return Point_set_skeletonization_3::internal::to_public(skeletonizer_.samples(), traits_);
  }

  /// Number of components of the finest level of the mixture, the input of step 2.
  std::size_t number_of_components() const { return skeletonizer_.number_of_components(); }

  /// Number of samples.
  std::size_t number_of_samples() const { return skeletonizer_.number_of_samples(); }

  /// Number of input points that belong to no vertex: points far from all others, isolated points,
  /// the tail of the noise, and clusters too small to be part of the shape.
  std::size_t number_of_outliers() const { return skeletonizer_.number_of_outliers(); }

  /// Which vertex of the skeleton a point belongs to, for the points of a builder. O(m) for m
  /// components.
  /// \pre `link()` returned `true`; the points came from a builder
  Point_assignment_3<Traits> point_assignment() const
  {
    CGAL_precondition(steps_.done() == 3);
    return Point_assignment_3<Traits>(skeletonizer_.assignment());
  }

  /// Replaces `skeleton` by the result of step 3. O(n).
  /// \tparam SkeletonGraph `Skeleton`, or a BGL adjacency list whose vertex bundle has `.point` and
  ///         `.radius`. It may have `.indices`, a vector of integers; without, a large cloud takes
  ///         less memory.
  /// \returns `false` if the callback cancelled; then `skeleton` is as it was
  /// \throws std::length_error if the points outnumber the values of an index
  /// \pre `link()` returned `true`
  template <typename SkeletonGraph>
  bool extract_skeleton(SkeletonGraph& skeleton) const&
  {
    CGAL_precondition(steps_.done() == 3);
    return steps_.run_polled([&] {
      Point_set_skeletonization_3::internal::set_public_skeleton(
        skeletonizer_.skeleton(), skeletonizer_.number_of_points(),
        [this](const Index_lists& lists) { skeletonizer_.fill_point_indices(lists); }, traits_,
        skeleton);
    });
  }

  /// The same for an object that is no longer needed, `std::move(skeletonization)`: its memory is
  /// reused for the indices.
  /// \post the object can only be destroyed
  template <typename SkeletonGraph>
  bool extract_skeleton(SkeletonGraph& skeleton) &&
  {
    CGAL_precondition(steps_.done() == 3);
    Skeletonizer skeletonizer = std::move(skeletonizer_);
    return steps_.run_polled([&] {
      Point_set_skeletonization_3::internal::set_public_skeleton(
        skeletonizer.skeleton(), skeletonizer.number_of_points(),
        [&](const Index_lists& lists) { skeletonizer.fill_point_indices_and_forget(lists); },
        traits_, skeleton);
    });
  }

private:
  /// The common part of the constructors.
  template <typename NamedParameters>
  L1_medial_skeletonization_3(const NamedParameters& np, int)
    : traits_(Point_set_skeletonization_3::internal::traits_of<Traits>(np)),
      steps_(Point_set_skeletonization_3::internal::progress_of(np)),
      skeletonizer_(Point_set_skeletonization_3::internal::concurrency_of<ConcurrencyTag>(),
                    Point_set_skeletonization_3::internal::known_topology(np))
  {
    static_assert(
      Point_set_skeletonization_3::internal::Has_only_input_and<
        NamedParameters, internal_np::single_component_t, internal_np::is_tree_t,
        internal_np::maximum_cells_t, internal_np::smallest_feature_t>::value,
      "unknown named parameter: known are point_map, geom_traits, callback, "
      "maximum_running_time, single_component, is_tree, maximum_cells, smallest_feature");
    if(const auto cells = Point_set_skeletonization_3::internal::maximum_cells_of(np))
      skeletonizer_.limit_cells(*cells);
    if(const auto thickness = Point_set_skeletonization_3::internal::smallest_feature_of(np)) {
      CGAL_precondition(*thickness > 0 && std::isfinite(*thickness));
      skeletonizer_.limit_features(*thickness);
    }
  }

  /// Progress after step 2.
  double half() const { return reading_share_ + 0.45 * (1 - reading_share_); }

  Traits traits_;
  Point_set_skeletonization_3::internal::Steps steps_;
  Skeletonizer skeletonizer_;
  std::function<void(Skeletonizer&, const Progress&)> fit_;
  double reading_share_ = 0; ///< Approximate share of step 1 in the running time.
};

} // namespace CGAL

#endif // CGAL_L1_MEDIAL_SKELETONIZATION_3_H
