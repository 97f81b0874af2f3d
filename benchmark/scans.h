// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_SCANS_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_SCANS_H

#include "Quality_options.h"

/// `quality scans`: clouds as scanners make them, with the skeleton that is to be found.
namespace scans {

/// Prints the table and its summary. \throw std::runtime_error
void run(const Quality_options& options);

} // namespace scans

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_SCANS_H
