// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_PARAMETERS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_PARAMETERS_H

#include <CGAL/license/Point_set_skeletonization_3.h>

#include <CGAL/Named_function_parameters.h>

#include <cstddef>
#include <optional>

namespace CGAL {
namespace internal_np {

enum single_component_t { single_component };
enum is_tree_t { is_tree };
enum maximum_cells_t { maximum_cells };
enum smallest_feature_t { smallest_feature };

} // namespace internal_np

namespace parameters {

// CGAL's own parameters chain as members; a package outside CGAL cannot add one to that chain, so
// the parameters of this package take the rest of the chain as an optional second argument:
// `single_component(true)`, `single_component(true, CGAL::parameters::point_map(map))`.

/// Makes a named parameter of this type, alone or in front of others.
template <typename Tag, typename Value>
struct Parameter
{
  Named_function_parameters<Value, Tag> operator()(Value value) const { return {value}; }

  template <typename T, typename OtherTag, typename Base>
  Named_function_parameters<Value, Tag, Named_function_parameters<T, OtherTag, Base>>
  operator()(Value value, const Named_function_parameters<T, OtherTag, Base>& rest) const
  {
    return {value, rest};
  }
};

/// The named parameter `single_component`.
inline constexpr Parameter<internal_np::single_component_t, bool> single_component{};

/// The named parameter `is_tree`.
inline constexpr Parameter<internal_np::is_tree_t, bool> is_tree{};

/// The named parameter `maximum_cells`.
inline constexpr Parameter<internal_np::maximum_cells_t, std::size_t> maximum_cells{};

/// The named parameter `smallest_feature`; `std::nullopt` means the default.
inline constexpr Parameter<internal_np::smallest_feature_t, std::optional<double>>
  smallest_feature{};

} // namespace parameters
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_PARAMETERS_H
