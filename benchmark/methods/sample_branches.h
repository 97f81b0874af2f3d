// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_SAMPLE_BRANCHES_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_SAMPLE_BRANCHES_H

#include "Method.h"
#include "wlop_samples.h"

#include <Eigen/Core>

#include <cstddef>
#include <limits>
#include <vector>

namespace methods {

/// The branches that contracting samples form. See `l1_wlop()` for the rules.
class Sample_branches
{
public:
  /// `unit` is half the longest side of the bounding box.
  Sample_branches(std::vector<Wlop_sample>& samples, double unit)
      : samples_(samples)
      , unit_(unit)
  {}

  /// Removes all but one of samples that have come together: their order along a line is chance.
  void thin();

  /// Lets branches grow over their bridges, which samples within `radius` of them may replace.
  void grow(double radius);

  /// Makes new branches of at least `least_size` samples.
  void find(std::size_t least_size);

  /// Removes samples that are next to branches.
  void clean();

  /// Joins the ends that have no bridge to what is next to them.
  void join_ends();

  Skeleton skeleton() const;

private:
  using Vector3d = Eigen::Vector3d;
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  // Samples from the seed on to one of the two ends, and the one after the last.
  struct Half
  {
    std::vector<std::size_t> curve;
    std::size_t bridge = none;
  };

  struct Branch
  {
    Half halves[2]; // both start with the seed
  };

  bool is_bridge(std::size_t i) const;
  Vector3d way(std::size_t from, std::size_t to) const;
  Vector3d way_ahead(const Branch& branch, int side) const;
  std::vector<std::size_t> recent(const Half& half, const Half& other) const;
  std::size_t next(std::size_t from, const Vector3d& direction, double max_distance,
                   const std::vector<std::size_t>& not_these) const;
  Half trace(std::size_t seed, const Vector3d& direction, const Half& other,
             std::vector<char>& is_used) const;
  void follow(Branch& branch, int side, double radius) const;
  void join(Branch& branch, int side, double max_distance) const;
  void grow(Branch& branch, int side);
  void fix_shared_bridges();
  void remove(std::size_t i, std::size_t instead);

  std::vector<Wlop_sample>& samples_;
  double unit_;
  std::vector<Branch> branches_;
};

} // namespace methods

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_SAMPLE_BRANCHES_H
