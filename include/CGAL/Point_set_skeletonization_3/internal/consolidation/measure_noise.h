// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CONSOLIDATION_MEASURE_NOISE_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CONSOLIDATION_MEASURE_NOISE_H

#include <CGAL/Point_set_skeletonization_3/internal/consolidation/Scale_space.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/quantile.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/K_nearest_neighbors.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// When a mixture counts as noisy. Scatter and sphericity have no unit.
struct Noise_options
{
  /// Scatter, in radii of the narrowest window, from which on components move; at twice that they move
  /// all the way. Uneven sampling alone measures up to 0.03, noise of a quarter of the spacing 0.05 and
  /// more.
  double least_scatter = 0.03;

  /// The same of the sphericity in the narrowest window: so much noise that it fills a volume evenly
  /// has no scatter, but nothing is flat.
  double least_sphericity = 0.3, full_sphericity = 0.5;

  /// Sphericity below which no wider window is tried: noise of a fifth of the window's radius.
  double flat = 0.15;

  void check() const
  {
    CGAL_precondition(least_scatter > 0);
    CGAL_precondition(0 < least_sphericity && least_sphericity < full_sphericity);
    CGAL_precondition(flat > 0);
  }

  /// Calls `visit(name, value)` for every option.
  template <typename Visit>
  void visit(const Visit& visit)
  {
    visit("least_scatter", least_scatter);
    visit("least_sphericity", least_sphericity);
    visit("full_sphericity", full_sphericity);
    visit("flat", flat);
  }
};

/// How much noise there is in a mixture.
struct Noise
{
  double strength = 0;  ///< In [0, 1]: how far components are to be moved; 0 without noise.
  std::size_t size = 0; ///< Of the window that is wider than the noise and narrower than the limbs.
  double thickness = 0; ///< Of the noisy surface, one standard deviation.

  /// Weight over area around every component, in the narrowest window.
  std::vector<double> densities;
};

/// What a window of one size shows around every `every`-th component; nothing of the others.
inline std::vector<Local_shape> local_shapes(Scale_space& space, const Moving_mixture& moving,
                                             std::size_t size, std::size_t every,
                                             Concurrency concurrency)
{
  space.make_window(size);
  std::vector<Local_shape> result(moving.mixture.size());
  const auto look = [&](std::size_t i, Scale_space::Views& views) {
    if(i % every == 0)
      result[i] = views[size].shape(moving.positions[i]);
  };
  space.for_each(look);
  // An outlier shows what is around it, too.
  parallel_for(concurrency, moving.mixture.size(), [&](std::size_t i) {
    if(!moving.is_outlier[i])
      return;
    Scale_space::Views views(space, Eigen::AlignedBox3d(moving.positions[i]));
    look(i, views);
  });
  return result;
}

/// How far components lie off the surface through their neighbours, in the median over the shape, in
/// radii of the narrowest window. On a curved surface all lie off their fitted plane, and by the same;
/// only the difference from the neighbours is noise.
inline double scatter(const std::vector<Local_shape>& narrowest, const Moving_mixture& moving,
                      const K_nearest_neighbors& nearest, double radius, Concurrency concurrency)
{
  std::vector<Vector3> offset;
  for(std::size_t i = 0; i < narrowest.size(); ++i)
    offset.push_back(narrowest[i].mean - moving.positions[i]);
  std::vector<double> off(narrowest.size());
  parallel_for(concurrency, off.size(), [&](std::size_t i) {
    constexpr std::size_t neighbors = 9; // the component itself and a ring around it
    const std::size_t size = std::min(neighbors, nearest.k());
    Vector3 mean = Vector3::Zero();
    for(std::size_t k = 0; k < size; ++k)
      mean += offset[nearest[i][static_cast<std::ptrdiff_t>(k)].index] / static_cast<double>(size);
    off[i] = std::abs(narrowest[i].normal.dot(offset[i] - mean)) / radius;
  });
  return quantile(off, 0.5);
}

/// Measures the noise. Noise makes small windows round, curvature and neighbouring sheets make large
/// ones round; so the window is the first of a row of sizes whose sphericity is small, or grows with
/// the next size. What counts is the first quartile over the shape: noise is everywhere, and nearly
/// every shape is smooth for a quarter. \pre nothing has moved yet
inline Noise measure_noise(Scale_space& space, const Moving_mixture& moving,
                           const K_nearest_neighbors& nearest, const Window_radii& radii,
                           const Noise_options& options, Concurrency concurrency)
{
  constexpr std::size_t every = 7; // some hundreds are enough
  constexpr double quartile = 0.25;
  const auto ramp = [](double value, double least, double full) {
    return (value - least) / (full - least);
  };
  Noise result;
  double least = std::numeric_limits<double>::infinity();
  for(std::size_t size = 0; size < Window_radii::size; ++size) {
    const std::vector<Local_shape> shapes =
      local_shapes(space, moving, size, size == 0 ? 1 : every, concurrency);
    std::vector<double> sphericities, thicknesses;
    for(std::size_t i = 0; i < shapes.size(); i += every) {
      sphericities.push_back(shapes[i].sphericity);
      thicknesses.push_back(shapes[i].thickness);
    }
    const double sphericity = quantile(sphericities, quartile);
    if(size == 0) {
      for(const Local_shape& shape : shapes)
        result.densities.push_back(shape.density);
      const double scattered = scatter(shapes, moving, nearest, radii[0], concurrency);
      result.strength = std::min(
        1.0, std::max({0.0, ramp(scattered, options.least_scatter, 2 * options.least_scatter),
                       ramp(sphericity, options.least_sphericity, options.full_sphericity)}));
    }
    if(sphericity > least)
      break;
    result.size = size;
    result.thickness = quantile(thicknesses, quartile);
    least = sphericity;
    if(sphericity < options.flat)
      break;
  }
  return result;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CONSOLIDATION_MEASURE_NOISE_H
