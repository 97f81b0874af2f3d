// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// All that does not depend on the kernel of the user's points, for the target
// `Point_set_skeletonization_3_compiled`.

#include <CGAL/Point_set_skeletonization_3/internal/interface/Published_skeletonizer_impl.h>
#include <CGAL/Point_set_skeletonization_3/internal/interface/Skeletonizer_impl.h>
#include <CGAL/Point_set_skeletonization_3/internal/io/skeleton_file_impl.h>
