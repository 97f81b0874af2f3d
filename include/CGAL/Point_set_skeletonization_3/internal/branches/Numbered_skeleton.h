// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_BRANCHES_NUMBERED_SKELETON_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_BRANCHES_NUMBERED_SKELETON_H

#include <CGAL/Point_set_skeletonization_3/internal/interface/plain_data.h>

#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/range/iterator_range.hpp>

#include <cstddef>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// A BGL graph as plain data, its vertices numbered in the order of `vertices(skeleton)`.
template <typename Skeleton>
struct Numbered_skeleton
{
  using vertex_descriptor = typename boost::graph_traits<Skeleton>::vertex_descriptor;

  explicit Numbered_skeleton(const Skeleton& skeleton)
  {
    for(vertex_descriptor v : boost::make_iterator_range(vertices(skeleton))) {
      number.emplace(v, vertex.size());
      vertex.push_back(v);
      const auto& p = skeleton[v].point;
      plain.vertices.push_back(
          {{{CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())}},
           CGAL::to_double(skeleton[v].radius)});
    }
    for(const auto e : boost::make_iterator_range(edges(skeleton)))
      plain.edges.emplace_back(number.at(source(e, skeleton)), number.at(target(e, skeleton)));
  }

  /// The vertices with these numbers.
  std::vector<vertex_descriptor> vertices_of(const std::vector<std::size_t>& numbers) const
  {
    std::vector<vertex_descriptor> result;
    for(std::size_t v : numbers)
      result.push_back(vertex[v]);
    return result;
  }

  /// The numbers of these vertices.
  std::vector<std::size_t> numbers_of(const std::vector<vertex_descriptor>& vertices) const
  {
    std::vector<std::size_t> result;
    for(vertex_descriptor v : vertices)
      result.push_back(number.at(v));
    return result;
  }

  Plain_skeleton plain;
  std::vector<vertex_descriptor> vertex;                     ///< By its number.
  std::unordered_map<vertex_descriptor, std::size_t> number; ///< Of a vertex.
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_BRANCHES_NUMBERED_SKELETON_H
