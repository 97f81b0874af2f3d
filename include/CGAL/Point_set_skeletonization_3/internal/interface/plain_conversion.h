// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_INTERFACE_PLAIN_CONVERSION_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_INTERFACE_PLAIN_CONVERSION_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Normalization.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Skeleton_graph.h>
#include <CGAL/Point_set_skeletonization_3/internal/interface/plain_data.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

// Conversions between normalised internal data and plain data in the coordinates of the input.

inline Vector3 to_vector(const Plain_point& p) { return {p[0], p[1], p[2]}; }

inline Plain_point to_plain(const Vector3& p) { return {{p.x(), p.y(), p.z()}}; }

inline Plain_point to_plain(const Vector3& p, const Normalization& normalization)
{
  return to_plain(normalization.from_unit(p));
}

inline Plain_gaussian to_plain(const Gaussian& g, const Normalization& normalization)
{
  const Matrix3 c = normalization.covariance_from_unit(g.covariance);
  return {g.weight,
          to_plain(g.mean, normalization),
          {{c(0, 0), c(0, 1), c(0, 2), c(1, 1), c(1, 2), c(2, 2)}}};
}

inline Gaussian from_plain(const Plain_gaussian& g, const Normalization& normalization)
{
  const std::array<double, 6>& c = g.covariance;
  Matrix3 covariance;
  covariance << c[0], c[1], c[2], c[1], c[3], c[4], c[2], c[4], c[5];
  return {g.weight, normalization.to_unit(to_vector(g.mean)),
          normalization.covariance_to_unit(covariance)};
}

inline Plain_box plain_box(const Normalization& normalization)
{
  return {to_plain(normalization.lower()), to_plain(normalization.upper()), true};
}

/// Returns the normalisation by `box` or, if it is unknown, by the bounding box of the means of
/// patches.
/// \throws std::invalid_argument that names the first mean that is not finite
template <typename PatchOf, typename Range>
Normalization normalization_of(const Plain_box& box, const Range& range, const PatchOf& patch_of)
{
  Extent extent;
  std::size_t i = 0;
  for(const auto& item : range)
    extent.add(i++, to_vector(patch_of(item).mean));
  const Normalization by_means = extent.normalization(); // throws
  return box.is_known ? Normalization(to_vector(box.lower), to_vector(box.upper)) : by_means;
}

inline Plain_mixture to_plain(const std::vector<Gaussians>& levels, double cell_size,
                              const Normalization& normalization)
{
  Plain_mixture result;
  for(const Gaussians& level : levels) {
    result.levels.emplace_back();
    for(const Gaussian& g : level)
      result.levels.back().push_back(to_plain(g, normalization));
  }
  result.cell_size = cell_size * normalization.diagonal();
  result.box = plain_box(normalization);
  return result;
}

inline Plain_skeleton to_plain(const Skeleton_graph& graph, const Normalization& normalization)
{
  Plain_skeleton result;
  for(const Skeleton_graph::Vertex& vertex : graph.vertices) {
    const Vector3 p = normalization.from_unit_in_box(vertex.position);
    result.vertices.push_back(
      {{{p.x(), p.y(), p.z()}}, normalization.length_from_unit(vertex.radius)});
  }
  result.edges = graph.edges;
  return result;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_INTERFACE_PLAIN_CONVERSION_H
