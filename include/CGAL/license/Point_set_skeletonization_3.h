// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What CGAL's packages do for those who want to know by which licence they are bound. CGAL
// generates these headers, and asks for a commercial licence first; this package has none.

#ifndef CGAL_LICENSE_POINT_SET_SKELETONIZATION_3_H
#define CGAL_LICENSE_POINT_SET_SKELETONIZATION_3_H

#include <CGAL/config.h>
#include <CGAL/license.h>

#ifdef CGAL_LICENSE_WARNING
CGAL_pragma_warning("You use the Point Set Skeletonization package under the terms of the GPLv3+.")
#endif

#ifdef CGAL_LICENSE_ERROR
#error "The Point Set Skeletonization package is under the terms of the GPLv3+.\
        You get this error, as you defined CGAL_LICENSE_ERROR."
#endif

#endif // CGAL_LICENSE_POINT_SET_SKELETONIZATION_3_H
