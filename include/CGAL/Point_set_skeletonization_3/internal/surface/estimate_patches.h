// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_ESTIMATE_PATCHES_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_ESTIMATE_PATCHES_H


#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Moments.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Per_thread.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/principal_axes.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/K_nearest_neighbors.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Surface_options.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/facing.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// A disc whose radius is the distance to the fifth of the nearest neighbours contains the patch
/// and half of its neighbours: so many patches have its area.
constexpr double patches_of_disc = 6;

/// Returns the spacing of patches of some area.
inline double spacing_of_area(double area) { return std::sqrt(patches_of_disc * area / CGAL_PI); }

/// Sets normal and planarity of a patch, from its own moments and those of its neighbours with a
/// Gaussian weight of width `scale`: moments of a single patch with few points are noisy.
template <typename Neighbors>
void estimate_normal(Patch& patch, const Gaussians& gaussians, const Neighbors& nearest,
                     double scale, double least_width)
{
  Moments moments; // about the mean
  for(const auto& neighbor : nearest) {
    const double r2 = neighbor.squared_distance / (scale * scale);
    const Gaussian& other = gaussians[neighbor.index];
    moments.add(std::exp(-2 * r2) * other.weight, other.mean - patch.mean, other.covariance);
  }
  const auto [variance, directions] = principal_axes(moments.gaussian(patch.mean).covariance);
  patch.normal = directions.col(0).normalized();
  patch.is_on_line = variance[1] < least_width * variance[2];
  if(variance[1] > 1e-10 * variance[2])
    patch.planarity = (1 - variance[0] / variance[1]) *
                      (std::min)(1.0, variance[1] / (least_width * variance[2]));
  if(!patch.normal.allFinite())
    patch.normal = Vector3::UnitZ();
}

/// Returns one patch per Gaussian, with normals of arbitrary sign and adjacency. `nearest` are the
/// `surface_neighbors` of each. O(n).
inline Patches estimate_patches(const Gaussians& gaussians, const K_nearest_neighbors& nearest,
                                const Surface_options& options, Concurrency concurrency)
{
  Patches patches(gaussians.size());
  parallel_for(concurrency, patches.size(), [&](std::size_t i) {
    Patch& patch = patches[i];
    patch.mean = gaussians[i].mean;
    patch.weight = gaussians[i].weight;
    const std::size_t middle = nearest[i].size() / 2;
    // A single patch is as large as the shape.
    patch.spacing =
        nearest[i].size() > 1 ? std::sqrt(nearest[i].begin()[middle].squared_distance) : 1;
    patch.spacing = (std::max)(patch.spacing, least_spacing);
    // A disc of this radius contains the patch and half of its neighbours.
    patch.area = CGAL_PI * patch.spacing * patch.spacing / static_cast<double>(middle + 1);
    estimate_normal(patch, gaussians, nearest[i], patch.spacing, options.least_width);
  });

  parallel_for(concurrency, patches.size(), [&](std::size_t i) {
    patches[i].neighbors.reserve(nearest[i].size());
    for(const auto& neighbor : nearest[i]) {
      const std::size_t j = neighbor.index;
      const double reach =
        options.adjacency_reach * (std::min)(patches[i].spacing, patches[j].spacing);
      if(j != i && neighbor.squared_distance <= reach * reach &&
         !are_opposite_sheets(patches[i], patches[j], options))
        patches[i].neighbors.push_back(j);
    }
  });
  // Makes adjacency symmetric: lists the patches that have found each patch, by counting sort.
  std::vector<std::size_t> end(patches.size() + 1, 0);
  for(const Patch& patch : patches)
    for(std::size_t j : patch.neighbors)
      ++end[j + 1];
  std::partial_sum(end.begin(), end.end(), end.begin());
  std::vector<std::uint32_t> back(end.back()); // here memory is greatest: small
  for(std::size_t i = 0; i < patches.size(); ++i) // afterwards end[j] is the end of the list of j
    for(std::size_t j : patches[i].neighbors)
      back[end[j]++] = static_cast<std::uint32_t>(i);
  Per_thread<std::vector<std::size_t>> buffers(concurrency,
                                               [] { return std::vector<std::size_t>(); });
  parallel_for(concurrency, patches.size(), [&](std::size_t i) {
    std::vector<std::size_t>& both = buffers.local();
    both = patches[i].neighbors;
    both.insert(both.end(), back.data() + (i == 0 ? 0 : end[i - 1]), back.data() + end[i]);
    std::sort(both.begin(), both.end());
    patches[i].neighbors.assign(both.begin(), std::unique(both.begin(), both.end()));
  });
  return patches;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_ESTIMATE_PATCHES_H
