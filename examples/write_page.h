// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_EXAMPLES_WRITE_PAGE_H
#define POINT_SET_SKELETONIZATION_3_EXAMPLES_WRITE_PAGE_H

#include "Skeletonized_cloud.h"

#include <ostream>

/// Writes an HTML page that shows a cloud and its skeleton, to be turned, in any browser with
/// WebGL. It needs no other file. Of a large cloud it holds 250 000 points: with a skeleton of 10
/// 000 vertices it has less than 5 MB, whatever the cloud.
void write_page(std::ostream& os, const Skeletonized_cloud& cloud);

#endif // POINT_SET_SKELETONIZATION_3_EXAMPLES_WRITE_PAGE_H
