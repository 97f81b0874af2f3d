// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_OPEN_LOOPS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_OPEN_LOOPS_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Union_find.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Curve_evidence.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Curve_options.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Skeleton_graph.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// The vertices of a loop, in their order around it, each once.
using Loop = std::vector<std::size_t>;

/// Calls `visit(v, w)` for each edge of a loop. O(length of the loop).
template <typename Visit>
void visit_edges(const Loop& loop, const Visit& visit)
{
  for(std::size_t k = 0; k < loop.size(); ++k)
    visit(loop[k], loop[k + 1 < loop.size() ? k + 1 : 0]);
}

/// How well a loop was seen. O(length of the loop).
inline Curve_evidence evidence_along(const Loop& loop, const Skeleton_graph& graph)
{
  Curve_evidence result;
  visit_edges(loop, [&](std::size_t v, std::size_t w) {
    result.add(graph.vertices[v], graph.vertices[w]);
  });
  return result;
}

/// Returns places that divide a closed polygon into `number` pieces of equal length. O(size +
/// number). \pre the polygon is not empty
inline std::vector<Vector3> evenly_along(const std::vector<Vector3>& polygon, std::size_t number)
{
  std::vector<double> way(1, 0); // to each corner, and back to the first
  for(std::size_t k = 0; k < polygon.size(); ++k)
    way.push_back(way.back() + (polygon[(k + 1) % polygon.size()] - polygon[k]).norm());
  std::vector<Vector3> result;
  std::size_t edge = 0;
  for(std::size_t i = 0; i < number; ++i) {
    const double there = way.back() * static_cast<double>(i) / static_cast<double>(number);
    while(edge + 1 < polygon.size() && way[edge + 1] <= there)
      ++edge;
    const double length = way[edge + 1] - way[edge];
    const double t = length > 0 ? (there - way[edge]) / length : 0;
    result.push_back((1 - t) * polygon[edge] + t * polygon[(edge + 1) % polygon.size()]);
  }
  return result;
}

/// Returns the area that a closed polygon encloses: the least of a strip between two halves of it,
/// for all places to halve it. That of a polygon which only runs to and fro is small, however it
/// bends. O(n^2).
inline double enclosed_area(const std::vector<Vector3>& polygon)
{
  const std::size_t size = polygon.size();
  double least = std::numeric_limits<double>::infinity();
  for(std::size_t end = 0; end < size; ++end) {
    const auto ahead = [&](std::size_t k) { return polygon[(end + k) % size]; };
    double area = 0;
    for(std::size_t k = 0; 2 * k < size; ++k) { // between two rungs
      const Vector3 a = ahead(k), b = ahead(k + 1), c = ahead(size - k - 1), d = ahead(size - k);
      area += ((b - a).cross(d - a).norm() + (b - c).cross(d - c).norm()) / 2;
    }
    least = (std::min)(least, area);
  }
  return least;
}

/// How many times wider a loop is than its limbs are thick, and than three spacings: below 1 there is
/// no room for a hole. A limb that looks like two side by side, and two that touch twice, make loops
/// without one, and narrower holes are gaps between points.
///
/// The radius of a circle is twice its area over its length. The same ratio is that of any loop; it
/// is small where a loop only runs to and fro. It is compared with the mean radius at the
/// separators: a sheet around a hole may be much wider than the hole. Infinite if there are none.
/// O(length of the loop).
inline double room_for_hole(const Loop& loop, const Skeleton_graph& graph)
{
  constexpr double no_hole = 1.5; // spacings: gaps in strips have up to 1.2, wire frames 40
  constexpr std::size_t places = 32; // a circle in such steps is exact to 1 %

  std::vector<Vector3> polygon;
  double radii = 0, separators = 0, length = 0;
  for(std::size_t v : loop) {
    const Skeleton_graph::Vertex& vertex = graph.vertices[v];
    polygon.push_back(vertex.position);
    if(vertex.is_cross_section) {
      radii += (std::max)(vertex.radius, no_hole * vertex.resolution);
      ++separators;
    }
  }
  visit_edges(loop, [&](std::size_t v, std::size_t w) {
    length += (graph.vertices[v].position - graph.vertices[w].position).norm();
  });
  const double limbs = radii * length;
  return limbs > 0 ? 2 * enclosed_area(evenly_along(polygon, places)) * separators / limbs
                   : std::numeric_limits<double>::infinity();
}

/// Whether a loop leads from a limb that was seen from all sides, or to one, through a row of points
/// that runs alongside neither limb. Those are what a scanner sees between two limbs, when its beam
/// meets both: a limb does not become as thin as a point and then thick again, and what is hidden of
/// one leaves a strip or a gap. Between open limbs the row may be the rest of one of which little
/// was seen, and along a limb it may be all of it that is not hidden. O(length of the loop).
/// \param components their number at each vertex
/// \param options `aligned`; cross-sections of fewer than `least_points` components are in a row
inline bool leads_through_row(const Loop& loop, const Skeleton_graph& graph,
                              const std::vector<double>& components, const Curve_options& options)
{
  Loop sections; // on a line of points every point is one
  for(std::size_t v : loop)
    if(graph.vertices[v].is_cross_section && !graph.vertices[v].is_on_line)
      sections.push_back(v);
  const std::size_t size = sections.size();
  const auto section = [&](std::size_t k) { return sections[k % size]; };
  const auto is_thin = [&](std::size_t k) {
    return components[section(k)] < options.least_points;
  };
  const auto way = [&](std::size_t k, std::size_t l) -> Vector3 {
    return graph.vertices[section(l)].position - graph.vertices[section(k)].position;
  };
  for(std::size_t first = 0; first < size; ++first) {
    if(is_thin(first) || !is_thin(first + 1))
      continue;
    double fewest = components[section(first + 1)];
    std::size_t last = first + 2; // the next limb, at most the same again
    for(; is_thin(last); ++last)
      fewest = (std::min)(fewest, components[section(last)]);
    const Vector3 row = way(first, last);
    const auto is_alongside = [&](const Vector3& limb) {
      return std::abs(limb.dot(row)) >= options.aligned * limb.norm() * row.norm();
    };
    const bool is_open_at_both =
      is_open(graph.vertices[section(first)]) && is_open(graph.vertices[section(last)]);
    if(fewest <= 1 && !is_open_at_both && !is_alongside(way(first + size - 1, first)) &&
       !is_alongside(way(last, last + 1)))
      return true;
  }
  return false;
}

/// Returns the edges of a loop with their smaller ends first, in ascending order. O(n log n).
inline std::vector<Skeleton_graph::Edge> sorted_edges(const Loop& loop)
{
  std::vector<Skeleton_graph::Edge> result;
  visit_edges(loop, [&](std::size_t v, std::size_t w) { result.push_back(std::minmax(v, w)); });
  std::sort(result.begin(), result.end());
  return result;
}

/// Returns the loop of some edges; empty if they make none, or several. O(n log n).
inline Loop loop_of(const std::vector<Skeleton_graph::Edge>& edges)
{
  std::map<std::size_t, std::vector<std::size_t>> adjacency;
  for(const auto& [v, w] : edges) {
    adjacency[v].push_back(w);
    adjacency[w].push_back(v);
  }
  Loop result;
  if(edges.empty() || std::any_of(adjacency.begin(), adjacency.end(), [](const auto& neighbors) {
       return neighbors.second.size() != 2;
     }))
    return result;
  const std::size_t first = edges.front().first;
  std::size_t v = first, before = edges.front().second;
  do {
    result.push_back(v);
    const std::vector<std::size_t>& next = adjacency[v];
    v = next[next[0] == std::exchange(before, v) ? 1 : 0];
  } while(v != first);
  return result.size() == edges.size() ? result : Loop();
}

/// Loops, and what lies between them and others.
class Known_loops
{
public:
  /// O(n log n).
  void add(const Loop& loop)
  {
    for(const Skeleton_graph::Edge& edge : edges_of_.emplace_back(sorted_edges(loop)))
      loops_with_[edge].push_back(edges_of_.size() - 1);
  }

  /// Returns the loops of the edges that are either in `loop` or in a known one, for all known ones
  /// that have an edge in common with it. O(n log n) for each.
  std::vector<Loop> beside(const Loop& loop) const
  {
    const std::vector<Skeleton_graph::Edge> edges = sorted_edges(loop);
    std::set<std::size_t> near;
    for(const Skeleton_graph::Edge& edge : edges)
      if(const auto found = loops_with_.find(edge); found != loops_with_.end())
        near.insert(found->second.begin(), found->second.end());
    std::vector<Loop> result;
    for(std::size_t k : near) {
      std::vector<Skeleton_graph::Edge> in_one;
      std::set_symmetric_difference(edges.begin(), edges.end(), edges_of_[k].begin(),
                                    edges_of_[k].end(), std::back_inserter(in_one));
      Loop between = loop_of(in_one);
      if(!between.empty())
        result.push_back(std::move(between));
    }
    return result;
  }

private:
  std::vector<std::vector<Skeleton_graph::Edge>> edges_of_;
  std::map<Skeleton_graph::Edge, std::vector<std::size_t>> loops_with_;
};

/// The edges of a skeleton graph that are added one by one, and the loops that they close.
class Loop_search
{
public:
  explicit Loop_search(std::size_t vertices) : adjacency_(vertices), before_(vertices, none) {}

  /// O(1).
  void add_vertex()
  {
    adjacency_.emplace_back();
    before_.push_back(none);
  }

  /// O(1).
  void add(const Skeleton_graph::Edge& edge)
  {
    adjacency_[edge.first].push_back(edge.second);
    adjacency_[edge.second].push_back(edge.first);
  }

  /// The loop of fewest edges that `edge` closes with those that were added; empty if there is
  /// none. Breadth-first search: O(vertices that are no further along the edges).
  Loop closed_by(const Skeleton_graph::Edge& edge)
  {
    const auto [from, to] = edge;
    std::vector<std::size_t> reached = {from};
    before_[from] = from;
    for(std::size_t next = 0; next < reached.size() && before_[to] == none; ++next)
      for(std::size_t w : adjacency_[reached[next]])
        if(before_[w] == none) {
          before_[w] = reached[next];
          reached.push_back(w);
        }
    Loop result;
    if(before_[to] != none) {
      for(std::size_t v = to; v != from; v = before_[v])
        result.push_back(v);
      result.push_back(from);
    }
    for(std::size_t v : reached)
      before_[v] = none;
    return result;
  }

private:
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  std::vector<std::vector<std::size_t>> adjacency_;
  std::vector<std::size_t> before_; ///< On the way from where a search began, during it.
};

/// Part 3c: returns the graph with loops opened where they are weakest, unless `is_kept(loop)`. Edges
/// are added in the order of their strength, that of the weaker end. Of one that closes loops the
/// shortest is asked: around a narrow hole, not the long way beside it. So are those between that
/// one and others that were kept: two ways through one limb, on both sides of a gap in the data,
/// lead around the same hole. O(n log n + loops times the vertices as near as their length).
/// \param strength of each vertex
template <typename IsKept>
Skeleton_graph with_loops_opened(Skeleton_graph graph, const std::vector<double>& strength,
                                 const IsKept& is_kept)
{
  const auto weaker_end = [&](const Skeleton_graph::Edge& e) {
    return (std::min)(strength[e.first], strength[e.second]);
  };
  std::vector<Skeleton_graph::Edge> edges = graph.edges, opened;
  std::stable_sort(edges.begin(), edges.end(),
                   [&](const auto& a, const auto& b) { return weaker_end(a) > weaker_end(b); });
  Union_find sets(graph.vertices.size());
  Loop_search loops(graph.vertices.size());
  Known_loops known;
  const auto may_be_closed_by = [&](const Skeleton_graph::Edge& edge) {
    const Loop loop = loops.closed_by(edge);
    if(!is_kept(loop))
      return false;
    const std::vector<Loop> beside = known.beside(loop);
    if(!std::all_of(beside.begin(), beside.end(), is_kept))
      return false;
    known.add(loop);
    return true;
  };
  for(const Skeleton_graph::Edge& edge : edges)
    if(sets.join(edge.first, edge.second) || may_be_closed_by(edge))
      loops.add(edge);
    else
      opened.push_back(edge);
  std::sort(opened.begin(), opened.end());
  const auto is_opened = [&](const Skeleton_graph::Edge& edge) {
    return std::binary_search(opened.begin(), opened.end(), edge);
  };
  graph.edges.erase(std::remove_if(graph.edges.begin(), graph.edges.end(), is_opened),
                    graph.edges.end());
  return graph;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_OPEN_LOOPS_H
