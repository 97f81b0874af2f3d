// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_TEST_TWO_SPHERES_H
#define POINT_SET_SKELETONIZATION_3_TEST_TWO_SPHERES_H

#include "analytic_surfaces.h"

#include <CGAL/Point_set_skeletonization_3/internal/spatial/K_nearest_neighbors.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/estimate_patches.h>

#include <cmath>
#include <cstddef>

namespace surfaces {

constexpr std::size_t patches_of_sphere = 600;

/// Centre of the `k`-th of two spheres.
inline Vector3 center_of_sphere(std::size_t k)
{
  return k == 0 ? Vector3(-0.6, 0, 0) : Vector3(0.6, 0.1, 0);
}

/// Patches of two spheres of radius 0.4 as the package estimates them, those of the first before
/// those of the second.
inline Patches two_spheres()
{
  namespace internal = CGAL::Point_set_skeletonization_3::internal;
  internal::Gaussians gaussians;
  for(std::size_t k = 0; k < 2; ++k)
    for(std::size_t i = 0; i < patches_of_sphere; ++i) { // a spiral, with patches of equal area
      const double z = 1 - (2 * static_cast<double>(i) + 1) / patches_of_sphere;
      const double angle = CGAL_PI * (1 + std::sqrt(5)) * static_cast<double>(i);
      const Vector3 d(std::sqrt(1 - z * z) * std::cos(angle),
                      std::sqrt(1 - z * z) * std::sin(angle), z);
      gaussians.push_back({1, center_of_sphere(k) + 0.4 * d, internal::Matrix3::Zero()});
    }
  constexpr auto sequential = internal::Concurrency::sequential;
  const Box_tree tree(internal::means_of(gaussians));
  return internal::estimate_patches(
    gaussians,
    internal::k_nearest_neighbors(tree, internal::surface_neighbors + 1, sequential),
    internal::Surface_options(), sequential);
}

} // namespace surfaces

#endif // POINT_SET_SKELETONIZATION_3_TEST_TWO_SPHERES_H
