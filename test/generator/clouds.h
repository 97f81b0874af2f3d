// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_CLOUDS_H
#define POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_CLOUDS_H

#include "Known_shape.h"
#include "Random.h"

#include <cstddef>
#include <vector>

namespace shapes {

/// What a scanner does to a surface.
enum class Variant
{
  clean,              ///< Uniform by area.
  noise_half_percent, ///< Isotropic Gaussian noise, of the bounding box' diagonal.
  noise_one_percent,
  outliers,       ///< Two per cent of the points anywhere in the bounding box, enlarged by 1.2.
  holes,          ///< Patches nearly as large as the limb is thick have no points.
  falling_density, ///< Falls by a factor of eight along a random direction.
  slices ///< In parallel planes, six times as far apart as the points in one are from each other.
};

const std::vector<Variant>& all_variants();

/// Those that sample a surface evenly in all directions: all but the slices.
const std::vector<Variant>& usual_variants();

const char* to_string(Variant variant);

struct Ball
{
  Vector centre;
  double radius;

  bool contains(const Vector& p) const { return (p - centre).norm() < radius; }
};

/// Up to ten balls about points of the surface, no two of them round the same place of a limb:
/// together they cut none through.
std::vector<Ball> random_holes(const Known_shape& shape, Random& random);

/// Points that are uniform by area.
std::vector<Vector> sample_clean(const Known_shape& shape, std::size_t number_of_points,
                                 Random& random);

/// Points that are uniform by area, of the solid and the sheets: as of a mesh, seen from all sides.
/// A limb that is thinner than the points are apart has them in a line, further apart.
/// The same arguments give the same cloud.
std::vector<Vector> sample_all(const Known_shape& shape, std::size_t number_of_points,
                               unsigned seed);

/// A raw point cloud of the surface, with exactly the number of points asked for. The same
/// arguments give the same cloud.
std::vector<Vector> sample(const Known_shape& shape, Variant variant, std::size_t number_of_points,
                           unsigned seed);

} // namespace shapes

#endif // POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_CLOUDS_H
