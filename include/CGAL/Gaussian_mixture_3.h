// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GAUSSIAN_MIXTURE_3_H
#define CGAL_GAUSSIAN_MIXTURE_3_H

#include <CGAL/license/Point_set_skeletonization_3.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Origin.h>

#include <array>
#include <vector>

namespace CGAL {

/// \ingroup PkgPointSetSkeletonization3Ref
///
/// An anisotropic Gaussian of a mixture: a small surface patch of the input.
template <typename GeomTraits>
struct Gaussian_component_3
{
  using FT = typename GeomTraits::FT;
  using Point_3 = typename GeomTraits::Point_3;

  /// Number of input points of the component, > 0; fractional after expectation maximization, and
  /// divided by the local density in the published method.
  FT weight = 0;

  /// Mean, in the coordinates of the input.
  Point_3 mean = typename GeomTraits::Construct_point_3()(ORIGIN);

  /// Covariance (length squared), symmetric positive semidefinite, as its upper triangle
  /// xx, xy, xz, yy, yz, zz - the order of CGAL's `DiagonalizeTraits`.
  std::array<FT, 6> covariance{{0, 0, 0, 0, 0, 0}};
};

/// \ingroup PkgPointSetSkeletonization3Ref
///
/// A hierarchy of Gaussian mixtures of one point set; data only.
///
/// Every level describes the whole input and has the same total weight, mean and covariance;
/// `levels.front()` is the finest, `levels.back()` the coarsest. Empty for an empty input.
template <typename GeomTraits>
struct Gaussian_mixture_3
{
  using Component = Gaussian_component_3<GeomTraits>;
  using Level = std::vector<Component>;

  std::vector<Level> levels;

  /// Edge length of the grid cells that are the components of the finest level, in the unit of the
  /// input; 0 if they are not grid cells.
  typename GeomTraits::FT cell_size = 0;

  /// The bounding box of the points, whose centre is the origin of the grid; empty if unknown.
  Bbox_3 bbox;
};

} // namespace CGAL

#endif // CGAL_GAUSSIAN_MIXTURE_3_H
