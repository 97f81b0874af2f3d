// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_WLOP_SAMPLES_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_WLOP_SAMPLES_H

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace methods {

/// A sample of a cloud on its way to the skeleton.
struct Wlop_sample
{
  enum class State
  {
    moving,
    fixed,
    removed
  };

  Eigen::Vector3d point;
  State state = State::moving;
  double directionality = 0; ///< sigma of the publication: 1/3 of a ball to 1 of a line
  Eigen::Vector3d direction = Eigen::Vector3d::UnitX(); ///< that most samples around lie in

  bool is_moving() const { return state == State::moving; }
  bool is_fixed() const { return state == State::fixed; }
  bool is_removed() const { return state == State::removed; }
};

/// Samples of a cloud that contract to local L1-medians: the locally optimal projection, weighted
/// by the density of the cloud and with a repulsion between the samples that is strong where they
/// are along a line. Huang et al., L1-Medial Skeleton of Point Cloud, 2013, equations 2 to 4.
class Wlop_samples
{
public:
  /// At most `size` of the points, at random. The density is that within `radius`.
  Wlop_samples(const std::vector<Eigen::Vector3d>& points, std::size_t size, double radius);

  /// One step of all moving samples, with neighbourhoods of `radius`. \return the mean way they
  /// went
  double contract(double radius);

  /// Updates the directions of moving samples from so many others that are nearest; the
  /// directionality is averaged over these.
  void update_directions(std::size_t neighbors);

  std::vector<Wlop_sample>& samples() { return samples_; }

private:
  Eigen::Vector3d median(const Eigen::Vector3d& center, double radius) const;
  Eigen::Vector3d repulsion(std::size_t i, double radius) const;
  void find_direction(std::size_t i, double radius);

  std::vector<Eigen::Vector3d> points_;
  std::vector<double> weights_; // reciprocal densities
  std::vector<Wlop_sample> samples_;
};

} // namespace methods

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_WLOP_SAMPLES_H
