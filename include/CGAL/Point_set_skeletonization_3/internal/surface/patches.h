// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_PATCHES_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_PATCHES_H

#include <CGAL/Point_set_skeletonization_3/internal/spatial/Box_tree.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/K_nearest_neighbors.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel_for.h>

#include <CGAL/number_utils.h>

#include <Eigen/Eigenvalues>

#include <boost/range/iterator_range.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// A mixture component read as a piece of surface.
struct Patch
{
  Vector3 mean = Vector3::Zero();
  double weight = 0;

  /// Area of the surface that it stands for.
  double area = 0;

  /// Unit normal; its sign means something only after `orient_patches()`.
  Vector3 normal = Vector3::UnitZ();

  /// How flat the patch and its surroundings are, in [0, 1]: 1 for a plane, 0 where the two
  /// smaller principal variances are equal and a normal is a guess.
  double planarity = 0;

  /// Distance at which neighbouring patches lie.
  double spacing = 0;

  /// Patches next to it on the surface, ascending; symmetric.
  std::vector<std::size_t> neighbors;
};

/// Half a dozen patches surround a patch on a surface; a few more let diagonals in.
constexpr std::size_t patch_neighbors = 10;

/// A neighbour further away than this many times the spacing of either patch lies across a gap.
/// Between two cells of a sampled surface the spacing itself varies by less than that.
constexpr double adjacency_reach = 2.2;

/// Patches of a mixture may all lie at one place; lengths and weights relative to their spacing stay
/// finite if it is no less than this. Below any spacing of a grid's patches.
constexpr double least_spacing = 1e-6;

/// Two flat patches face each other, rather than continue each other, if the segment between them
/// leaves both within 60 degrees of their normals; the less flat they are the closer.
constexpr double facing_cosine = 0.5;

/// Normal and planarity of a patch, from its own moments and those of its neighbours with a
/// Gaussian weight of the local spacing: few points make the moments of a single patch noisy.
inline void estimate_normal(Patch& patch, const Gaussians& gaussians,
                            const boost::iterator_range<const Neighbor*>& nearest)
{
  Moments moments(patch.mean);
  for(const auto& neighbor : nearest) {
    const double r2 = neighbor.squared_distance / (patch.spacing * patch.spacing);
    moments.add(std::exp(-2 * r2) * gaussians[neighbor.index].weight, gaussians[neighbor.index]);
  }
  Eigen::SelfAdjointEigenSolver<Matrix3> solver;
  solver.computeDirect(moments.gaussian().covariance);
  const Vector3 variance = solver.eigenvalues().cwiseMax(0);
  patch.normal = solver.eigenvectors().col(0).normalized();
  // A line has no normal: flat counts what is a tenth as wide as long.
  constexpr double least_width = 0.1;
  if(variance[1] > 1e-10 * variance[2])
    patch.planarity = (1 - variance[0] / variance[1]) *
                      std::min(1.0, variance[1] / (least_width * variance[2]));
  if(!patch.normal.allFinite())
    patch.normal = Vector3::UnitZ();
}

/// Whether two patches belong to two sheets that face each other.
inline bool face_each_other(const Patch& a, const Patch& b)
{
  const Vector3 d = (b.mean - a.mean).normalized();
  return std::abs(a.normal.dot(d)) * a.planarity > facing_cosine &&
         std::abs(b.normal.dot(d)) * b.planarity > facing_cosine;
}

/// The tree over the means of a mixture.
template <typename ConcurrencyTag>
Box_tree tree_of_means(const Gaussians& gaussians)
{
  return Box_tree(
    gaussians.size(), [&](std::size_t i) { return gaussians[i].mean; }, ConcurrencyTag());
}

/// The places around every component that a patch needs to know: itself and its neighbours. `tree` is
/// over the means.
template <typename ConcurrencyTag>
K_nearest_neighbors patch_neighborhoods(const Box_tree& tree)
{
  return neighborhoods<ConcurrencyTag>(tree, patch_neighbors + 1);
}

/// Turns a mixture level into patches that know their neighbours on the surface, from its
/// `patch_neighborhoods()`.
template <typename ConcurrencyTag>
std::vector<Patch> surface_patches(const Gaussians& gaussians, const K_nearest_neighbors& nearest)
{
  std::vector<Patch> patches(gaussians.size());
  parallel_for<ConcurrencyTag>(patches.size(), [&](std::size_t i) {
    Patch& patch = patches[i];
    patch.mean = gaussians[i].mean;
    patch.weight = gaussians[i].weight;
    const std::size_t middle = nearest[i].size() / 2;
    // A patch without another is as large as the whole.
    patch.spacing = nearest[i].size() > 1 ? std::sqrt(nearest[i].begin()[middle].squared_distance) : 1;
    patch.spacing = std::max(patch.spacing, least_spacing);
    // Half of its neighbours share a disc of this radius with it.
    patch.area = CGAL_PI * patch.spacing * patch.spacing / static_cast<double>(middle + 1);
    estimate_normal(patch, gaussians, nearest[i]);
  });

  parallel_for<ConcurrencyTag>(patches.size(), [&](std::size_t i) {
    patches[i].neighbors.reserve(2 * nearest[i].size()); // hardly ever more are added below
    for(const auto& neighbor : nearest[i]) {
      const std::size_t j = neighbor.index;
      const double reach = adjacency_reach * std::min(patches[i].spacing, patches[j].spacing);
      if(j != i && neighbor.squared_distance <= reach * reach &&
         !face_each_other(patches[i], patches[j]))
        patches[i].neighbors.push_back(j);
    }
  });
  // Who has found a patch is its neighbour, too: those of one patch after the other.
  std::vector<std::size_t> end(patches.size() + 1, 0);
  for(const Patch& patch : patches)
    for(std::size_t j : patch.neighbors)
      ++end[j + 1];
  std::partial_sum(end.begin(), end.end(), end.begin());
  std::vector<std::size_t> back(end.back());
  for(std::size_t i = 0; i < patches.size(); ++i) // afterwards end[j] is what it is called
    for(std::size_t j : patches[i].neighbors)
      back[end[j]++] = i;
  parallel_for<ConcurrencyTag>(patches.size(), [&](std::size_t i) {
    std::vector<std::size_t>& neighbors = patches[i].neighbors;
    const std::size_t begin = i == 0 ? 0 : end[i - 1];
    neighbors.insert(neighbors.end(), back.data() + begin, back.data() + end[i]);
    std::sort(neighbors.begin(), neighbors.end());
    neighbors.erase(std::unique(neighbors.begin(), neighbors.end()), neighbors.end());
  });
  return patches;
}

/// The distance at which patches lie, over all of them. \pre there is a patch
inline double median_spacing(const std::vector<Patch>& patches)
{
  std::vector<double> spacings;
  for(const Patch& patch : patches)
    spacings.push_back(patch.spacing);
  const auto middle = spacings.begin() + static_cast<std::ptrdiff_t>(spacings.size() / 2);
  std::nth_element(spacings.begin(), middle, spacings.end());
  return *middle;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SURFACE_PATCHES_H
