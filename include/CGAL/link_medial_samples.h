// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_LINK_MEDIAL_SAMPLES_H
#define CGAL_LINK_MEDIAL_SAMPLES_H

#include <CGAL/license/Point_set_skeletonization_3.h>

#include <CGAL/Curve_skeleton_3.h>
#include <CGAL/Medial_sample_3.h>
#include <CGAL/Point_set_skeletonization_3/internal/interface/Skeletonizer.h>
#include <CGAL/Point_set_skeletonization_3/internal/interface/Steps.h>
#include <CGAL/Point_set_skeletonization_3/internal/interface/named_parameters.h>
#include <CGAL/Point_set_skeletonization_3/internal/interface/public_data.h>
#include <CGAL/Point_set_skeletonization_3/parameters.h>

#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <algorithm>

namespace CGAL {

/// \ingroup PkgPointSetSkeletonization3Ref
///
/// Stage 3 alone: links medial samples to a curve skeleton, as
/// `L1_medial_skeletonization_3::link()` does. The surface of the patches of the samples is cut
/// along local separators; separators and pieces become a graph, which is pruned and centred.
/// O(n log n) in practice.
///
/// \param samples from `compute_medial_samples()` or elsewhere: of each sample its point and
///        its radius are used, and the mean and the weight of its patch if `samples.surface` is
///        empty
/// \param skeleton replaced by the result; left untouched if the callback cancels or on an
///        exception. The `indices` of a vertex, if it has them, are the positions of its samples in
///        `samples.samples`
/// \param np
///   \cgalNamedParamsBegin
///     \cgalParamNBegin{callback} \cgalParamDescription{called with the progress in [0, 1],
///       from the calling thread; returning `false` cancels}
///       \cgalParamType{`std::function<bool(double)>`} \cgalParamDefault{none} \cgalParamNEnd
///     \cgalParamNBegin{single_component} \cgalParamDescription{whether to join all components by
///       the shortest bridges} \cgalParamType{`bool`} \cgalParamDefault{`false`} \cgalParamNEnd
///     \cgalParamNBegin{is_tree} \cgalParamDescription{whether to open every cycle where the
///       evidence for a limb is least} \cgalParamType{`bool`} \cgalParamDefault{`false`}
///       \cgalParamNEnd
///   \cgalNamedParamsEnd
/// \returns `false` if the callback cancelled
/// \throws std::invalid_argument if a mean is not finite, or a point of the surface; the message
///         names it by its position
/// \throws std::length_error if the samples outnumber the values of an index
/// \pre each `samples.noise` is in [0, 1], the objects are numbered from 0 on, and `samples.surface` is
///   empty or has points of each sample, and of no other
template <typename ConcurrencyTag = Sequential_tag, typename GeomTraits, typename SkeletonGraph,
          typename NamedParameters = parameters::Default_named_parameters>
bool link_medial_samples(const Medial_samples_3<GeomTraits>& samples, SkeletonGraph& skeleton,
                         const NamedParameters& np = parameters::default_values())
{
  namespace internal = Point_set_skeletonization_3::internal;
  static_assert(internal::Has_only<NamedParameters, internal_np::callback_t,
                                   internal_np::single_component_t, internal_np::is_tree_t>::value,
                "unknown named parameter: known are callback, single_component, is_tree");
  CGAL_precondition(internal::have_possible_noise(samples));
  CGAL_precondition(internal::have_possible_objects(samples));
  CGAL_precondition(internal::has_points_of_all_samples(samples));
  internal::Skeletonizer skeletonizer(internal::concurrency_of<ConcurrencyTag>(),
                                      internal::known_topology(np));
  skeletonizer.set_samples(internal::to_plain(samples));
  internal::Steps steps(internal::progress_of(np));
  if(!steps.run(1, 0, 1, [&](const internal::Progress& progress) { skeletonizer.link(progress); }))
    return false;
  internal::set_public_skeleton(
    skeletonizer.skeleton(), skeletonizer.number_of_samples(),
    [&](const internal::Index_lists& lists) { skeletonizer.fill_sample_indices(lists); },
    GeomTraits(), skeleton);
  return true;
}

} // namespace CGAL

#endif // CGAL_LINK_MEDIAL_SAMPLES_H
