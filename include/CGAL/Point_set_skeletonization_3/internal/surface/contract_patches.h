// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_CONTRACT_PATCHES_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_CONTRACT_PATCHES_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Moments.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Union_find.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch_groups.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Surface_options.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/estimate_patches.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/facing.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Returns the connected pieces of each group: a few components are flat together even if they are
/// on two sheets. On a line of points, which is flat at any length, every component is a piece.
/// `fine` are the patches of the components. O(adjacent pairs).
inline Patch_groups connected_groups(const Patch_groups& groups, const Patches& fine)
{
  Union_find sets(fine.size());
  for(std::size_t i = 0; i < fine.size(); ++i)
    for(std::size_t j : fine[i].neighbors)
      if(groups.group_of()[i] == groups.group_of()[j] && !fine[i].is_on_line &&
         !fine[j].is_on_line)
        sets.join(i, j);
  std::vector<std::size_t> group_of(fine.size());
  std::size_t size = 0;
  for(std::size_t g = 0; g < groups.size(); ++g)
    for(std::size_t i : groups[g]) // the first of a set has the smallest number
      group_of[i] = sets.find(i) == i ? size++ : group_of[sets.find(i)];
  return {std::move(group_of), size};
}

/// Returns the Gaussian of each group of components; moments stay exact. O(components).
inline Gaussians contracted(const Gaussians& components, const Patch_groups& groups,
                            Concurrency concurrency)
{
  Gaussians result(groups.size());
  parallel_for(concurrency, result.size(), [&](std::size_t g) {
    const Vector3& origin = components[*groups[g].begin()].mean;
    Moments moments;
    for(std::size_t i : groups[g])
      moments.add(components[i].weight, components[i].mean - origin, components[i].covariance);
    result[g] = groups[g].size() == 1 ? components[*groups[g].begin()] : moments.gaussian(origin);
  });
  return result;
}

/// Returns one patch per group of components. `fine` are the patches of the components, and
/// `gaussians` the Gaussians of the groups. Two patches are adjacent if any of their components are
/// and the patches do not face each other: so the adjacency of patches of different size is that of
/// patches of one size. O(adjacent pairs).
inline Patches contracted(const Patches& fine, const Gaussians& gaussians,
                          const Patch_groups& groups, const Surface_options& options,
                          Concurrency concurrency)
{
  Patches patches(groups.size());
  parallel_for(concurrency, patches.size(), [&](std::size_t g) {
    Patch& patch = patches[g];
    for(std::size_t i : groups[g]) {
      patch.area += fine[i].area;
      for(std::size_t j : fine[i].neighbors)
        if(groups.group_of()[j] != g)
          patch.neighbors.push_back(groups.group_of()[j]);
    }
    std::sort(patch.neighbors.begin(), patch.neighbors.end());
    patch.neighbors.erase(std::unique(patch.neighbors.begin(), patch.neighbors.end()),
                          patch.neighbors.end());
    const Patch& first = fine[*groups[g].begin()];
    patch.components = groups[g].size();
    patch.mean = gaussians[g].mean;
    patch.weight = gaussians[g].weight;
    patch.spacing =
      patch.components == 1 ? first.spacing : spacing_of_area(patch.area);
    patch.normal = first.normal;
    patch.planarity = first.planarity;
    if(patch.components > 1) {
      std::vector<Neighbor> near{{0, g}};
      for(std::size_t h : patch.neighbors)
        near.push_back({(gaussians[h].mean - patch.mean).squaredNorm(), h});
      const auto middle = near.begin() + static_cast<std::ptrdiff_t>(near.size() / 2);
      std::nth_element(near.begin(), middle, near.end());
      // Of a small patch between large ones, half of the neighbours count all the same.
      const double scale = (std::max)(patch.spacing, std::sqrt(middle->squared_distance));
      estimate_normal(patch, gaussians, near, scale, options.least_width);
    }
  });
  parallel_for(concurrency, patches.size(), [&](std::size_t g) {
    std::vector<std::size_t>& neighbors = patches[g].neighbors;
    const auto are_opposite = [&](std::size_t h) {
      return are_opposite_sheets(patches[g], patches[h], options);
    };
    neighbors.erase(std::remove_if(neighbors.begin(), neighbors.end(), are_opposite),
                    neighbors.end());
  });
  return patches;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_CONTRACT_PATCHES_H
