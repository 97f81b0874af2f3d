// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SEPARATORS_LOCAL_SEPARATOR_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SEPARATORS_LOCAL_SEPARATOR_H

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Patches that separate the surface locally into two sides: a ring around a limb, with a
/// cross-section of any shape. (Baerentzen & Rotenberg 2021 grow a region from a point of the
/// surface; here it grows from the centre of the shape, which gives a ring closer to a
/// cross-section.)
struct Local_separator
{
  std::vector<std::size_t> patches;              ///< Ascending; empty if there is no separator.
  std::array<std::vector<std::size_t>, 2> sides; ///< Adjacent patches on either side, ascending.
  double length = 0;                             ///< Sum of the spacings of its patches.
  bool is_of_handle = false; ///< Only there because it cuts a handle that others leave.
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SEPARATORS_LOCAL_SEPARATOR_H
