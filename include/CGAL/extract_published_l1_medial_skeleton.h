// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXTRACT_PUBLISHED_L1_MEDIAL_SKELETON_H
#define CGAL_EXTRACT_PUBLISHED_L1_MEDIAL_SKELETON_H

#include <CGAL/license/Point_set_skeletonization_3.h>

#include <CGAL/Published_l1_medial_skeletonization_3.h>

namespace CGAL {

/// \ingroup PkgPointSetSkeletonization3Ref
///
/// Extracts the curve skeleton of a point set by the method of Lengauer, Houska and Preiner as
/// published, for comparison; see `Published_l1_medial_skeletonization_3`. The result is always a
/// tree. Edges that merge separate branches are marked, if the bundle of an edge has `is_bridge`.
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
///     \cgalParamNBegin{maximum_running_time} \cgalParamDescription{seconds after which it cancels
///       itself, as if the callback had}
///       \cgalParamDefault{no limit} \cgalParamNEnd
///     \cgalParamNBegin{number_of_iterations} \cgalParamDescription{of the projection; the paper
///     uses
///       20 to 30} \cgalParamType{`std::size_t`} \cgalParamDefault{30, tuned 60} \cgalParamNEnd
///     \cgalParamNBegin{random_seed} \cgalParamDescription{of the parents of the mixture and of the
///       samples: equal seeds, equal results} \cgalParamType{`unsigned int`} \cgalParamDefault{0}
///       \cgalParamNEnd
///   \cgalNamedParamsEnd
///   and in the namespace `parameters::published` of
///   `CGAL/Point_set_skeletonization_3/published_parameters.h`
///   \cgalNamedParamsBegin
///     \cgalParamNBegin{tuned} \cgalParamDescription{whether the defaults are the tuned ones,
///       given second below, and not those of the paper} \cgalParamType{`bool`}
///       \cgalParamDefault{`false`} \cgalParamNEnd
///     \cgalParamNBegin{h_0} \cgalParamDescription{\f$h^{(0)}\f$, the first kernel radius; in
///       diagonals of the bounding box, in [1e-4, 1e4]} \cgalParamType{`double`}
///       \cgalParamDefault{2 over the cube root of the number of points} \cgalParamNEnd
///     \cgalParamNBegin{delta_h} \cgalParamDescription{\f$\Delta h\f$, the growth of a kernel per
///       iteration where its surroundings are isotropic; in units of h_0, >= 0}
///       \cgalParamType{`double`} \cgalParamDefault{0.5, tuned 1/3} \cgalParamNEnd
///     \cgalParamNBegin{mu} \cgalParamDescription{\f$\mu\f$, the weight of the repulsion; in [0,
///       0.5)} \cgalParamType{`double`} \cgalParamDefault{0.2} \cgalParamNEnd
///     \cgalParamNBegin{halt} \cgalParamDescription{whether the projection halts when no more
///       samples come to lie on curves; `number_of_iterations` is then a bound, by default twice as
///       large}
///       \cgalParamType{`bool`} \cgalParamDefault{`false`} \cgalParamNEnd
///     \cgalParamNBegin{samples} \cgalParamDescription{\f$|X|\f$, the number of samples; >= 1}
///       \cgalParamType{`std::size_t`} \cgalParamDefault{a twentieth of the points, at least 500}
///       \cgalParamNEnd
///     \cgalParamNBegin{alpha} \cgalParamDescription{\f$\alpha\f$, the reach of a parent of the
///       hierarchical EM; in standard deviations, > 0} \cgalParamType{`double`}
///       \cgalParamDefault{2.2} \cgalParamNEnd
///     \cgalParamNBegin{levels} \cgalParamDescription{number of levels of the hierarchical EM
///       above the points} \cgalParamType{`std::size_t`} \cgalParamDefault{3} \cgalParamNEnd
///     \cgalParamNBegin{flatness} \cgalParamDescription{variance added to the Gaussian of a point
///       in every direction, as a fraction of its mean variance; > 0} \cgalParamType{`double`}
///       \cgalParamDefault{0.3} \cgalParamNEnd
///     \cgalParamNBegin{sample_flatness} \cgalParamDescription{the same for the Gaussian of a
///       sample} \cgalParamType{`double`} \cgalParamDefault{0.3, tuned 0.05} \cgalParamNEnd
///     \cgalParamNBegin{alpha_min} \cgalParamDescription{\f$\alpha_{min}\f$, the least angle of
///       adjacent segments of a branch; in degrees, in [0, 180), where 180 is straight}
///       \cgalParamType{`double`} \cgalParamDefault{90, tuned 120} \cgalParamNEnd
///     \cgalParamNBegin{b_min} \cgalParamDescription{\f$b_{min}\f$, the least number of
///       components of a branch; >= 2} \cgalParamType{`std::size_t`} \cgalParamDefault{5}
///       \cgalParamNEnd
///     \cgalParamNBegin{d_max} \cgalParamDescription{\f$d_{max}\f$, the greatest distance of
///       adjacent components of a branch; in diagonals of the bounding box, > 0}
///       \cgalParamType{`double`} \cgalParamDefault{0.15} \cgalParamNEnd
///   \cgalNamedParamsEnd
///
/// \pre all parameters are in their ranges
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
    return skeletonization.run() && skeletonization.extract_skeleton(skeleton);
  }
  return false; // not reached
}

} // namespace CGAL

#endif // CGAL_EXTRACT_PUBLISHED_L1_MEDIAL_SKELETON_H
