// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "l1_wlop.h"

#include "neighborhoods.h"
#include "sample_branches.h"
#include "wlop_samples.h"

#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace {

using Eigen::Vector3d;

constexpr std::size_t sample_size = 1000;
constexpr std::size_t neighbors = 6;      // of a sample, for its sigma
constexpr std::size_t least_branch = 5;   // samples
constexpr int max_contractions = 30;      // with one radius
constexpr double least_movement = 0.0005; // in units

} // namespace

Method_result l1_wlop(const Method_input& input)
{
  Method_result result;
  const std::vector<Vector3d> points = methods::to_eigen(input.points);
  Eigen::AlignedBox3d box;
  for(const Vector3d& p : points)
    box.extend(p);
  const double unit = box.sizes().maxCoeff() / 2;
  const double least_radius =
      2 * box.diagonal().norm() / std::cbrt(static_cast<double>(points.size()));

  timed_stage(result, "contraction and branches", [&] {
    methods::Wlop_samples samples(points, sample_size, least_radius);
    methods::Sample_branches branches(samples.samples(), unit);
    for(double radius = least_radius; radius < 2 * unit; radius += least_radius / 2) {
      int step = 0;
      while(samples.contract(radius) > least_movement * unit && ++step < max_contractions) {
      }
      branches.thin();
      samples.update_directions(neighbors);
      branches.grow(radius);
      branches.find(least_branch + static_cast<std::size_t>(radius / least_radius));
      branches.clean();
    }
    branches.join_ends();
    result.skeleton = branches.skeleton();
  });
  if(num_vertices(result.skeleton) == 0)
    throw std::runtime_error("no samples along a line");
  return result;
}
