// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_ESSENTIAL_CYCLES_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_ESSENTIAL_CYCLES_H

#include <CGAL/Point_set_skeletonization_3/internal/Skeleton_graph.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// A column of the boundary matrix of triangles over Z/2: the ranks of its edges, ascending.
using Boundary = std::vector<std::size_t>;

/// Adds two columns over Z/2.
inline Boundary symmetric_difference(const Boundary& a, const Boundary& b)
{
  Boundary sum;
  std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(sum));
  return sum;
}

/// Sets of vertices that know which of them are connected.
class Connectivity
{
public:
  explicit Connectivity(std::size_t size) : parent_(size)
  {
    std::iota(parent_.begin(), parent_.end(), std::size_t(0));
  }

  std::size_t root(std::size_t v)
  {
    while(parent_[v] != v)
      v = parent_[v] = parent_[parent_[v]];
    return v;
  }

  /// Joins the sets of `a` and `b`; false if they were one already.
  bool join(std::size_t a, std::size_t b)
  {
    a = root(a);
    b = root(b);
    parent_[std::max(a, b)] = std::min(a, b); // the smallest index is the root: no dependence on order
    return a != b;
  }

private:
  std::vector<std::size_t> parent_;
};

/// The edges that a curve needs to be connected like a complex and to have its cycles.
struct Homotopy_edges
{
  std::vector<Skeleton_graph::Edge> spanning; ///< A minimum spanning forest.
  std::vector<Skeleton_graph::Edge> closing;  ///< One per cycle that no triangles fill.
};

/// A minimum spanning forest of a complex, and for every cycle that its triangles do not fill the
/// edge that closes it.
///
/// `edges` are the edges of the complex, shortest first and without duplicates; its triangles are
/// all triples of edges for whose corners `is_filled(u, v, w)` holds. The rank of the first homology
/// is computed by reducing the boundary matrix (Edelsbrunner, Letscher, Zomorodian 2002) in the order
/// of the edges, so that a cycle is closed by the last of its edges to appear.
template <typename Is_filled>
Homotopy_edges homotopy_edges(std::size_t number_of_vertices,
                              const std::vector<Skeleton_graph::Edge>& edges,
                              const Is_filled& is_filled)
{
  Connectivity connectivity(number_of_vertices);
  std::vector<bool> spanning(edges.size(), false), filled(edges.size(), false);

  using Link = std::pair<std::size_t, std::size_t>; // neighbour, rank of the edge to it
  std::vector<std::vector<Link>> star(number_of_vertices);
  std::vector<Boundary> reduced(edges.size()); // by their last edge; empty: none
  for(std::size_t rank = 0; rank < edges.size(); ++rank) {
    const std::size_t u = edges[rank].first, v = edges[rank].second;
    spanning[rank] = connectivity.join(u, v);

    // The triangles that appear with this edge: both its ends know the third corner.
    for(const Link& a : star[u]) {
      const auto b = std::find_if(star[v].begin(), star[v].end(),
                                  [&](const Link& l) { return l.first == a.first; });
      if(b == star[v].end())
        continue;
      Boundary boundary{a.second, b->second, rank};
      std::sort(boundary.begin(), boundary.end());
      while(!boundary.empty() && !reduced[boundary.back()].empty())
        boundary = symmetric_difference(boundary, reduced[boundary.back()]);
      if(!boundary.empty() && is_filled(u, v, a.first)) { // asked last: it is the costly question
        filled[boundary.back()] = true;
        reduced[boundary.back()] = std::move(boundary);
      }
    }
    star[u].emplace_back(v, rank);
    star[v].emplace_back(u, rank);
  }

  Homotopy_edges result;
  for(std::size_t rank = 0; rank < edges.size(); ++rank)
    if(spanning[rank])
      result.spanning.push_back(edges[rank]);
    else if(!filled[rank])
      result.closing.push_back(edges[rank]);
  return result;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_ESSENTIAL_CYCLES_H
