// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_EXAMPLES_DRAW_PICTURE_H
#define POINT_SET_SKELETONIZATION_3_EXAMPLES_DRAW_PICTURE_H

#include "Skeletonized_cloud.h"

#include <ostream>

/// Draws a cloud and its skeleton from two sides, as a PNG: the skeleton coloured by its radius,
/// with its tips blue and its junctions red. \throw std::runtime_error
void write_png(std::ostream& os, const Skeletonized_cloud& cloud);

/// The same as an SVG, with fewer points.
void write_svg(std::ostream& os, const Skeletonized_cloud& cloud);

#endif // POINT_SET_SKELETONIZATION_3_EXAMPLES_DRAW_PICTURE_H
