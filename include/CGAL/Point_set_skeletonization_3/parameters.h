// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_PARAMETERS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_PARAMETERS_H

#include <CGAL/Named_function_parameters.h>

namespace CGAL {
namespace internal_np {

enum as_published_t { as_published };
enum single_component_t { single_component };

} // namespace internal_np

namespace parameters {

// CGAL's own parameters chain as members; a package outside CGAL cannot add one to that chain, so
// the parameters of this package take the rest of the chain as an optional second argument:
// `as_published(true)`, `as_published(true, CGAL::parameters::point_map(map))`.

/// The named parameter `as_published`.
inline Named_function_parameters<bool, internal_np::as_published_t> as_published(bool value)
{
  return {value};
}

template <typename T, typename Tag, typename Base>
Named_function_parameters<bool, internal_np::as_published_t,
                          Named_function_parameters<T, Tag, Base>>
as_published(bool value, const Named_function_parameters<T, Tag, Base>& rest)
{
  return {value, rest};
}

/// The named parameter `single_component`.
inline Named_function_parameters<bool, internal_np::single_component_t>
single_component(bool value)
{
  return {value};
}

template <typename T, typename Tag, typename Base>
Named_function_parameters<bool, internal_np::single_component_t,
                          Named_function_parameters<T, Tag, Base>>
single_component(bool value, const Named_function_parameters<T, Tag, Base>& rest)
{
  return {value, rest};
}

} // namespace parameters
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_PARAMETERS_H
