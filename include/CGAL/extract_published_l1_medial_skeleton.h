// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXTRACT_PUBLISHED_L1_MEDIAL_SKELETON_H
#define CGAL_EXTRACT_PUBLISHED_L1_MEDIAL_SKELETON_H

#include <CGAL/Published_l1_medial_skeletonization_3.h>

namespace CGAL {

/// Extracts the curve skeleton of a point set by the method of Lengauer, Houska and Preiner as
/// published, for comparison; see `Published_l1_medial_skeletonization_3`. The result is always a
/// tree.
///
/// Template parameters, points and skeleton are as for `extract_l1_medial_skeleton()`.
///
/// \param points the points; none gives an empty skeleton
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
///     \cgalParamNBegin{number_of_iterations} \cgalParamDescription{of the projection, a fixed
///       number; the paper uses 20 to 30} \cgalParamType{`std::size_t`} \cgalParamDefault{30}
///       \cgalParamNEnd
///     \cgalParamNBegin{random_seed} \cgalParamDescription{of the parents of the mixture and of the
///       samples: equal seeds, equal results} \cgalParamType{`unsigned int`} \cgalParamDefault{0}
///       \cgalParamNEnd
///   \cgalNamedParamsEnd
///
/// \returns `false` if the callback cancelled
/// \throws std::invalid_argument if a coordinate is not finite; the message names the point
/// \throws std::length_error if the points outnumber the values of an index
template <typename ConcurrencyTag = Sequential_tag, typename PointRange, typename Skeleton,
          typename NamedParameters = parameters::Default_named_parameters>
bool extract_published_l1_medial_skeleton(const PointRange& points, Skeleton& skeleton,
                                          const NamedParameters& np = parameters::default_values())
{
  namespace internal = Point_set_skeletonization_3::internal;
  static_assert(internal::Maps_to_points<PointRange, NamedParameters>::value,
                "the elements of the range are not 3D points: pass point_map(MAP)");
  if constexpr(internal::Maps_to_points<PointRange, NamedParameters>::value) {
    using Traits = internal::Geom_traits_of<PointRange, NamedParameters>;
    Published_l1_medial_skeletonization_3<Traits, ConcurrencyTag> skeletonization(points, np);
    if(!skeletonization.run())
      return false;
    skeletonization.extract_skeleton(skeleton);
  }
  return true;
}

} // namespace CGAL

#endif // CGAL_EXTRACT_PUBLISHED_L1_MEDIAL_SKELETON_H
