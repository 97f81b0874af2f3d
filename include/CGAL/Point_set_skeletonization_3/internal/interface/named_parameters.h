// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_INTERFACE_NAMED_PARAMETERS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_INTERFACE_NAMED_PARAMETERS_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Progress.h>
#include <CGAL/Point_set_skeletonization_3/internal/published/Published_method.h>
#include <CGAL/Point_set_skeletonization_3/internal/interface/Surface_quotient_stages.h>
#include <CGAL/Point_set_skeletonization_3/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <cstddef>
#include <functional>
#include <memory>

// The only place where named parameters are read; everything below sees plain structs.

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// The traits that a call with these parameters works with.
template <typename PointRange, typename NamedParameters>
using Geom_traits_of =
  typename Point_set_processing_3_np_helper<PointRange, NamedParameters>::Geom_traits;

/// The callback, copied: a reference could outlive the temporary it was given as.
template <typename NamedParameters>
Progress progress_of(const NamedParameters& np)
{
  return Progress(parameters::choose_parameter(
    parameters::get_parameter(np, internal_np::callback), std::function<bool(double)>()));
}

/// `number_of_iterations` is the bound if the parameters do not name one.
template <typename NamedParameters>
Projection_options projection_options(const NamedParameters& np, std::size_t number_of_iterations)
{
  Projection_options options;
  options.maximum_iterations = static_cast<std::size_t>(parameters::choose_parameter(
    parameters::get_parameter(np, internal_np::number_of_iterations), number_of_iterations));
  return options;
}

template <typename NamedParameters>
Published_projection_options published_projection_options(const NamedParameters& np)
{
  Published_projection_options options;
  options.iterations = static_cast<std::size_t>(parameters::choose_parameter(
    parameters::get_parameter(np, internal_np::number_of_iterations), options.iterations));
  return options;
}

/// The options of the default method.
template <typename NamedParameters>
Surface_quotient_options default_method_options(const NamedParameters& np)
{
  // The centre of its medial ball is where a sample belongs. A step to the L1-median of what a
  // kernel shows draws it to the inside of a bend, and the linking takes the median of a whole
  // cross-section anyway: so there are none unless asked for.
  return {projection_options(np, 0),
          parameters::choose_parameter(
            parameters::get_parameter(np, internal_np::single_component), false)};
}

template <typename NamedParameters>
bool is_as_published(const NamedParameters& np)
{
  return parameters::choose_parameter(parameters::get_parameter(np, internal_np::as_published),
                                      false);
}

/// The default method or the published one.
template <typename ConcurrencyTag, typename NamedParameters>
std::unique_ptr<Skeletonization_stages> make_stages(const NamedParameters& np)
{
  if(!is_as_published(np))
    return std::make_unique<Surface_quotient_stages<ConcurrencyTag>>(default_method_options(np));
  const auto seed = parameters::choose_parameter(
    parameters::get_parameter(np, internal_np::random_seed), 0u);
  return std::make_unique<Published_stages<ConcurrencyTag>>(static_cast<unsigned int>(seed),
                                                            published_projection_options(np));
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_INTERFACE_NAMED_PARAMETERS_H
