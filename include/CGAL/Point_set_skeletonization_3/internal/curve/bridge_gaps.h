// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_BRIDGE_GAPS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_BRIDGE_GAPS_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Union_find.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/minimum_spanning_forest.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Bridge.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Curve_options.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Skeleton_graph.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/refine_curve.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/Box_tree.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Finds bridges between the components of a skeleton across gaps in the data.
///
/// A bridge leads from a tip to another tip or to a vertex of another component. It is plausible if
/// it is not much longer than the limb is thick and the tip points along it; between two tips, both
/// must. Of each of the two components more was seen than is missing.
class Bridging
{
public:
  /// `surface[v]` are the surface points of vertex v. Refers to all arguments.
  Bridging(const Skeleton_graph& graph, const std::vector<std::vector<Vector3>>& surface,
           const Curve_options& options)
      : options_(options)
      , graph_(graph)
      , adjacency_(graph.adjacency())
      , surface_(surface)
      , extent_(graph.vertices.size(), 0)
      , points_(graph.vertices.size(), 0)
  {
    Union_find components = components_of(graph);
    for(std::size_t v = 0; v < surface_.size(); ++v) {
      component_.push_back(components.find(v));
      points_[component_[v]] += static_cast<double>(surface_[v].size());
      for(const Vector3& p : surface_[v])
        extent_[v] = (std::max)(extent_[v], (p - graph.vertices[v].position).norm());
    }
  }

  /// Returns the plausible bridges. O(n log n), times the vertices within reach of a tip: the
  /// widest gap from the thickest limb.
  std::vector<Bridge> bridges() const
  {
    const std::vector<Vector3> positions = positions_of(graph_);
    double thickest = 0, extent = 0;
    for(std::size_t v = 0; v < graph_.vertices.size(); ++v) {
      thickest = (std::max)(thickest, graph_.vertices[v].radius);
      extent = (std::max)(extent, extent_[v]);
    }
    const Box_tree places(positions);
    std::vector<Bridge> result;
    for(std::size_t v = 0; v < graph_.vertices.size(); ++v) {
      if(adjacency_[v].size() != 1)
        continue;
      const double gap = (std::max)(widest_gap(v, thickest), thin_gap(v));
      places.visit_within(positions[v], gap + extent_[v] + extent, [&](std::size_t k, double) {
        const std::size_t w = places.order()[k];
        if(component_[v] != component_[w] && is_plausible(v, w))
          result.push_back(bridge(v, w, graph_));
      });
    }
    return result;
  }

private:
  /// Whether a tip points at vertex `w`.
  bool points_at(std::size_t end, std::size_t w) const
  {
    const Vector3 gap = graph_.vertices[w].position - graph_.vertices[end].position;
    return tip_direction(end, graph_, adjacency_).dot(gap) > options_.aligned * gap.norm();
  }

  /// Whether the distance between the surface points of two vertices is less than `most`; without
  /// points, that of the vertices.
  bool is_gap_below(double most, std::size_t v, std::size_t w) const
  {
    if(surface_[v].empty() || surface_[w].empty())
      return bridge(v, w, graph_).length < most;
    if(bridge(v, w, graph_).length - extent_[v] - extent_[w] >= most)
      return false;
    for(const Vector3& p : surface_[v])
      for(const Vector3& q : surface_[w])
        if((p - q).squaredNorm() < most * most)
          return true;
    return false;
  }

  /// Greatest gap between a tip of a thin limb and anything.
  double thin_gap(std::size_t end) const
  {
    return options_.thin_gap * graph_.vertices[end].resolution;
  }

  /// Greatest gap between a tip and a limb of some radius that are aligned.
  double widest_gap(std::size_t end, double radius) const
  {
    const Skeleton_graph::Vertex& tip = graph_.vertices[end];
    return options_.widest_gap *
           (std::max)({tip.radius, radius, options_.thin_limb * tip.resolution});
  }

  /// How much was seen of the component of `v`, if it goes on at `w`.
  double seen(std::size_t v, std::size_t w) const
  {
    return length_seen(points_[component_[v]], w, graph_);
  }

  /// Whether a bridge from a tip to vertex `w` is plausible.
  bool is_plausible(std::size_t end, std::size_t w) const
  {
    const Skeleton_graph::Vertex& tip = graph_.vertices[end];
    const double most = (std::min)(seen(end, w), seen(w, end));
    if(tip.radius < options_.thin_limb * tip.resolution &&
       is_gap_below((std::min)(most, thin_gap(end)), end, w))
      return true;
    return points_at(end, w) && (adjacency_[w].size() != 1 || points_at(w, end)) &&
           is_gap_below((std::min)(most, widest_gap(end, graph_.vertices[w].radius)), end, w);
  }

  const Curve_options& options_;
  const Skeleton_graph& graph_;
  std::vector<std::vector<std::size_t>> adjacency_;
  const std::vector<std::vector<Vector3>>& surface_;
  std::vector<double> extent_; ///< Greatest distance of the surface points of each vertex.
  std::vector<std::size_t> component_; ///< Of each vertex.
  std::vector<double> points_;         ///< At each component: the number of its surface points.
};

/// Part 3d: adds plausible bridges between components, the shorter first, see `Bridging`.
/// `surface[v]` are the surface points of vertex v. O(n log n), times the vertices within reach.
inline void bridge_gaps(Skeleton_graph& graph, const std::vector<std::vector<Vector3>>& surface,
                        const Curve_options& options)
{
  add_forest(graph, Bridging(graph, surface, options).bridges());
}

/// Part 3d: adds the shortest bridges that connect all components. O(n^2 log n).
inline void join_all(Skeleton_graph& graph)
{
  Union_find components = components_of(graph);
  const std::size_t n = graph.vertices.size();
  std::vector<Bridge> bridges =
    minimum_spanning_forest<Bridge>(components, n, [&](const auto& visit) {
      for(std::size_t v = 0; v < n; ++v)
        for(std::size_t w = v + 1; w < n; ++w)
          if(components.find(v) != components.find(w))
            visit(bridge(v, w, graph));
    });
  add_forest(graph, std::move(bridges));
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_BRIDGE_GAPS_H
