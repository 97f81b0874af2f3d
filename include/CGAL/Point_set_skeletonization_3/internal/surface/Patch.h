// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_PATCH_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_PATCH_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// One or more mixture components as a piece of the surface, in normalised coordinates.
struct Patch
{
  Vector3 mean = Vector3::Zero();
  double weight = 0; ///< Number of points.
  std::size_t components = 1; ///< Number of mixture components.

  /// Area of the surface that it represents.
  double area = 0;

  /// Unit normal; its sign is arbitrary until `orient_patches()`.
  Vector3 normal = Vector3::UnitZ();

  /// In [0, 1]: 1 for a plane, 0 where the two smaller eigenvalues are equal or the neighbourhood
  /// is a line, so that the normal is arbitrary.
  double planarity = 0;

  /// Whether its neighbourhood is a line.
  bool is_on_line = false;

  /// Typical distance to the adjacent patches, > 0: of a single component to the fifth nearest
  /// neighbour (of ten).
  double spacing = 0;

  /// The same of its mixture components: how finely the surface is known there.
  double resolution() const { return spacing / std::sqrt(static_cast<double>(components)); }

  /// Adjacent patches, ascending; symmetric.
  std::vector<std::size_t> neighbors;
};

using Patches = std::vector<Patch>;

/// How much two adjacent patches look like parts of one sheet, in [0, 1]: 1 for coplanar ones.
inline double coplanarity(const Patch& a, const Patch& b)
{
  return std::abs(a.normal.dot(b.normal)) * a.planarity * b.planarity;
}

/// Lower bound of the spacing, in bounding box diagonals: patches may coincide, and lengths
/// relative to the spacing must be finite. Below the spacing of any grid.
constexpr double least_spacing = 1e-6;

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_PATCH_H
