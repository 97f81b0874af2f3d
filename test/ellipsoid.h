// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_TEST_ELLIPSOID_H
#define POINT_SET_SKELETONIZATION_3_TEST_ELLIPSOID_H

#include "analytic_surfaces.h"
#include "generator/Random.h"

#include <cmath>
#include <cstddef>

namespace surfaces {

/// Patches of an ellipsoid with semi-axes 1, 1 and 0.4, at random places, with outward normals and
/// without neighbours.
inline Patches ellipsoid(std::size_t size, unsigned int seed)
{
  shapes::Random random(seed);
  const Vector3 axes(1, 1, 0.4);
  Patches patches(size);
  for(Patch& patch : patches) {
    const Vector3 direction = random.direction();
    patch.mean = axes.cwiseProduct(direction);
    patch.normal = direction.cwiseQuotient(axes).normalized();
    // The map from the sphere stretches areas by the product of the axes times |direction / axes|.
    patch.area = 4 * CGAL_PI / static_cast<double>(size) * axes.prod() *
                 direction.cwiseQuotient(axes).norm();
    patch.planarity = 1;
    patch.spacing = std::sqrt(patch.area);
  }
  return patches;
}

} // namespace surfaces

#endif // POINT_SET_SKELETONIZATION_3_TEST_ELLIPSOID_H
