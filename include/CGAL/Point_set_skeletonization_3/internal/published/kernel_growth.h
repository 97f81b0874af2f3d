// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PUBLISHED_KERNEL_GROWTH_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PUBLISHED_KERNEL_GROWTH_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/principal_axes.h>
#include <CGAL/Point_set_skeletonization_3/internal/published/Kernel_packet.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/Packet_tree.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// What a sample sees within its kernel.
struct Surroundings
{
  double density = 1;    ///< w of Eq. 8: 1 + sum of theta over the other samples.
  double neighbors = 0;  ///< n of Eq. 11, the number of other samples.

  /// sigma of Eq. 12, in [0, 1]: 1/3 in isotropic surroundings, 1 along a line; 0 without any other
  /// sample.
  double anisotropy = 0;

  /// Where the variance is largest, of unit length; 0 without any other sample.
  Vector3 direction = Vector3::Zero();

  Surroundings() = default;

  /// \param covariance C of Eq. 13, up to a factor
  Surroundings(double w, double n, const Matrix3& covariance) : density(w), neighbors(n)
  {
    const double trace = covariance.trace();
    if(!(trace > 0))
      return;
    const Principal_axes axes = principal_axes(covariance);
    anisotropy = axes.variances[2] / trace;
    direction = axes.directions.col(2);
  }

  /// The growth factor nu in [0, 1] of the kernel (Eq. 11): 1 in isotropic surroundings, near 0
  /// where the samples are collinear.
  double growth_factor() const
  {
    return neighbors > 2 ? 1 - (neighbors - 2) / (neighbors - 1) * anisotropy : 1;
  }
};

/// Returns what each kernel sees of the samples of `tree`, of which its own is one (Eq. 8 and 11 to
/// 13). Fast if consecutive kernels are close. O(n^2) if the kernels are as wide as the shape.
inline std::vector<Surroundings> surroundings(const Packet_tree& tree, const Kernels& kernels,
                                              Concurrency concurrency)
{
  std::vector<Surroundings> result(kernels.size());
  for_each_packet(concurrency, kernels.size(), [&](std::size_t first, std::size_t end) {
    Packet_values density = Packet_values::Zero(), count = Packet_values::Zero();
    Packet_vectors diagonal{density, density, density}, mixed = diagonal; // of C, Eq. 13
    const Kernel_packet packet(tree, kernels, first, end);
    packet.for_each_within(
      tree, packet.squared_radius,
      [&](std::size_t, const Packet_vectors& d, const Packet_values& squared) {
        const Packet_values theta = packet.theta(squared);
        density += theta;
        count += is_positive(theta);
        const Packet_values x = theta * d.x, y = theta * d.y, z = theta * d.z;
        diagonal.x += x * d.x;
        diagonal.y += y * d.y;
        diagonal.z += z * d.z;
        mixed.x += y * d.z;
        mixed.y += z * d.x;
        mixed.z += x * d.y;
      });
    for(std::size_t i = first; i < end; ++i) {
      const std::size_t k = i - first;
      Eigen::Matrix3f covariance;
      covariance << diagonal.x[k], mixed.z[k], mixed.y[k], //
        mixed.z[k], diagonal.y[k], mixed.x[k],             //
        mixed.y[k], mixed.x[k], diagonal.z[k];
      // The sample itself adds 1 to the density, 1 to the number, nothing to the covariance.
      result[i] = {density[k], count[k] - 1, covariance.cast<double>()};
    }
  });
  return result;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PUBLISHED_KERNEL_GROWTH_H
