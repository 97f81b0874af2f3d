// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXTRACT_L1_MEDIAL_SKELETON_H
#define CGAL_EXTRACT_L1_MEDIAL_SKELETON_H

#include <CGAL/L1_medial_skeletonization_3.h>

#include <utility>

namespace CGAL {

/// Extracts the curve skeleton of a point set: no normals, no mesh and no parameter needed.
///
/// \tparam ConcurrencyTag `Sequential_tag` (default), `Parallel_tag` (needs TBB) or
///         `Parallel_if_available_tag`; the result is the same, bit for bit
/// \tparam PointRange a model of `ConstRange`; it is never changed, nor copied by default
/// \tparam Skeleton `Curve_skeleton_3<Traits>`, or a BGL adjacency list whose vertex bundle has
///         `.point` and `.radius`. It may have `.indices`, a vector of integers; without, a large
///         cloud takes less memory.
/// \tparam NamedParameters a sequence of named parameters
///
/// \param points the points, in any unit and at any offset. None gives an empty skeleton, a single
///        one or many equal ones a single vertex.
/// \param skeleton replaced by the result; left untouched if the callback cancels or on an exception
/// \param np
///   \cgalNamedParamsBegin
///     \cgalParamNBegin{point_map} \cgalParamDescription{gives the `Point_3` of an element}
///       \cgalParamDefault{`Identity_property_map`} \cgalParamNEnd
///     \cgalParamNBegin{geom_traits} \cgalParamDescription{a model of
///       `L1MedialSkeletonizationTraits_3`} \cgalParamDefault{the kernel of the points} \cgalParamNEnd
///     \cgalParamNBegin{callback} \cgalParamDescription{called with the progress in [0, 1], from the
///       calling thread, for the first time when the points have been read; returning `false`
///       cancels} \cgalParamType{`std::function<bool(double)>`} \cgalParamDefault{none}
///     \cgalParamNEnd
///     \cgalParamNBegin{number_of_iterations} \cgalParamDescription{bound on the steps to
///       L1-medians that follow the medial balls, and draw samples of bent limbs off the axis; as
///       published, the fixed number of iterations} \cgalParamType{`std::size_t`}
///       \cgalParamDefault{0; as published 30} \cgalParamNEnd
///     \cgalParamNBegin{as_published} \cgalParamDescription{the method as published, for comparison:
///       `as_published(true, rest)`, see `CGAL/Point_set_skeletonization_3/parameters.h`}
///       \cgalParamType{`bool`} \cgalParamDefault{`false`} \cgalParamNEnd
///     \cgalParamNBegin{single_component} \cgalParamDescription{join all parts by the shortest bridges,
///       not only those between which a gap in the data is plausible: for a shape known to be in one
///       piece. `single_component(true, rest)`; the published method always does}
///       \cgalParamType{`bool`} \cgalParamDefault{`false`} \cgalParamNEnd
///     \cgalParamNBegin{random_seed} \cgalParamDescription{of the published method; the default
///       method draws nothing at random} \cgalParamType{`unsigned int`} \cgalParamDefault{0}
///       \cgalParamNEnd
///   \cgalNamedParamsEnd
///
/// \returns `false` if the callback cancelled
/// \throws std::invalid_argument if a coordinate is not finite; the message names the point
/// \throws std::length_error if the points outnumber the values of an index
template <typename ConcurrencyTag = Sequential_tag, typename PointRange, typename Skeleton,
          typename NamedParameters = parameters::Default_named_parameters>
bool extract_l1_medial_skeleton(const PointRange& points, Skeleton& skeleton,
                                const NamedParameters& np = parameters::default_values())
{
  using Traits = Point_set_skeletonization_3::internal::Geom_traits_of<PointRange, NamedParameters>;
  L1_medial_skeletonization_3<Traits, ConcurrencyTag> skeletonization(points, np);
  if(!skeletonization.run())
    return false;
  std::move(skeletonization).extract_skeleton(skeleton);
  return true;
}

/// The same of points that were streamed. The skeleton names no input points: all `indices` are
/// empty. Named parameters are `callback`, `number_of_iterations` and
/// `single_component`.
template <typename ConcurrencyTag = Sequential_tag, typename Traits, typename Skeleton,
          typename NamedParameters = parameters::Default_named_parameters>
bool extract_l1_medial_skeleton(const Gaussian_mixture_builder_3<Traits>& points,
                                Skeleton& skeleton,
                                const NamedParameters& np = parameters::default_values())
{
  L1_medial_skeletonization_3<Traits, ConcurrencyTag> skeletonization(points, np);
  if(!skeletonization.run())
    return false;
  skeletonization.extract_skeleton(skeleton);
  return true;
}

} // namespace CGAL

#endif // CGAL_EXTRACT_L1_MEDIAL_SKELETON_H
