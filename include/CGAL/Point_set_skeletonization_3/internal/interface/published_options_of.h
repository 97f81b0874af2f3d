// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_INTERFACE_PUBLISHED_OPTIONS_OF_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_INTERFACE_PUBLISHED_OPTIONS_OF_H

#include <CGAL/Point_set_skeletonization_3/internal/interface/named_parameters.h>
#include <CGAL/Point_set_skeletonization_3/internal/published/Published_options.h>
#include <CGAL/Point_set_skeletonization_3/published_parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <cstddef>
#include <optional>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Whether all named parameters of a call are those of the published method.
template <typename NamedParameters>
using Has_only_published =
  Has_only_input_and<NamedParameters, internal_np::number_of_iterations_t,
                     internal_np::random_seed_t, internal_np::published_tuned_t,
                     internal_np::published_h_0_t,
                     internal_np::published_delta_h_t,
                     internal_np::published_mu_t,
                     internal_np::published_halt_t,
                     internal_np::published_samples_t,
                     internal_np::published_alpha_t,
                     internal_np::published_levels_t,
                     internal_np::published_flatness_t,
                     internal_np::published_sample_flatness_t,
                     internal_np::published_alpha_min_t,
                     internal_np::published_b_min_t,
                     internal_np::published_d_max_t>;

/// The value of a named parameter; a default one if it is not there.
template <typename Value, typename NamedParameters, typename Tag>
Value parameter_of(const NamedParameters& np, Tag tag)
{
  return static_cast<Value>(
    parameters::choose_parameter(parameters::get_parameter(np, tag), Value()));
}

/// The options of the published method that the named parameters of a call ask for.
template <typename NamedParameters>
Published_options published_options_of(const NamedParameters& np)
{
  Published_options result = parameter_of<bool>(np, internal_np::published_tuned)
                               ? Published_options::tuned()
                               : Published_options();
  const auto set = [](auto& option, const auto& value) {
    if(value)
      option = *value;
  };
  set(result.projection.initial_kernel_radius,
      parameter_of<std::optional<double>>(np, internal_np::published_h_0));
  set(result.projection.kernel_growth,
      parameter_of<std::optional<double>>(np, internal_np::published_delta_h));
  set(result.projection.repulsion,
      parameter_of<std::optional<double>>(np, internal_np::published_mu));
  set(result.projection.number_of_samples,
      parameter_of<std::optional<std::size_t>>(np, internal_np::published_samples));
  set(result.em.alpha, parameter_of<std::optional<double>>(np, internal_np::published_alpha));
  set(result.em.number_of_levels,
      parameter_of<std::optional<std::size_t>>(np, internal_np::published_levels));
  set(result.points.flatness,
      parameter_of<std::optional<double>>(np, internal_np::published_flatness));
  set(result.samples.flatness,
      parameter_of<std::optional<double>>(np, internal_np::published_sample_flatness));
  set(result.branches.alpha_min,
      parameter_of<std::optional<double>>(np, internal_np::published_alpha_min));
  set(result.branches.b_min,
      parameter_of<std::optional<std::size_t>>(np, internal_np::published_b_min));
  set(result.branches.d_max, parameter_of<std::optional<double>>(np, internal_np::published_d_max));
  result.projection.halts = parameter_of<bool>(np, internal_np::published_halt);
  if(result.projection.halts)
    result.projection.iterations *= 2; // unless given: a bound, beyond what is good without
  set(result.projection.iterations,
      parameter_of<std::optional<std::size_t>>(np, internal_np::number_of_iterations));
  set(result.em.random_seed,
      parameter_of<std::optional<unsigned int>>(np, internal_np::random_seed));
  return result;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_INTERFACE_PUBLISHED_OPTIONS_OF_H
