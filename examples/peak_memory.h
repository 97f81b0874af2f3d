// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_EXAMPLES_PEAK_MEMORY_H
#define POINT_SET_SKELETONIZATION_3_EXAMPLES_PEAK_MEMORY_H

#include <sys/resource.h>

/// The most memory that this process had so far, in MB.
inline double peak_megabytes()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
#ifdef __APPLE__
  constexpr double units = 1e6; // bytes
#else
  constexpr double units = 1e3; // kB
#endif
  return static_cast<double>(usage.ru_maxrss) / units;
}

#endif // POINT_SET_SKELETONIZATION_3_EXAMPLES_PEAK_MEMORY_H
