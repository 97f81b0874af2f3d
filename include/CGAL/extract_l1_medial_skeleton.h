// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXTRACT_L1_MEDIAL_SKELETON_H
#define CGAL_EXTRACT_L1_MEDIAL_SKELETON_H

#include <CGAL/license/Point_set_skeletonization_3.h>

#include <CGAL/L1_medial_skeletonization_3.h>

#include <utility>

namespace CGAL {

/// \ingroup PkgPointSetSkeletonization3Ref
///
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
/// \param skeleton replaced by the result; left untouched if the callback cancels or on an
///        exception
/// \param np
///   \cgalNamedParamsBegin
///     \cgalParamNBegin{point_map} \cgalParamDescription{gives the `Point_3` of an element}
///       \cgalParamDefault{`Identity_property_map`} \cgalParamNEnd
///     \cgalParamNBegin{geom_traits} \cgalParamDescription{a model of
///       `L1MedialSkeletonizationTraits_3`} \cgalParamDefault{the kernel of the points}
///       \cgalParamNEnd
///     \cgalParamNBegin{callback} \cgalParamDescription{called with the progress in [0, 1],
///       from the calling thread; returning `false` cancels}
///       \cgalParamType{`std::function<bool(double)>`} \cgalParamDefault{none} \cgalParamNEnd
///     \cgalParamNBegin{maximum_running_time} \cgalParamDescription{seconds after which it cancels
///       itself, as if the callback had}
///       \cgalParamDefault{no limit} \cgalParamNEnd
///     \cgalParamNBegin{single_component} \cgalParamDescription{whether to join all components by
///       the shortest bridges, not only across plausible gaps in the data: for a connected shape.
///       `single_component(true, rest)`, see `CGAL/Point_set_skeletonization_3/parameters.h`}
///       \cgalParamType{`bool`} \cgalParamDefault{`false`} \cgalParamNEnd
///     \cgalParamNBegin{is_tree} \cgalParamDescription{whether the skeleton is known to have no
///       cycle, as that of a tree or a plant: every cycle is opened where the evidence for a limb
///       is least, instead of only those without enough of it} \cgalParamType{`bool`}
///       \cgalParamDefault{`false`} \cgalParamNEnd
///     \cgalParamNBegin{maximum_cells} \cgalParamDescription{greatest number of components of the
///       mixture, in [1000, 2^26]: bounds memory, about 1 kB a component, and the finest detail}
///       \cgalParamType{`std::size_t`} \cgalParamDefault{131 072} \cgalParamNEnd
///     \cgalParamNBegin{smallest_feature} \cgalParamDescription{thickness of the thinnest limb that
///       must be found, in the unit of the points, > 0 and finite: thinner ones may be missing or
///       merged. Saves time where there are more points than such a limb takes}
///       \cgalParamType{`double`} \cgalParamDefault{as thin as the points allow} \cgalParamNEnd
///   \cgalNamedParamsEnd
///
/// O(n) for reading the points three times; the rest is O(m log m) in practice for m grid cells,
/// one for two points, at most `maximum_cells`.
///
/// \returns `false` if the callback cancelled
/// \throws std::invalid_argument if a coordinate is not finite; the message names the point
/// \throws std::length_error if the points outnumber the values of an index
template <typename ConcurrencyTag = Sequential_tag, typename PointRange, typename Skeleton,
          typename NamedParameters = parameters::Default_named_parameters>
bool extract_l1_medial_skeleton(const PointRange& points, Skeleton& skeleton,
                                const NamedParameters& np = parameters::default_values())
{
  namespace internal = Point_set_skeletonization_3::internal;
  static_assert(internal::Maps_to_points<PointRange, NamedParameters>::value,
                "the elements of the range are not 3D points: pass point_map(MAP)");
  if constexpr(internal::Maps_to_points<PointRange, NamedParameters>::value) {
    using Traits = internal::Geom_traits_of<PointRange, NamedParameters>;
    L1_medial_skeletonization_3<Traits, ConcurrencyTag> skeletonization(points, np);
    return skeletonization.run() && std::move(skeletonization).extract_skeleton(skeleton);
  }
  return false; // not reached
}

/// \ingroup PkgPointSetSkeletonization3Ref
///
/// The same for the points of a builder. All `indices` of the skeleton are empty.
/// \param points the builder
/// \param skeleton replaced by the result
/// \param np
///   \cgalNamedParamsBegin
///     \cgalParamNBegin{callback} \cgalParamDescription{called with the progress in [0, 1],
///       from the calling thread; returning `false` cancels}
///       \cgalParamType{`std::function<bool(double)>`} \cgalParamDefault{none} \cgalParamNEnd
///     \cgalParamNBegin{maximum_running_time} \cgalParamDescription{seconds after which it cancels
///       itself, as if the callback had} \cgalParamDefault{no limit} \cgalParamNEnd
///     \cgalParamNBegin{single_component} \cgalParamDescription{whether to join all components by
///       the shortest bridges} \cgalParamType{`bool`} \cgalParamDefault{`false`} \cgalParamNEnd
///     \cgalParamNBegin{is_tree} \cgalParamDescription{whether to open every cycle where the
///       evidence for a limb is least} \cgalParamType{`bool`} \cgalParamDefault{`false`}
///       \cgalParamNEnd
///     \cgalParamNBegin{smallest_feature} \cgalParamDescription{thickness of the thinnest limb that
///       must be found, in the unit of the points, > 0 and finite: thinner ones may be missing or
///       merged. Saves time where there are more points than such a limb takes}
///       \cgalParamType{`double`} \cgalParamDefault{as thin as the points allow} \cgalParamNEnd
///   \cgalNamedParamsEnd
template <typename ConcurrencyTag = Sequential_tag, typename Traits, typename Skeleton,
          typename NamedParameters = parameters::Default_named_parameters>
bool extract_l1_medial_skeleton(const Gaussian_mixture_builder_3<Traits>& points,
                                Skeleton& skeleton,
                                const NamedParameters& np = parameters::default_values())
{
  L1_medial_skeletonization_3<Traits, ConcurrencyTag> skeletonization(points, np);
  return skeletonization.run() && skeletonization.extract_skeleton(skeleton);
}

/// \ingroup PkgPointSetSkeletonization3Ref
///
/// The same for a builder that is no longer needed, `std::move(builder)`: its memory is returned
/// before most of the other memory is taken. It is empty afterwards, unless the callback cancelled
/// before the points were used.
template <typename ConcurrencyTag = Sequential_tag, typename Traits, typename Skeleton,
          typename NamedParameters = parameters::Default_named_parameters>
bool extract_l1_medial_skeleton(Gaussian_mixture_builder_3<Traits>&& points, Skeleton& skeleton,
                                const NamedParameters& np = parameters::default_values())
{
  L1_medial_skeletonization_3<Traits, ConcurrencyTag> skeletonization(points, np);
  if(!skeletonization.fit_mixture())
    return false;
  points = Gaussian_mixture_builder_3<Traits>();
  return skeletonization.project() && skeletonization.link() &&
         skeletonization.extract_skeleton(skeleton);
}

} // namespace CGAL

#endif // CGAL_EXTRACT_L1_MEDIAL_SKELETON_H
