// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_MEASURED_COMPONENTS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_MEASURED_COMPONENTS_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Union_find.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Bridge.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Curve_evidence.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Skeleton_graph.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// A connected component of a skeleton graph.
struct Component
{
  Curve_evidence curve;
  double points = 0; ///< Number of points.
};

/// The components of a graph, each known by a vertex.
class Measured_components
{
public:
  /// \param points number of points of each vertex. O(n)
  Measured_components(const Skeleton_graph& graph, const std::vector<double>& points)
    : measures_(graph.vertices.size())
  {
    Union_find sets = components_of(graph);
    for(std::size_t v = 0; v < measures_.size(); ++v) {
      representative_.push_back(sets.find(v));
      measures_[representative_[v]].points += points[v];
    }
    for(const Skeleton_graph::Edge& e : graph.edges)
      measures_[representative_[e.first]].curve.add(graph.vertices[e.first],
                                                    graph.vertices[e.second]);
    const auto has_fewer = [](const Component& a, const Component& b) {
      return a.points < b.points;
    };
    largest_ = static_cast<std::size_t>(
      std::max_element(measures_.begin(), measures_.end(), has_fewer) - measures_.begin());
  }

  /// The component of a vertex.
  const Component& of(std::size_t v) const { return measures_[representative_[v]]; }

  /// The vertex that stands for the component of a vertex.
  std::size_t representative(std::size_t v) const { return representative_[v]; }

  /// The component with the most points. \pre there is a vertex
  const Component& largest() const { return measures_[largest_]; }

  /// Whether two vertices are connected.
  bool are_connected(std::size_t v, std::size_t w) const
  {
    return representative_[v] == representative_[w];
  }

private:
  std::vector<std::size_t> representative_; ///< Of each vertex.
  std::vector<Component> measures_;         ///< At each representative.
  std::size_t largest_ = 0;                 ///< Its representative.
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_MEASURED_COMPONENTS_H
