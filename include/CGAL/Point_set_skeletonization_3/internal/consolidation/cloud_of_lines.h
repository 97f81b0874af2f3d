// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CONSOLIDATION_CLOUD_OF_LINES_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CONSOLIDATION_CLOUD_OF_LINES_H

#include <CGAL/Point_set_skeletonization_3/Medial_sample_kind.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Dimensionality.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/quantile.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/straightness.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/Box_tree.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/K_nearest_neighbors.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/Neighbor.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/components_within.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Returns the distance of a component to its fourth nearest neighbour, or to the last of fewer.
inline double spacing_of(std::size_t i, const K_nearest_neighbors& nearest)
{
  const auto fourth = static_cast<std::ptrdiff_t>((std::min<std::size_t>)(4, nearest.k() - 1));
  return std::sqrt(nearest[i][fourth].squared_distance);
}

/// Whether a component and those around are on lines, on twigs thinner than their points are
/// apart. An outlier is straight with its neighbours if these are, but hardly one of theirs. O(1).
inline bool is_on_lines(std::size_t i, const Gaussians& components,
                        const K_nearest_neighbors& nearest)
{
  std::size_t times = 0; // it is a neighbour
  Straightness straightness;
  for(const Neighbor& near : nearest[i]) {
    const auto around = nearest[near.index];
    times += std::any_of(around.begin(), around.end(),
                         [&](const Neighbor& other) { return other.index == i; });
    straightness.add(
      are_straight((std::min)(places_of_line, nearest.k()), [&](std::size_t k) -> Vector3 {
        return components[around[static_cast<std::ptrdiff_t>(k)].index].mean - components[i].mean;
      }));
  }
  constexpr std::size_t fewest = 3; // itself, and one on either side
  return times >= fewest && straightness.is_on_lines();
}

/// Whether a component is in a sheet: the places within five spacings, a few dozen of a sheet. At
/// the rim of a leaf, and in rows of a scanner, nearest neighbours are straight as well. O(places).
inline bool is_in_sheet(std::size_t i, const Gaussians& components, const Box_tree& tree,
                        const K_nearest_neighbors& nearest)
{
  constexpr double reach = 5; // spacings
  const Spread_components around =
    components_within(tree, components[i].mean, reach * spacing_of(i, nearest));
  return dimensionality(around.covariance, around.number).kind() == Medial_sample_kind::sheet;
}

/// Least share of components on lines of a cloud of lines, of which there are `number`: 0.43 of
/// 4200. The fewer there are, the less they show of a surface, and the more detail is worth than
/// smoothness (`Grid_options::minimum_cells`): 0.14 less for half of them, so that 500, too few to
/// surround limbs, are always of lines, and more than 70 000 never. Of samples of trees 34 to 83 %
/// are on lines, of trees scanned with a few beams less than 43 %, of surfaces less than 10 %; of
/// crowns in leaf scanned from one place 27 % of 3500, but 48 % of 6600.
inline double least_share_on_lines(std::size_t number)
{
  constexpr double per_doubling = 0.14, too_few = 500;
  return per_doubling * std::log2(static_cast<double>(number) / too_few);
}

/// Whether a cloud is one of lines, as a sparse scan of a tree, whose twigs are single rows of
/// points. There, what is sparse is neither an outlier nor the tail of noise, but what the cloud is
/// made of; so the sparser half of the components is asked: many are on lines, and not in a sheet,
/// see `least_share_on_lines()`. Rows of a scanner of few beams are lines as well, until
/// `with_rows_merged()`. O(n), at most 2000 components are asked.
/// \param nearest of the components, each first itself
inline bool is_cloud_of_lines(const Gaussians& components, const Box_tree& tree,
                              const K_nearest_neighbors& nearest)
{
  constexpr std::size_t fewest = 2000; // of which half are sparse
  const std::size_t step = (std::max<std::size_t>)(1, components.size() / fewest);
  std::vector<double> spacings;
  for(std::size_t i = 0; i < components.size(); i += step)
    spacings.push_back(spacing_of(i, nearest));
  const double median = quantile(spacings, 0.5);
  std::size_t sparse = 0, on_lines = 0;
  for(std::size_t k = 0; k < spacings.size(); ++k)
    if(spacings[k] > median) {
      const std::size_t i = k * step;
      ++sparse;
      on_lines += is_on_lines(i, components, nearest) && !is_in_sheet(i, components, tree, nearest);
    }
  return static_cast<double>(on_lines) >=
         least_share_on_lines(components.size()) * static_cast<double>(sparse);
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CONSOLIDATION_CLOUD_OF_LINES_H
