// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_LINKAGE_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_LINKAGE_H

// The package is header-only unless a program links the library target
// `Point_set_skeletonization_3_compiled`, which defines this macro: then that contains the
// functions declared with `CGAL_POINT_SET_SKELETONIZATION_3_INLINE`.
#ifdef CGAL_POINT_SET_SKELETONIZATION_3_COMPILED
#define CGAL_POINT_SET_SKELETONIZATION_3_INLINE
#else
#define CGAL_POINT_SET_SKELETONIZATION_3_INLINE inline
#endif

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CORE_LINKAGE_H
