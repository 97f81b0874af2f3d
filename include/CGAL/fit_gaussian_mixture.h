// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_FIT_GAUSSIAN_MIXTURE_H
#define CGAL_FIT_GAUSSIAN_MIXTURE_H

#include <CGAL/license/Point_set_skeletonization_3.h>

#include <CGAL/L1_medial_skeletonization_3.h>

namespace CGAL {

/// \ingroup PkgPointSetSkeletonization3Ref
///
/// Stage 1 alone: fits a hierarchy of Gaussian mixtures to a point set. The components of the
/// finest level are the moments of the points in the cells of a grid; each further level has cells
/// of twice the width. Weight, mean and covariance are exact. O(n).
///
/// Template parameters as for `extract_l1_medial_skeleton()`.
///
/// \param points the points
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
///       itself, as if the callback had} \cgalParamDefault{no limit} \cgalParamNEnd
///     \cgalParamNBegin{smallest_feature} \cgalParamDescription{thickness of the thinnest limb that
///       must be found, in the unit of the points, > 0: cells are coarser if there are more points
///       than that takes}
///       \cgalParamType{`double`} \cgalParamDefault{as thin as the points allow} \cgalParamNEnd
///   \cgalNamedParamsEnd
/// \returns the mixture, in the coordinates of the input; without levels if there are no points or
///   the callback cancelled
/// \throws std::invalid_argument if a coordinate is not finite; the message names the point
template <typename ConcurrencyTag = Sequential_tag, typename PointRange,
          typename NamedParameters = parameters::Default_named_parameters>
auto fit_gaussian_mixture(const PointRange& points,
                          const NamedParameters& np = parameters::default_values())
{
  namespace internal = Point_set_skeletonization_3::internal;
  static_assert(internal::Maps_to_points<PointRange, NamedParameters>::value,
                "the elements of the range are not 3D points: pass point_map(MAP)");
  if constexpr(internal::Maps_to_points<PointRange, NamedParameters>::value) {
    using Traits = internal::Geom_traits_of<PointRange, NamedParameters>;
    L1_medial_skeletonization_3<Traits, ConcurrencyTag> skeletonization(points, np);
    return skeletonization.fit_mixture() ? skeletonization.mixture()
                                         : Gaussian_mixture_3<Traits>();
  }
}

/// \ingroup PkgPointSetSkeletonization3Ref
///
/// The same for the points of a builder.
/// \param points the builder
/// \param np
///   \cgalNamedParamsBegin
///     \cgalParamNBegin{callback} \cgalParamDescription{called with the progress in [0, 1],
///       from the calling thread; returning `false` cancels}
///       \cgalParamType{`std::function<bool(double)>`} \cgalParamDefault{none} \cgalParamNEnd
///     \cgalParamNBegin{maximum_running_time} \cgalParamDescription{seconds after which it cancels
///       itself, as if the callback had} \cgalParamDefault{no limit} \cgalParamNEnd
///     \cgalParamNBegin{smallest_feature} \cgalParamDescription{thickness of the thinnest limb that
///       must be found, in the unit of the points, > 0: cells are coarser if there are more points
///       than that takes}
///       \cgalParamType{`double`} \cgalParamDefault{as thin as the points allow} \cgalParamNEnd
///   \cgalNamedParamsEnd
template <typename ConcurrencyTag = Sequential_tag, typename Traits,
          typename NamedParameters = parameters::Default_named_parameters>
Gaussian_mixture_3<Traits>
fit_gaussian_mixture(const Gaussian_mixture_builder_3<Traits>& points,
                     const NamedParameters& np = parameters::default_values())
{
  L1_medial_skeletonization_3<Traits, ConcurrencyTag> skeletonization(points, np);
  return skeletonization.fit_mixture() ? skeletonization.mixture() : Gaussian_mixture_3<Traits>();
}

} // namespace CGAL

#endif // CGAL_FIT_GAUSSIAN_MIXTURE_H
