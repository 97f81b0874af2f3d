// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_INSIDE_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_INSIDE_H

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

// What a winding number says of a place: 1 inside and 0 outside a closed surface, a half on it and in
// the middle of a hole of the data, and less than that in a limb so thin that its patches are no
// planes. All thresholds are here.

/// From which winding number on a place counts as inside.
constexpr double least_inside = 0.25;

/// Below which winding number a curve that is drawn through the shape has left it. Stricter than
/// `least_inside`, as a curve may not take a short cut through the air beside a hole of the data.
constexpr double air = 0.4;

/// Below which winding number of a patch itself the surface around it is inside out: a half where it is
/// oriented well, minus a half where it is inside out, 0 on an open sheet.
constexpr double inside_out = -0.25;

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_INSIDE_H
