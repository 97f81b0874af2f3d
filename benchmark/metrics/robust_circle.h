// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_ROBUST_CIRCLE_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_ROBUST_CIRCLE_H

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace metrics {

/// A circle in a plane.
struct Circle
{
  Eigen::Vector2d center;
  double radius;
};

namespace internal {

/// The upper one of two in the middle. \pre there is a value
inline double median(std::vector<double> values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

} // namespace internal

/// The circle that most points are near, whatever the others are: least squares of the distances
/// from it, weighted again and again with 1 / (1 + (distance / twice the deviation of most)^2).
/// Starts around the median of the coordinates, on which side of the circle that may be.
/// \pre there are points
inline Circle robust_circle(const std::vector<Eigen::Vector2d>& points)
{
  constexpr int rounds = 60;
  constexpr double deviations = 2 * 1.4826; // of the median distance
  const auto median_of = [&](const auto& value) {
    std::vector<double> values;
    for(const Eigen::Vector2d& p : points)
      values.push_back(value(p));
    return internal::median(std::move(values));
  };
  Circle circle;
  circle.center = {median_of([](const Eigen::Vector2d& p) { return p.x(); }),
                   median_of([](const Eigen::Vector2d& p) { return p.y(); })};
  const auto distance = [&](const Eigen::Vector2d& p) { return (p - circle.center).norm(); };
  circle.radius = median_of(distance);
  for(int round = 0; round < rounds; ++round) {
    const double scale = deviations * median_of([&](const Eigen::Vector2d& p) {
                           return std::abs(distance(p) - circle.radius);
                         });
    if(!(scale > 0))
      break; // most are on it
    Eigen::Matrix3d products = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for(const Eigen::Vector2d& p : points) {
      const Eigen::Vector2d outwards = (p - circle.center).normalized();
      const double off = distance(p) - circle.radius;
      const double weight = 1 / (1 + off * off / (scale * scale));
      const Eigen::Vector3d row(outwards.x(), outwards.y(), 1);
      products += weight * row * row.transpose();
      right += weight * off * row;
    }
    const Eigen::Vector3d step = products.ldlt().solve(right);
    circle.center += step.head<2>();
    circle.radius += step.z();
  }
  return circle;
}

} // namespace metrics

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_METRICS_ROBUST_CIRCLE_H
