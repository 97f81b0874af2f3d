// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_INTERFACE_NAMED_PARAMETERS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_INTERFACE_NAMED_PARAMETERS_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Progress.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/pipeline/Known_topology.h>
#include <CGAL/Point_set_skeletonization_3/parameters.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/property_map.h>
#include <CGAL/tags.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>

// Named parameters and concurrency tags are read here only; all other internals get plain values.

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Whether all named parameters of a call have one of the given tags.
template <typename NamedParameters, typename... Tags>
struct Has_only : std::true_type // end of CGAL's chain
{};

template <typename T, typename Tag, typename Base, typename... Tags>
struct Has_only<Named_function_parameters<T, Tag, Base>, Tags...>
  : std::bool_constant<(std::is_same<Tag, internal_np::all_default_t>::value ||
                        (std::is_same<Tag, Tags>::value || ...)) &&
                       Has_only<Base, Tags...>::value>
{};

/// The parameters that describe the input. Normals, which `Point_set_3` passes, are accepted and
/// ignored.
template <typename NamedParameters, typename... Tags>
using Has_only_input_and =
  Has_only<NamedParameters, internal_np::point_t, internal_np::normal_t, internal_np::geom_traits_t,
           internal_np::callback_t, internal_np::maximum_running_time_t, Tags...>;

/// Whether a type is a 3D point.
template <typename T, typename = void>
struct Is_point_3 : std::false_type
{};

template <typename T>
struct Is_point_3<T, std::void_t<decltype(std::declval<const T&>().x()),
                                 decltype(std::declval<const T&>().y()),
                                 decltype(std::declval<const T&>().z())>> : std::true_type
{};

template <typename PointRange>
using Element_of = typename std::iterator_traits<decltype(
  std::begin(std::declval<const PointRange&>()))>::value_type;

/// The point map of a call, default the identity.
template <typename PointRange, typename NamedParameters>
using Point_map_of = std::decay_t<typename internal_np::Lookup_named_param_def<
  internal_np::point_t, NamedParameters,
  Identity_property_map<const Element_of<PointRange>>>::type>;

template <typename PointRange, typename NamedParameters>
Point_map_of<PointRange, NamedParameters> point_map_of(const PointRange&, const NamedParameters& np)
{
  return parameters::choose_parameter<Point_map_of<PointRange, NamedParameters>>(
    parameters::get_parameter(np, internal_np::point_map));
}

/// Whether the point map gives 3D points.
template <typename PointRange, typename NamedParameters>
using Maps_to_points = Is_point_3<std::decay_t<
  typename boost::property_traits<Point_map_of<PointRange, NamedParameters>>::value_type>>;

/// The geometric traits of a call.
template <typename PointRange, typename NamedParameters>
using Geom_traits_of = std::decay_t<typename internal_np::Lookup_named_param_def<
  internal_np::geom_traits_t, NamedParameters,
  typename Kernel_traits<typename boost::property_traits<
    Point_map_of<PointRange, NamedParameters>>::value_type>::type>::type>;

/// The traits object of a call, default a new one.
template <typename Traits, typename NamedParameters>
Traits traits_of(const NamedParameters& np)
{
  return parameters::choose_parameter<Traits>(
    parameters::get_parameter(np, internal_np::geom_traits));
}

/// The concurrency that a tag asks for.
template <typename ConcurrencyTag>
constexpr Concurrency concurrency_of()
{
  constexpr bool parallel = std::is_convertible<ConcurrencyTag, Parallel_tag>::value;
#ifndef CGAL_LINKED_WITH_TBB
  static_assert(!parallel, "Parallel_tag needs TBB: link the CMake target CGAL::TBB_support");
#endif
  return parallel ? Concurrency::parallel : Concurrency::sequential;
}

/// Returns the callback as a copy: a reference could outlive a temporary.
template <typename NamedParameters>
Progress progress_of(const NamedParameters& np)
{
  return Progress(
    parameters::choose_parameter(parameters::get_parameter(np, internal_np::callback),
                                 std::function<bool(double)>()),
    parameters::choose_parameter(parameters::get_parameter(np, internal_np::maximum_running_time),
                                 std::numeric_limits<double>::infinity()));
}

/// The named parameters `single_component` and `is_tree`.
template <typename NamedParameters>
Known_topology known_topology(const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  return {choose_parameter(get_parameter(np, internal_np::single_component), false),
          choose_parameter(get_parameter(np, internal_np::is_tree), false)};
}

/// The named parameter `maximum_cells`, if it is given.
template <typename NamedParameters>
std::optional<std::size_t> maximum_cells_of(const NamedParameters& np)
{
  return parameters::choose_parameter(
    parameters::get_parameter(np, internal_np::maximum_cells), std::optional<std::size_t>());
}

/// The named parameter `smallest_feature`, if it is given.
template <typename NamedParameters>
std::optional<double> smallest_feature_of(const NamedParameters& np)
{
  return parameters::choose_parameter(
    parameters::get_parameter(np, internal_np::smallest_feature), std::optional<double>());
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_INTERFACE_NAMED_PARAMETERS_H
