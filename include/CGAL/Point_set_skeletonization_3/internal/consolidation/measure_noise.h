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

/// When a mixture is noisy. Scatter and sphericity have no unit.
struct Noise_options
{
  /// Scatter, in radii of the narrowest window, > 0: components move above it, all the way from
  /// twice that on. Uneven sampling alone gives up to 0.03, noise of a quarter of the spacing 0.05
  /// and more.
  double least_scatter = 0.03;

  /// Sphericity, > 0, halfway between a plane and a ball of points: up to half of it a window shows
  /// a plane, from one and a half times it on it shows none. Components move, too, if the narrowest
  /// windows show no plane: noise that fills a volume evenly has no scatter, but is nowhere flat.
  double round = 0.2;

  /// Linearity, in (0, 1), from which on a narrow window shows a thin limb as a line. Twigs of a
  /// few points across look as noise does, but wider windows do not show a plane: they stay as
  /// they are. Of 650 tips in sparse scans 501 were found with 0, 483 with 0.25, 443 with 0.5, 396
  /// without lines; of 60 sparse noisy clouds 34, 37, 37 and 37 were exact.
  double line = 0.25;

  /// Greatest sphericity of a plane.
  double flat() const { return round / 2; }

  /// 0 for the sphericity of a plane, 1 where a window shows none.
  double roundness(double sphericity) const
  {
    return (std::min)(1.0, (std::max)(0.0, (sphericity - flat()) / round));
  }

  /// Checks all ranges.
  void check() const
  {
    CGAL_precondition(least_scatter > 0 && round > 0);
    CGAL_precondition(line > 0 && line < 1);
  }

  /// Calls `visit(name, value)` for every option.
  template <typename Visit>
  void visit(const Visit& visit)
  {
    visit("least_scatter", least_scatter);
    visit("round", round);
    visit("line", line);
  }
};

/// The noise of a mixture.
struct Noise
{
  double strength = 0;  ///< In [0, 1]: share of their way that components move.
  std::size_t size = 0; ///< Index of the window: wider than the noise, narrower than limbs.
  double variance = 0;  ///< Of the noise along the normal of the surface.

  /// Density around each component, in the narrowest window.
  std::vector<double> densities;
};

/// Returns the features of windows of one size around each `every`-th component; defaults for the
/// others.
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
  // Outliers are not in `space`, but have windows as well.
  parallel_for(concurrency, moving.mixture.size(), [&](std::size_t i) {
    if(!moving.is_outlier[i])
      return;
    Scale_space::Views views(space, Eigen::AlignedBox3d(moving.positions[i]));
    look(i, views);
  });
  return result;
}

/// Returns the median of absolute values of a normal distribution, the least that fits their tenth,
/// their quarter or their half. Noise is normal and everywhere, so that all three agree; on a shape
/// with thin limbs or edges the deviations there are large, but those elsewhere small.
inline double scale_of_normal(const std::vector<double>& values)
{
  constexpr double tenth = 0.1257, quarter = 0.3186, half = 0.6745; // quantiles of |N(0, 1)|
  return (std::min)({quantile(values, 0.1) * (half / tenth),
                   quantile(values, 0.25) * (half / quarter), quantile(values, 0.5)});
}

/// Returns the way from each component to the middle of its window, less the mean of that of its
/// neighbours. On a curved surface all components are as far off the middle; only the difference to
/// the neighbours is noise. O(n).
inline std::vector<Vector3> ways_to_middle(const std::vector<Local_shape>& shapes,
                                           const Moving_mixture& moving,
                                           const K_nearest_neighbors& nearest,
                                           Concurrency concurrency)
{
  std::vector<Vector3> way;
  for(std::size_t i = 0; i < shapes.size(); ++i)
    way.push_back(shapes[i].mean - moving.positions[i]);
  std::vector<Vector3> result(shapes.size());
  parallel_for(concurrency, result.size(), [&](std::size_t i) {
    constexpr std::size_t neighbors = 9; // the component itself and a ring around it
    const std::size_t size = (std::min)(neighbors, nearest.k());
    Vector3 mean = Vector3::Zero();
    for(std::size_t k = 0; k < size; ++k)
      mean += way[nearest[i][static_cast<std::ptrdiff_t>(k)].index] / static_cast<double>(size);
    result[i] = way[i] - mean;
  });
  return result;
}

/// Returns the distance of each component from the surface through its neighbours, in radii of its
/// window. O(n).
inline std::vector<double> scatters(const std::vector<Local_shape>& shapes,
                                    const std::vector<Vector3>& ways)
{
  std::vector<double> result;
  for(std::size_t i = 0; i < shapes.size(); ++i)
    result.push_back(std::abs(shapes[i].normal.dot(ways[i])) / shapes[i].radius);
  return result;
}

/// Returns the shortest tenth of the distances of components from the middle across their limbs, in
/// medians; 0 if all are in the middle. Windows that show a line do not count. O(n).
inline double shortest_across(const std::vector<Local_shape>& shapes,
                              const std::vector<Vector3>& ways, const Noise_options& options)
{
  std::vector<double> across; // not along a limb, where sampling is uneven
  for(std::size_t i = 0; i < shapes.size(); ++i)
    if(shapes[i].linearity < options.line)
      across.push_back((ways[i] - shapes[i].axis.dot(ways[i]) * shapes[i].axis).norm());
  const double median = across.empty() ? 0 : quantile(across, 0.5);
  return median > 0 ? quantile(std::move(across), 0.1) / median : 0;
}

/// Whether nothing is in the middle of limbs as thin as a window: they look as noisy as a line in
/// noise, or as a plane in noise if they are a frame in a plane, but their points are on circles.
/// Noise is densest in the middle, across a limb and across a sheet. The border is between a normal
/// distribution in two dimensions and a disc that is filled evenly. O(n log n).
/// \pre nothing has moved or was averaged yet
inline bool are_limbs_hollow(Scale_space& space, const Moving_mixture& moving,
                             const K_nearest_neighbors& nearest, const Noise_options& options,
                             Concurrency concurrency)
{
  constexpr std::size_t size = 1; // just wider than a limb without planes in the narrowest window
  const double of_noise = std::sqrt(std::log(0.9) / std::log(0.5)), of_disc = std::sqrt(0.1 / 0.5);
  const std::vector<Local_shape> shapes = local_shapes(space, moving, size, 1, concurrency);
  return shortest_across(shapes, ways_to_middle(shapes, moving, nearest, concurrency), options) >
         (of_noise + of_disc) / 2;
}

/// Returns the median scatter where the narrowest windows are flattest. O(n).
inline double scatter_of_flattest(const std::vector<double>& scatters,
                                  const std::vector<Local_shape>& narrowest)
{
  constexpr double share = 0.1; // a trunk and its boughs have that in a scan of a tree
  std::vector<double> sphericities;
  for(const Local_shape& shape : narrowest)
    sphericities.push_back(shape.sphericity);
  const double flattest = quantile(sphericities, share);
  std::vector<double> result;
  for(std::size_t i = 0; i < scatters.size(); ++i)
    if(narrowest[i].sphericity <= flattest)
      result.push_back(scatters[i]);
  return quantile(result, 0.5);
}

/// The share of a shape that counts: nearly every one is smooth in a quarter of its surface.
constexpr double quarter_of_shape = 0.25;

/// Returns how much of what looks like noise is noise, in [0, 1]. Limbs hardly wider than a window
/// look noisy: as far as windows show lines, a quarter of them or less, there is no more noise than
/// where they are flattest. With noise at most one in a hundred shows a line, in scans of trees a
/// seventh and more do. O(n).
/// \param every one window of so many is asked
inline double credibility(const std::vector<double>& scatters,
                          const std::vector<Local_shape>& narrowest, std::size_t every,
                          const Noise_options& options)
{
  double lines = 0, windows = 0;
  for(std::size_t i = 0; i < narrowest.size(); i += every, ++windows)
    lines += narrowest[i].linearity >= options.line;
  const double twigs = (std::min)(1.0, lines / windows / quarter_of_shape);
  const double flattest = scatter_of_flattest(scatters, narrowest);
  const double noisy = std::clamp(2 * flattest / options.least_scatter - 1, 0.0, 1.0);
  return 1 - twigs * (1 - noisy);
}

/// Returns how noisy the narrowest windows look, in [0, 1]. O(n).
/// \param sphericity lower quartile of that of the windows
inline double apparent_noise(const std::vector<double>& scatters, double sphericity,
                             const Noise_options& options)
{
  const double least_round = options.flat() + options.round;
  return std::clamp((std::max)(scale_of_normal(scatters) / options.least_scatter - 1,
                             (sphericity - least_round) / options.round),
                    0.0, 1.0);
}

/// Returns what the variance along the normal is in windows that narrow to a point, from that in
/// one and in the next wider one: curvature adds the fourth power of the radius, noise is the same.
/// Where limbs are not much wider than the windows, most of what these show is curvature. O(1).
inline double variance_of_noise(double narrow, double wide)
{
  const double growth = std::pow(Window_radii::ratio, 4);
  return (std::max)(0.0, (growth * narrow - wide) / (growth - 1));
}

/// Whether most windows reach beyond limbs as thin as they are: their density is less than it was in
/// the next narrower ones. Around a component the weight in a window grows with the third power of
/// its radius inside noise, with the second on a surface and along a limb with the first, until it
/// sees the next limb: a net of limbs is a plane to wide windows, and the limbs are its noise.
/// O(windows). \param narrower densities in the next narrower windows; none of the narrowest
inline bool reach_beyond_limbs(const std::vector<double>& densities,
                               const std::vector<double>& narrower)
{
  std::size_t number = 0;
  for(std::size_t k = 0; k < narrower.size(); ++k)
    number += densities[k] < narrower[k] ? 1 : 0;
  return 2 * number > narrower.size();
}

/// Measures the noise. Noise makes narrow windows spherical; curvature and neighbouring sheets make
/// wide ones spherical. A plane with noise of variance t^2, in a window in which it extends by w^2
/// within the plane and the noise, if it is wide, as far across, has a sphericity s of about
/// 1 / (1 + w^2 / t^2). So in a window wider by a factor r, s / (1 - s) is less by r^2; on a shape
/// that looks alike at every scale it is the same. The window is the last up to which it falls by r
/// or more each time: noise, not shape, explains what was seen. As long as the noise is wider than
/// the window, any fall is enough: few components never look quite round. As long as windows show no
/// plane, they must not reach beyond limbs, either. The lower quartile over the shape counts: noise
/// is everywhere, and nearly every shape is smooth in a quarter of its surface. O(n log n).
/// \pre nothing has moved yet
inline Noise measure_noise(Scale_space& space, const Moving_mixture& moving,
                           const K_nearest_neighbors& nearest, const Window_radii& radii,
                           const Noise_options& options, Concurrency concurrency)
{
  constexpr std::size_t every = 7; // some hundreds of components are enough
  constexpr double least = (std::numeric_limits<double>::min)(); // instead of 0
  Noise result;
  double last = std::numeric_limits<double>::infinity();
  std::vector<double> narrower; // densities
  for(std::size_t size = 0; size < Window_radii::size; ++size) {
    const std::vector<Local_shape> shapes =
      local_shapes(space, moving, size, size == 0 ? 1 : every, concurrency);
    std::vector<double> sphericities, variances, densities;
    for(std::size_t i = 0; i < shapes.size(); i += every) {
      sphericities.push_back(shapes[i].sphericity);
      variances.push_back(shapes[i].variance);
      densities.push_back(shapes[i].density);
    }
    const double sphericity = quantile(sphericities, quarter_of_shape);
    if(size == 0) {
      for(const Local_shape& shape : shapes)
        result.densities.push_back(shape.density);
      const std::vector<double> off =
        scatters(shapes, ways_to_middle(shapes, moving, nearest, concurrency));
      result.strength = apparent_noise(off, sphericity, options) *
                        credibility(off, shapes, every, options);
    }
    const double variance = variance_behind(quantile(variances, quarter_of_shape), radii[size]);
    if(last < 1) // otherwise the window before was inside the noise, and showed nothing else
      result.variance = variance_of_noise(result.variance, variance);
    const double odds = sphericity / (std::max)(1 - sphericity, least);
    const double least_fall = odds < 1 ? Window_radii::ratio : 1;
    if(odds * least_fall >= last) // also on a line of points: no normal at any size
      break;
    if(sphericity > options.flat() && reach_beyond_limbs(densities, narrower))
      break;
    result.size = size;
    result.variance = variance; // until the next window tells how much of it is curvature
    if(result.strength == 0)
      break;
    last = odds;
    narrower = std::move(densities);
  }
  return result;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CONSOLIDATION_MEASURE_NOISE_H
