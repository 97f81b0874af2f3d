// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_SCANNER_H
#define POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_SCANNER_H

#include "Known_shape.h"

#include <cstddef>
#include <vector>

/// A laser scanner: it sees what is not hidden, as densely as its pulses are, from some places.
namespace shapes {

struct Scan_options
{
  std::size_t points = 20000; ///< about
  int places = 3;             ///< of the scanner, around the shape; of six, one above it
  double range_noise = 0;     ///< standard deviation along the pulses, in diagonals
  double mixed = 0; ///< share of pulses on an edge that end between what is before and behind
  double lost = 0;  ///< share of pulses without a return
  int beams = 1;    ///< distance of the rows of pulses, in pulses: few beams, one above the other
};

struct Scan
{
  std::vector<Vector> points;
  std::vector<Vector> places; ///< of the scanner
  double spacing = 0; ///< of neighbouring pulses of a row, in the middle of the shape
};

/// A scan of a shape that stands upright along z. The same arguments give the same cloud.
Scan scan(const Known_shape& shape, const Scan_options& options, unsigned seed);

} // namespace shapes

#endif // POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_SCANNER_H
