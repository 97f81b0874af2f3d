// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_METHOD_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_METHOD_H

#include <CGAL/Curve_skeleton_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Surface_mesh.h>

#include <string>
#include <utility>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Skeleton = CGAL::Curve_skeleton_3<Kernel>;
using Mesh = CGAL::Surface_mesh<Point>;

/// What a method may look at; empty is what it did not ask for.
struct Method_input
{
  std::vector<Point> points;
  std::vector<Vector> normals;  ///< of the points, of length 1, pointing outwards
  std::vector<Mesh> components; ///< closed triangle meshes, one component each, facing outwards
};

/// What a method makes of it.
struct Method_result
{
  Skeleton skeleton; ///< radii are 0 and indices empty where the method knows none
  std::vector<std::pair<std::string, double>> stages; ///< name and wall-clock seconds, in order
};

/// Calls `work` and returns what it returns; its seconds become a stage of the result.
template <typename Work>
auto timed_stage(Method_result& result, const std::string& name, const Work& work)
{
  struct Stage
  {
    Method_result& result;
    const std::string& name;
    CGAL::Real_timer timer;
    ~Stage() { result.stages.emplace_back(name, timer.time()); }
  } stage{result, name, {}};
  stage.timer.start();
  return work();
}

/// What `next` returned after `first` had made its input: with the stages of both.
inline Method_result after(const Method_result& first, Method_result next)
{
  next.stages.insert(next.stages.begin(), first.stages.begin(), first.stages.end());
  return next;
}

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_METHOD_H
