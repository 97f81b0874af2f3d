// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L1_MEDIAL_SKELETONIZATION_3_H
#define CGAL_L1_MEDIAL_SKELETONIZATION_3_H

#include <CGAL/Curve_skeleton_3.h>
#include <CGAL/Gaussian_mixture_3.h>
#include <CGAL/Gaussian_mixture_builder_3.h>
#include <CGAL/Medial_sample_3.h>
#include <CGAL/Point_set_skeletonization_3/internal/mixture/Point_source.h>
#include <CGAL/Point_set_skeletonization_3/internal/published/Published_method.h>
#include <CGAL/Point_set_skeletonization_3/internal/interface/Surface_quotient_stages.h>
#include <CGAL/Point_set_skeletonization_3/internal/interface/named_parameters.h>
#include <CGAL/Point_set_skeletonization_3/internal/interface/public_data.h>
#include <CGAL/Point_set_skeletonization_3/parameters.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {

/// The curve skeleton of a point set, step by step.
///
/// Reads the points once and for all when it is constructed, and keeps of each no more than its
/// place in the mixture, two bytes; as published, a copy. Owns every intermediate result, so that
/// each can be read. `run()` does all steps; or call `fit_mixture()`, `project()` and `link()` in
/// this order and look at what they leave.
///
/// The default takes noise and outliers off, reads what is left as the oriented patches of a
/// surface, puts a sample in the medial ball of every patch, and cuts the surface along local
/// separators, rings of patches around limbs (Baerentzen & Rotenberg 2021). Rings and the pieces
/// between them are joined as they are on the surface, so loops survive. With `as_published(true)`
/// it is the method of Lengauer, Houska and Preiner, whose result is always a tree.
///
/// \tparam Traits a model of `L1MedialSkeletonizationTraits_3`: any CGAL kernel with inexact
///         constructions over `float` or `double`
/// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` (needs TBB) or `Parallel_if_available_tag`;
///         the result does not depend on it, bit for bit
template <typename Traits, typename ConcurrencyTag = Sequential_tag>
class L1_medial_skeletonization_3
{
  using Normalization = Point_set_skeletonization_3::internal::Normalization;
  using Stages = Point_set_skeletonization_3::internal::Skeletonization_stages;

public:
  using FT = typename Traits::FT;
  using Point_3 = typename Traits::Point_3;
  using Mixture = Gaussian_mixture_3<Traits>;
  using Sample = Medial_sample_3<Traits>;
  using Skeleton = Curve_skeleton_3<Traits>;

  /// Reads the points; see `extract_l1_medial_skeleton()` for the named parameters.
  /// \throws std::invalid_argument if a coordinate is not finite; the message names the point
  template <typename PointRange, typename NamedParameters = parameters::Default_named_parameters>
  explicit L1_medial_skeletonization_3(const PointRange& points,
                                       const NamedParameters& np = parameters::default_values())
    : progress_(Point_set_skeletonization_3::internal::progress_of(np))
  {
    namespace internal = Point_set_skeletonization_3::internal;
    using Helper = Point_set_processing_3_np_helper<PointRange, NamedParameters>;
    const internal::Range_blocks blocks(points, Helper::get_const_point_map(points, np),
                                        ConcurrencyTag());
    normalization_ = blocks.normalization();
    stages_ = internal::make_stages<ConcurrencyTag>(np);
    stages_->read(blocks);
  }

  /// Reads points that were streamed. The skeleton then names no input points: all `indices` are
  /// empty.
  /// \pre not `as_published`: the published method needs the points themselves
  template <typename NamedParameters = parameters::Default_named_parameters>
  explicit L1_medial_skeletonization_3(const Gaussian_mixture_builder_3<Traits>& points,
                                       const NamedParameters& np = parameters::default_values())
    : normalization_(points.normalization_)
    , progress_(Point_set_skeletonization_3::internal::progress_of(np))
  {
    namespace internal = Point_set_skeletonization_3::internal;
    CGAL_precondition(!internal::is_as_published(np));
    stages_ = std::make_unique<internal::Surface_quotient_stages<ConcurrencyTag>>(
      internal::default_method_options(np), points.moments_);
  }

  // The stages are not copied.
  L1_medial_skeletonization_3(const L1_medial_skeletonization_3&) = delete;
  L1_medial_skeletonization_3& operator=(const L1_medial_skeletonization_3&) = delete;

  /// Step 1: points to a Gaussian mixture. \returns `false` if the callback cancelled
  bool fit_mixture()
  {
    steps_done_ = 0;
    if(!progress_(0) || !stages_->fit(progress_.part(0, 0.1)))
      return false;
    steps_done_ = 1;
    return true;
  }

  /// Step 2: samples to the middle of the shape. \returns `false` if the callback cancelled
  /// \pre `fit_mixture()` returned `true`
  bool project()
  {
    CGAL_precondition(steps_done_ >= 1);
    steps_done_ = 1;
    if(!stages_->project(progress_.part(0.1, 0.5)))
      return false;
    steps_done_ = 2;
    return true;
  }

  /// Step 3: samples to a graph. \returns `false` if the callback cancelled
  /// \pre `project()` returned `true`
  bool link()
  {
    CGAL_precondition(steps_done_ >= 2);
    steps_done_ = 2;
    if(!stages_->link(progress_.part(0.5, 1)))
      return false;
    steps_done_ = 3;
    return true;
  }

  /// All steps. \returns `false` if the callback cancelled
  bool run() { return fit_mixture() && project() && link(); }

  /// The mixture of step 1, in the coordinates of the input, finest level first.
  Mixture mixture() const
  {
    return Point_set_skeletonization_3::internal::public_mixture<Traits>(stages_->mixture,
                                                                         normalization_);
  }

  /// The samples of step 2, in the coordinates of the input. By default one per patch of the
  /// surface, which are fewer than components where noise or outliers were taken off.
  std::vector<Sample> samples() const
  {
    return Point_set_skeletonization_3::internal::public_samples<Traits>(stages_->samples,
                                                                         normalization_);
  }

  /// Number of components of the mixture level that step 2 reads.
  std::size_t number_of_components() const
  {
    return stages_->mixture.empty() ? 0 : stages_->components().size();
  }

  /// Number of samples.
  std::size_t number_of_samples() const { return stages_->samples.size(); }

  /// Iterations that the projection took; by default none.
  std::size_t number_of_iterations() const { return stages_->outcome.iterations; }

  /// Why the projection stopped.
  Projection_stop_reason stop_reason() const { return stages_->outcome.reason; }

  /// Number of input points that belong to no vertex: isolated ones, the thin tail of noise, and
  /// clusters too small to be part of the shape.
  std::size_t number_of_outliers() const { return stages_->number_of_outliers; }

  /// Replaces `skeleton` by the result of step 3.
  /// \tparam SkeletonGraph `Skeleton`, or a BGL adjacency list whose vertex bundle has `.point` and
  ///         `.radius`. It may have `.indices`, a vector of integers; without, a large cloud takes
  ///         less memory.
  /// \throws std::length_error if the points outnumber the values of an index
  /// \pre `link()` returned `true`
  template <typename SkeletonGraph>
  void extract_skeleton(SkeletonGraph& skeleton) const&
  {
    CGAL_precondition(steps_done_ == 3);
    namespace internal = Point_set_skeletonization_3::internal;
    internal::set_public_skeleton<Traits, ConcurrencyTag>(std::as_const(*stages_), normalization_,
                                                          skeleton);
  }

  /// The same of an object that is not needed any longer, `std::move(skeletonization)`: what it keeps
  /// of the points makes room for the indices.
  /// \post the object can only be destroyed
  template <typename SkeletonGraph>
  void extract_skeleton(SkeletonGraph& skeleton) &&
  {
    CGAL_precondition(steps_done_ == 3);
    namespace internal = Point_set_skeletonization_3::internal;
    const std::unique_ptr<Stages> stages = std::move(stages_);
    internal::set_public_skeleton<Traits, ConcurrencyTag>(*stages, normalization_, skeleton);
  }

private:
  Normalization normalization_;
  Point_set_skeletonization_3::internal::Progress progress_;
  std::unique_ptr<Stages> stages_;
  int steps_done_ = 0;
};

} // namespace CGAL

#endif // CGAL_L1_MEDIAL_SKELETONIZATION_3_H
