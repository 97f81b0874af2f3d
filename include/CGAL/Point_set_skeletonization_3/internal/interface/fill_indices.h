// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_INTERFACE_FILL_INDICES_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_INTERFACE_FILL_INDICES_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Progress.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/interface/plain_data.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Fills the list of points of each vertex, ascending. With ten million points the lists use most
/// of the memory, so they get no more of it than they need. O(points). Can be cancelled by
/// `Progress::poll()`.
///
/// \param vertex_of_point `vertex_of_point(p)` is the vertex of a point; at least `vertices` for an
///        outlier
/// \param forget_points_below `forget_points_below(end)` may free memory of the points below `end`
template <typename VertexOfPoint, typename ForgetPointsBelow>
void fill_indices(std::size_t points, std::size_t vertices, const VertexOfPoint& vertex_of_point,
                  const ForgetPointsBelow& forget_points_below, const Index_lists& lists,
                  Concurrency concurrency)
{
  // Points are split into rounds, and rounds into parts that are processed concurrently.
  constexpr std::size_t rounds = 8, parts = 8;
  const auto first = [&](std::size_t part) { return part * points / (rounds * parts); };
  const auto for_each_point = [&](std::size_t part, const auto& visit) {
    for(std::size_t p = first(part); p < first(part + 1); ++p) {
      constexpr std::size_t between_polls = std::size_t(1) << 18;
      if(p % between_polls == 0)
        Progress::poll();
      if(const std::size_t v = vertex_of_point(p); v < vertices)
        visit(p, v);
    }
  };
  // Position of the next point of a part in the list of a vertex; first its number of points.
  std::vector<std::vector<std::size_t>> place(rounds * parts + 1,
                                              std::vector<std::size_t>(vertices, 0));
  parallel_for(concurrency, rounds * parts, [&](std::size_t part) {
    for_each_point(part, [&](std::size_t, std::size_t v) { ++place[part][v]; });
  });
  for(std::size_t v = 0; v < vertices; ++v) {
    std::size_t size = 0;
    for(std::vector<std::size_t>& part : place)
      size += std::exchange(part[v], size);
    lists.reserve(v, size);
  }
  std::vector<void*> list(vertices);
  const auto fill = [&](std::size_t part, auto index) {
    using Index = decltype(index);
    for_each_point(part, [&](std::size_t p, std::size_t v) {
      static_cast<Index*>(list[v])[place[part][v]++] = static_cast<Index>(p);
    });
  };
  for(std::size_t begin = 0, end = parts; end < place.size(); begin = end, end += parts) {
    parallel_for(concurrency, vertices,
                 [&](std::size_t v) { list[v] = lists.resize(v, place[end][v]); });
    parallel_for(concurrency, parts, [&](std::size_t k) {
      switch(lists.bytes_of_index) {
      case 1:
        return fill(begin + k, std::uint8_t());
      case 2:
        return fill(begin + k, std::uint16_t());
      case 4:
        return fill(begin + k, std::uint32_t());
      default:
        return fill(begin + k, std::uint64_t());
      }
    });
    forget_points_below(first(end));
  }
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_INTERFACE_FILL_INDICES_H
