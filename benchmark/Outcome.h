// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_OUTCOME_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_OUTCOME_H

#include "Quality_options.h"
#include "methods/Method.h"

#include <string>
#include <vector>

/// What a method made of a cloud or a mesh.
struct Outcome
{
  std::string method;
  Skeleton skeleton;
  double seconds = 0;
  std::string status = "ok"; ///< or what went wrong
};

/// Times a method and keeps what it returns or throws.
Outcome run_method(const std::string& name, Method_result (&method)(const Method_input&),
                   const Method_input& input);

/// The spanning tree of the points, as a baseline.
Outcome baseline(const std::vector<Point>& points);

/// This package on a raw cloud, by default and, if wanted, as published; if there is a neighbour, on
/// both beside each other, and what the cloud has of that.
std::vector<Outcome> skeletonize(const std::vector<Point>& points, const Quality_options& options);

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_OUTCOME_H
