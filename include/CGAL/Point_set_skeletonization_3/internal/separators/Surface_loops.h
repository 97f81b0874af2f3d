// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SEPARATORS_SURFACE_LOOPS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SEPARATORS_SURFACE_LOOPS_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Progress.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Union_find.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch_graph.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Shortest_paths.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Finds the closed paths on a surface that cannot be shrunk to a point on it: around limbs,
/// through tunnels, and around holes of the data.
///
/// Each edge off the tree of shortest paths from a root closes one (Erickson & Whittlesey 2005). If
/// the path of one edge of a triangle can be shrunk, those of the other two can be moved onto each
/// other.
class Surface_loops
{
public:
  using Path = std::vector<std::size_t>; ///< Adjacent patches; the last is adjacent to the first.

  /// Refers to the graph. O(n).
  Surface_loops(const Patch_graph& graph, std::size_t patches)
    : graph_(graph), paths_(graph, patches), first_(patches + 1)
  {}

  /// Returns the shortest path of each class of closed paths through a root that can be moved onto
  /// each other, but of none that can be shrunk to it, the shortest first. What leads from the root
  /// to the loop and back is left out. O(m log m) in practice, m the edges and triangles of the
  /// patches with `is_inside(i)` that are connected with the root.
  template <typename IsInside>
  std::vector<Path> through(std::size_t root, const IsInside& is_inside)
  {
    collect_edges(paths_.spread({{0., root}}, is_inside), is_inside);
    Union_find classes = classes_of_edges();
    std::map<std::size_t, std::pair<double, std::size_t>> shortest; // length, edge of each class
    for(std::size_t e = 0; e < edges_.size(); ++e) {
      const std::pair<double, std::size_t> candidate{edges_[e].length, e};
      const auto found = shortest.emplace(classes.find(e + 1), candidate).first;
      found->second = (std::min)(found->second, candidate);
    }
    shortest.erase(shrunk);
    std::vector<std::pair<double, std::size_t>> sorted;
    for(const auto& [index, edge] : shortest)
      sorted.push_back(edge);
    std::sort(sorted.begin(), sorted.end());
    std::vector<Path> result;
    for(const auto& [length, e] : sorted)
      result.push_back(closed_by(edges_[e]));
    return result;
  }

private:
  static constexpr std::size_t none = Shortest_paths::none;
  static constexpr std::size_t shrunk = 0; ///< Class of edges that close paths that can be shrunk.

  /// Two adjacent patches, `a < b`.
  struct Edge
  {
    std::size_t a, b;
    double length; ///< Of the closed path through the root.
  };

  /// Lists the edges between the patches reached, in lexicographic order.
  template <typename IsInside>
  void collect_edges(std::vector<std::size_t> reached, const IsInside& is_inside)
  {
    std::sort(reached.begin(), reached.end());
    edges_.clear();
    for(std::size_t i : reached) {
      first_[i] = edges_.size();
      for(const auto& edge : graph_[i])
        if(edge.patch > i && is_inside(edge.patch))
          edges_.push_back({i, edge.patch,
                            paths_.distance(i) + static_cast<double>(edge.length) +
                              paths_.distance(edge.patch)});
    }
  }

  /// The classes of the edges; that of the `e`-th edge is that of `e + 1`.
  Union_find classes_of_edges() const
  {
    Union_find result(edges_.size() + 1);
    for(std::size_t e = 0; e < edges_.size(); ++e)
      if(paths_.before(edges_[e].a) == edges_[e].b || paths_.before(edges_[e].b) == edges_[e].a)
        result.join(shrunk, e + 1);
    std::vector<std::array<std::size_t, 3>> open = triangles();
    for(bool is_changed = true; is_changed;) { // a few times
      Progress::poll();
      is_changed = false;
      for(const std::array<std::size_t, 3>& triangle : open)
        for(std::size_t k = 0; k < 3; ++k)
          if(result.find(triangle[k] + 1) == shrunk)
            is_changed |= result.join(triangle[(k + 1) % 3] + 1, triangle[(k + 2) % 3] + 1);
      open.erase(std::remove_if(open.begin(), open.end(),
                                [&](const std::array<std::size_t, 3>& triangle) {
                                  return result.find(triangle[0] + 1) == shrunk &&
                                         result.find(triangle[1] + 1) == shrunk;
                                }),
                 open.end());
    }
    return result;
  }

  /// The triples of edges between three patches.
  std::vector<std::array<std::size_t, 3>> triangles() const
  {
    std::vector<std::array<std::size_t, 3>> result;
    for(std::size_t e = 0; e < edges_.size(); ++e) {
      const std::size_t a = edges_[e].a, b = edges_[e].b;
      std::size_t f = e + 1, g = first_[b]; // to a third patch, from either
      while(f < edges_.size() && g < edges_.size() && edges_[f].a == a && edges_[g].a == b)
        if(edges_[f].b < edges_[g].b)
          ++f;
        else if(edges_[g].b < edges_[f].b)
          ++g;
        else
          result.push_back({e, f++, g++});
    }
    return result;
  }

  /// The closed path of an edge, without what its two ways to the root share.
  Path closed_by(const Edge& edge) const
  {
    Path there = path_to_root(edge.a), back = path_to_root(edge.b);
    while(there.size() > 1 && back.size() > 1 && there[there.size() - 2] == back[back.size() - 2]) {
      there.pop_back();
      back.pop_back();
    }
    back.pop_back(); // where they meet
    there.insert(there.end(), back.rbegin(), back.rend());
    return there;
  }

  Path path_to_root(std::size_t i) const
  {
    Path result;
    for(; i != none; i = paths_.before(i))
      result.push_back(i);
    return result;
  }

  const Patch_graph& graph_;
  Shortest_paths paths_;
  std::vector<Edge> edges_;
  std::vector<std::size_t> first_; ///< Index of the first edge of each patch reached.
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SEPARATORS_SURFACE_LOOPS_H
