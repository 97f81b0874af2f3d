// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_MESHES_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_MESHES_H

#include "Quality_options.h"

#include <string>
#include <vector>

/// `quality meshes`: points sampled on closed meshes, beside a method that gets the meshes.
namespace meshes {

/// Prints the table and its summary. \throw std::runtime_error
void run(const Quality_options& options);

/// Files as they are; of a folder, the sample models.
std::vector<std::string> chosen_files(const std::vector<std::string>& files);

} // namespace meshes

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_MESHES_H
