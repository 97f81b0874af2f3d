// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_POINTS_ACROSS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_POINTS_ACROSS_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/l1_median.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/quantile.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/round_section.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// What the points of a cross-section tell.
struct Points_across
{
  Eigen::Vector2d median; ///< L1-median.
  Eigen::Vector2d middle; ///< The same, on the sheet, or of a circle, as far as they are on one.
  double round_share;     ///< How much the circle counts.
  double spread;          ///< Their median distance from the middle.
};

/// Returns the mean of the quarter of some points that is nearest to a place, which is on the sheet
/// that they are on, if it is bent: with a quarter as wide, an arc is off its mean by a sixteenth of
/// what it was. The place itself if a quarter is less than a dozen: their mean tells no more.
/// O(n log n).
inline Eigen::Vector2d moved_to_sheet(const Eigen::Vector2d& place,
                                      const std::vector<Eigen::Vector2d>& points)
{
  constexpr std::size_t dozen = 12;
  const std::size_t quarter = points.size() / 4;
  if(quarter < dozen)
    return place;
  std::vector<std::pair<double, std::size_t>> near; // indices, so that the order is unique
  for(std::size_t i = 0; i < points.size(); ++i)
    near.emplace_back((points[i] - place).squaredNorm(), i);
  std::nth_element(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(quarter), near.end());
  near.resize(quarter);
  std::sort(near.begin(), near.end()); // the sum depends on the order
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for(const auto& [squared_distance, i] : near)
    mean += points[i] / static_cast<double>(quarter);
  return mean;
}

/// Returns what the points of a slab tell of a limb whose other side was not seen. O(n log n).
/// \pre there are points
/// \param sheet share of the boundary of the cross-section that is missing, in [0, 1]: if points are
///        all around, what is in the middle of them is no sheet
/// \param facing share of the limb that faces another one, in [0, 1]: there it is a sheet, though it
///        may be as round as half a trunk
/// \param resolution typical distance of points
/// \param aligned see `round_section()`
inline Points_across points_across(const Slab& slab, double sheet, double facing,
                                   double resolution, double aligned)
{
  const Round_section round = round_section(slab, aligned);
  const double round_share = (1 - facing) * round.share;
  const Eigen::Vector2d median =
    l1_median(slab.across, (std::max)(0.1 * resolution, least_spacing));
  Eigen::Vector2d middle = median;
  const double on_sheet = (std::max)(sheet, facing);
  if(on_sheet > 0)
    middle += on_sheet * (moved_to_sheet(median, slab.across) - median);
  middle += round_share * (round.circle.center - middle);
  std::vector<double> distances;
  for(const Eigen::Vector2d& p : slab.across)
    distances.push_back((p - middle).norm());
  return {median, middle, round_share, quantile(std::move(distances), 0.5)};
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_POINTS_ACROSS_H
