// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_H

#include <CGAL/Curve_skeleton_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Real_timer.h>

#include <exception>
#include <string>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Skeleton = CGAL::Curve_skeleton_3<Kernel>;

/// What a method made of a cloud or a mesh.
struct Outcome
{
  std::string method;
  Skeleton skeleton;
  double seconds = 0;
  std::string status = "ok"; ///< or what went wrong
};

/// Whether no coordinate of a vertex is infinite or NaN.
bool has_finite_points(const Skeleton& skeleton);

/// Times `make_skeleton` and keeps what it returns or throws.
template <typename Make_skeleton>
Outcome run_method(const std::string& method, const Make_skeleton& make_skeleton)
{
  Outcome outcome;
  outcome.method = method;
  CGAL::Real_timer timer;
  timer.start();
  try {
    outcome.skeleton = make_skeleton();
    if(!has_finite_points(outcome.skeleton)) {
      outcome.skeleton.clear();
      outcome.status = "not finite";
    }
  } catch(const std::exception& error) {
    outcome.status = error.what();
  }
  outcome.seconds = timer.time();
  return outcome;
}

/// This package on a raw cloud, by default and, if wanted, as published.
std::vector<Outcome> skeletonize(const std::vector<Point>& points, bool also_as_published);

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_H
