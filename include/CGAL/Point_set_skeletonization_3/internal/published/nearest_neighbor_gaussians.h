// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PUBLISHED_NEAREST_NEIGHBOR_GAUSSIANS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PUBLISHED_NEAREST_NEIGHBOR_GAUSSIANS_H


#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/published/Point_search.h>
#include <CGAL/Point_set_skeletonization_3/internal/published/Published_options.h>
#include <CGAL/Point_set_skeletonization_3/internal/published/gaussian_functions.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/Neighbor.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Returns the covariance about `center` of its neighbours. `found` includes `center` itself, which
/// is not counted.
inline Matrix3 neighbor_covariance(const Vector3& center, const std::vector<Vector3>& points,
                                   const std::vector<Neighbor>& found)
{
  Matrix3 sum = Matrix3::Zero();
  for(const Neighbor& neighbor : found) {
    const Vector3 d = points[neighbor.index] - center;
    sum += d * d.transpose();
  }
  const std::size_t others = found.size() - 1;
  return others == 0 ? sum : Matrix3(sum / static_cast<double>(others));
}

/// The distinct positions of points in lexicographic order, and the index of that of each point.
/// O(n log n).
struct Distinct_positions
{
  explicit Distinct_positions(const std::vector<Vector3>& points) : index_of(points.size())
  {
    for(std::size_t i : lexicographic_order(points)) {
      if(positions.empty() || positions.back() != points[i])
        positions.push_back(points[i]);
      index_of[i] = positions.size() - 1;
    }
  }

  std::vector<Vector3> positions;
  std::vector<std::size_t> index_of;
};

/// Returns one Gaussian of weight 1 per point, in their order: mean at the point, covariance of its
/// `options.neighbors` nearest distinct positions about it, made positive definite relative to its
/// own scale (or to the bounding box if there is only one position). O(n log n).
///
/// Duplicates count as one neighbour: they give the weight of a place, not the distance to the
/// next. The search runs over sorted positions, so that the choice among equally distant neighbours
/// does not depend on the order of the points: permuted points give the same Gaussians permuted,
/// bit by bit.
///
/// \param points in normalised coordinates, finite
inline Gaussians nearest_neighbor_gaussians(const std::vector<Vector3>& points,
                                            const Nearest_neighbor_options& options,
                                            Concurrency concurrency)
{
  options.check();
  const Distinct_positions distinct(points);
  const std::vector<Vector3>& positions = distinct.positions;
  const Point_search search(positions);

  std::vector<Matrix3> covariances(positions.size());
  parallel_for(concurrency, positions.size(), [&](std::size_t i) {
    std::vector<Neighbor> found;
    search.nearest(positions[i], options.neighbors + 1, found);
    covariances[i] =
      regularized(neighbor_covariance(positions[i], positions, found), options.flatness);
  });

  Gaussians result;
  result.reserve(points.size());
  for(std::size_t i = 0; i < points.size(); ++i)
    result.push_back({1, points[i], covariances[distinct.index_of[i]]});
  return result;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PUBLISHED_NEAREST_NEIGHBOR_GAUSSIANS_H
