// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_AXIS_GRAPH_H
#define POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_AXIS_GRAPH_H

#include "Known_shape.h"
#include "drawing.h"

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

/// The axis of a shape as a graph, to check what the shape says about itself.
namespace shapes {

/// A place where pieces of the axis meet.
struct Node
{
  Vector position;
  double radius; ///< The largest of the pieces that meet here.
};

using Length = boost::property<boost::edge_weight_t, double>;
using Axis_graph =
    boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, Node, Length>;

inline std::size_t node_at(Axis_graph& graph, const Vector& position, double radius)
{
  for(std::size_t v = 0; v < num_vertices(graph); ++v)
    if((graph[v].position - position).norm() < 1e-9) {
      graph[v].radius = std::max(graph[v].radius, radius);
      return v;
    }
  return add_vertex({position, radius}, graph);
}

inline Axis_graph axis_graph(const Known_shape& shape)
{
  Axis_graph graph;
  for(const Axis_segment& s : shape.axis) {
    const std::size_t a = node_at(graph, s.a, s.radius_a), b = node_at(graph, s.b, s.radius_b);
    add_edge(a, b, (s.b - s.a).norm(), graph);
  }
  return graph;
}

/// The same axis in pieces no longer than the thinnest limb's radius.
inline Known_shape with_short_segments(const Known_shape& shape)
{
  const double longest = least_radius(shape);
  Known_shape result;
  for(const Axis_segment& s : shape.axis) {
    const int pieces = static_cast<int>(std::ceil((s.b - s.a).norm() / longest));
    const auto bead = [&](int i) {
      const double t = static_cast<double>(i) / pieces;
      return Bead{s.a + t * (s.b - s.a), s.radius_a + t * (s.radius_b - s.radius_a)};
    };
    for(int i = 0; i < pieces; ++i)
      add_axis(result, {bead(i), bead(i + 1)});
  }
  return result;
}

/// Lengths of the shortest walks along the axis to all nodes.
inline std::vector<double> walks_from(const Axis_graph& graph, std::size_t node)
{
  std::vector<double> lengths(num_vertices(graph));
  boost::dijkstra_shortest_paths(graph, node, boost::distance_map(lengths.data()));
  return lengths;
}

/// The least distance between the surfaces of limbs that do not meet, in radii of the thinner.
inline double narrowest_gap(const Known_shape& shape)
{
  const Axis_graph graph = axis_graph(with_short_segments(shape));
  double narrowest = std::numeric_limits<double>::infinity();
  for(std::size_t v = 0; v < num_vertices(graph); ++v) {
    const std::vector<double> walks = walks_from(graph, v);
    for(std::size_t w = 0; w < v; ++w) {
      const double sum = graph[v].radius + graph[w].radius;
      const double gap = (graph[v].position - graph[w].position).norm() - sum;
      if(walks[w] > 5 * sum) // farther than across a fork, even a sharp one
        narrowest = std::min(narrowest, gap / std::min(graph[v].radius, graph[w].radius));
    }
  }
  return narrowest;
}

} // namespace shapes

#endif // POINT_SET_SKELETONIZATION_3_TEST_GENERATOR_AXIS_GRAPH_H
