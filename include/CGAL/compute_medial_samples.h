// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_COMPUTE_MEDIAL_SAMPLES_H
#define CGAL_COMPUTE_MEDIAL_SAMPLES_H

#include <CGAL/license/Point_set_skeletonization_3.h>

#include <CGAL/Gaussian_mixture_3.h>
#include <CGAL/Medial_sample_3.h>
#include <CGAL/Point_set_skeletonization_3/internal/interface/Skeletonizer.h>
#include <CGAL/Point_set_skeletonization_3/internal/interface/Steps.h>
#include <CGAL/Point_set_skeletonization_3/internal/interface/named_parameters.h>
#include <CGAL/Point_set_skeletonization_3/internal/interface/public_data.h>

#include <CGAL/tags.h>

namespace CGAL {

/// \ingroup PkgPointSetSkeletonization3Ref
///
/// Stage 2 alone: computes medial samples from the components of the finest level of a mixture, as
/// `L1_medial_skeletonization_3::project()` does. Noise and outliers are removed; what remains are
/// the patches of a surface. The sample of a patch is the centre of the ball that touches it and
/// patches that face it. O(n log n).
///
/// \param mixture a mixture of a surface, from `fit_gaussian_mixture()` or elsewhere. With noise,
///        components that move into one cell of edge length `cell_size` are merged; none are if it
///        is 0
/// \param samples replaced by the result; left untouched if the callback cancels or on an exception
/// \param np
///   \cgalNamedParamsBegin
///     \cgalParamNBegin{callback} \cgalParamDescription{called with the progress in [0, 1],
///       from the calling thread; returning `false` cancels}
///       \cgalParamType{`std::function<bool(double)>`} \cgalParamDefault{none} \cgalParamNEnd
///   \cgalNamedParamsEnd
/// \returns `false` if the callback cancelled
/// \throws std::invalid_argument if a mean is not finite; the message names the component as a
///         point
template <typename ConcurrencyTag = Sequential_tag, typename GeomTraits,
          typename NamedParameters = parameters::Default_named_parameters>
bool compute_medial_samples(const Gaussian_mixture_3<GeomTraits>& mixture,
                            Medial_samples_3<GeomTraits>& samples,
                            const NamedParameters& np = parameters::default_values())
{
  namespace internal = Point_set_skeletonization_3::internal;
  static_assert(internal::Has_only<NamedParameters, internal_np::callback_t>::value,
                "unknown named parameter: known is callback");
  internal::Skeletonizer skeletonizer(internal::concurrency_of<ConcurrencyTag>());
  skeletonizer.set_mixture(internal::to_plain(mixture));
  internal::Steps steps(internal::progress_of(np));
  if(!steps.run(1, 0, 1, [&](const internal::Progress& progress) {
       skeletonizer.project(progress);
     }))
    return false;
  samples = internal::to_public(skeletonizer.samples(), GeomTraits());
  return true;
}

} // namespace CGAL

#endif // CGAL_COMPUTE_MEDIAL_SAMPLES_H
