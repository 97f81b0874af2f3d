// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROJECT_TO_L1_MEDIANS_H
#define CGAL_PROJECT_TO_L1_MEDIANS_H

#include <CGAL/Gaussian_mixture_3.h>
#include <CGAL/Medial_sample_3.h>
#include <CGAL/Point_set_skeletonization_3/internal/interface/Surface_quotient_stages.h>
#include <CGAL/Point_set_skeletonization_3/internal/interface/named_parameters.h>
#include <CGAL/Point_set_skeletonization_3/internal/interface/public_data.h>

#include <vector>

namespace CGAL {

/// Moves the patches of a mixture, the components of its finest level, to the middle of the shape:
/// one sample per component, in their order. A sample goes to the centre of the ball that touches
/// its patch and patches facing it, and on to the local L1-median in `number_of_iterations` steps
/// at most, by default 3. Noise and outliers are not taken off here.
///
/// \param mixture a mixture of a surface, from `fit_gaussian_mixture()` or elsewhere
/// \param samples replaced by the result; left untouched if the callback cancels or on an exception
/// \param np `callback`, `number_of_iterations`; see `extract_l1_medial_skeleton()`
/// \returns `false` if the callback cancelled
/// \throws std::invalid_argument if a mean is not finite; the message names the component as a point
template <typename ConcurrencyTag = Sequential_tag, typename GeomTraits,
          typename NamedParameters = parameters::Default_named_parameters>
bool project_to_l1_medians(const Gaussian_mixture_3<GeomTraits>& mixture,
                           std::vector<Medial_sample_3<GeomTraits>>& samples,
                           const NamedParameters& np = parameters::default_values())
{
  namespace internal = Point_set_skeletonization_3::internal;
  std::vector<internal::Vector3> means;
  if(!mixture.levels.empty())
    for(const auto& component : mixture.levels.front())
      means.push_back(internal::Normalization::vector(component.mean));
  const internal::Normalization normalization = internal::normalization_of(means);

  std::vector<internal::Sample> projected;
  if(!means.empty()) {
    const internal::Gaussians components =
      internal::normalized_level<GeomTraits>(mixture.levels.front(), normalization);
    const internal::Surface<ConcurrencyTag> surface(
      components, internal::tree_of_means<ConcurrencyTag>(components));
    const std::size_t iterations = internal::Projection_options().maximum_iterations;
    const internal::Projection_outcome outcome = internal::project_patches<ConcurrencyTag>(
      components, surface, internal::projection_options(np, iterations), internal::progress_of(np),
      projected);
    if(outcome.reason == Projection_stop_reason::cancelled)
      return false;
  }
  samples = internal::public_samples<GeomTraits>(projected, normalization);
  return true;
}

} // namespace CGAL

#endif // CGAL_PROJECT_TO_L1_MEDIANS_H
