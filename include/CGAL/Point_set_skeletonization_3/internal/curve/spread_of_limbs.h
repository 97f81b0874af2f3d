// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_SPREAD_OF_LIMBS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_SPREAD_OF_LIMBS_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/quantile.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/squared_distance_to_segment.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Skeleton_graph.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Returns the distance of each point from the edges at its vertex. O(n).
/// \param surface `surface[v]` are the surface points of vertex v
inline std::vector<std::vector<double>>
distances_from_curve(const Skeleton_graph& graph, const std::vector<std::vector<Vector3>>& surface)
{
  const auto adjacency = graph.adjacency();
  std::vector<std::vector<double>> result(surface.size());
  for(std::size_t v = 0; v < surface.size(); ++v) {
    const Vector3& position = graph.vertices[v].position;
    for(const Vector3& p : surface[v]) {
      double least = (p - position).squaredNorm();
      for(std::size_t w : adjacency[v])
        least = (std::min)(least, squared_distance_to_segment(p, position,
                                                              graph.vertices[w].position));
      result[v].push_back(std::sqrt(least));
    }
  }
  return result;
}

/// Sorts distances, and drops those behind the first gap: of what is apart from the limb.
/// O(n log n).
inline void drop_behind_gap(std::vector<double>& distances, double gap)
{
  std::sort(distances.begin(), distances.end());
  const auto before = std::adjacent_find(distances.begin(), distances.end(),
                                         [gap](double a, double b) { return b - a > gap; });
  if(before != distances.end())
    distances.erase(before + 1, distances.end());
}

/// Sets the radius of each vertex of an open limb to the spread of its points around the curve: as
/// many are nearer as within the standard deviation of a normal distribution around a line. That is
/// the radius of a tube, that of a twig in noise, and about two thirds of half the width of a leaf.
/// What is apart from the limb, as a twig that has no curve of its own, does not count. The other
/// side of the limb was not seen, so the distance to the nearest patch tells nothing. A vertex
/// shares the points of those next to it and, if these are few, of more around, or radii would vary
/// from one to the next by half. O(n log n) in practice.
/// \param surface `surface[v]` are the surface points of vertex v
/// \param enough so many points tell a spread
/// \param gap resolutions; points of a limb are not further apart
inline void set_spreads(Skeleton_graph& graph, const std::vector<std::vector<Vector3>>& surface,
                        std::size_t enough, double gap)
{
  const double within = 1 - std::exp(-1.0); // of a normal distribution in two dimensions
  constexpr std::size_t nobody = (std::numeric_limits<std::size_t>::max)();
  const std::vector<std::vector<double>> distances = distances_from_curve(graph, surface);
  const auto adjacency = graph.adjacency();
  std::vector<std::size_t> seen_by(graph.vertices.size(), nobody);
  for(std::size_t v = 0; v < graph.vertices.size(); ++v) {
    if(!is_open(graph.vertices[v]))
      continue;
    std::vector<double> shared;
    std::vector<std::size_t> front{v}; // all that are equally many edges away
    seen_by[v] = v;
    while(!front.empty()) {
      for(std::size_t w : front)
        shared.insert(shared.end(), distances[w].begin(), distances[w].end());
      drop_behind_gap(shared, gap * graph.vertices[v].resolution);
      if(front.front() != v && shared.size() >= enough) // those next to it tell what is apart
        break;
      std::vector<std::size_t> next;
      for(std::size_t w : front)
        for(std::size_t x : adjacency[w])
          if(is_open(graph.vertices[x]) && std::exchange(seen_by[x], v) != v)
            next.push_back(x);
      front = std::move(next);
    }
    if(!shared.empty())
      graph.vertices[v].radius = quantile(std::move(shared), within);
  }
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_SPREAD_OF_LIMBS_H
