// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial

#include "teasar.h"

#include "add_curve.h"

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/number_type_config.h>

#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
using Vertex = Mesh::Vertex_index;

/// The girth of a tube says how far its other side is; limbs are not round, nor all alike.
constexpr double share_of_girth = 0.75;

/// Of a tube of radius r, the volume is r / 2 times the area.
double invalidation_distance(const Mesh& mesh)
{
  const double radius = 2 * CGAL::to_double(PMP::volume(mesh) / PMP::area(mesh));
  return share_of_girth * 2 * CGAL_PI * std::abs(radius);
}

/// Shortest ways from every vertex to the nearest of some.
struct Ways
{
  std::vector<double> length;
  std::vector<Vertex> next; ///< itself, if there
};

Ways ways_to(const std::vector<Vertex>& goals, const Mesh& mesh)
{
  const auto index = get(boost::vertex_index, mesh);
  Ways ways;
  ways.length.resize(mesh.number_of_vertices());
  ways.next.resize(mesh.number_of_vertices());
  boost::dijkstra_shortest_paths(
      mesh, goals.data(), goals.data() + goals.size(),
      boost::make_iterator_property_map(ways.next.begin(), index),
      boost::make_iterator_property_map(ways.length.begin(), index), get(boost::edge_weight, mesh),
      index, std::less<double>(), boost::closed_plus<double>(),
      std::numeric_limits<double>::infinity(), 0.0, boost::default_dijkstra_visitor());
  return ways;
}

/// Where the length is greatest.
Vertex farthest(const std::vector<double>& length)
{
  const auto greatest = std::max_element(length.begin(), length.end());
  return Vertex(static_cast<Mesh::size_type>(greatest - length.begin()));
}

/// The vertices of a growing tree on a mesh, the root first.
class Tree
{
public:
  explicit Tree(Vertex root)
      : vertices_{root}
  {}

  const std::vector<Vertex>& vertices() const { return vertices_; }

  /// Adds the way from `tip`, which is not in the tree, to it.
  void add_branch(Vertex tip, const Ways& ways)
  {
    for(Vertex v = tip; ways.next[v] != v; v = ways.next[v]) {
      vertices_.push_back(v);
      edges_.emplace_back(v, ways.next[v]);
    }
  }

  void add_to(Skeleton& skeleton, const Mesh& mesh) const
  {
    std::vector<Point> points;
    std::vector<std::size_t> position(mesh.number_of_vertices());
    for(const Vertex v : vertices_) {
      position[v] = points.size();
      points.push_back(mesh.point(v));
    }
    std::vector<std::pair<std::size_t, std::size_t>> edges;
    for(const auto& [v, w] : edges_)
      edges.emplace_back(position[v], position[w]);
    add_curve(skeleton, points, edges);
  }

private:
  std::vector<Vertex> vertices_;
  std::vector<std::pair<Vertex, Vertex>> edges_;
};

Tree tree_of(const Mesh& mesh)
{
  const Vertex root = farthest(ways_to({*mesh.vertices_begin()}, mesh).length);
  const double reach = invalidation_distance(mesh);
  Tree tree(root);
  Ways ways = ways_to({root}, mesh);
  std::vector<double> from_root = ways.length; // 0 once a branch is near
  for(Vertex tip = farthest(from_root); from_root[tip] > 0; tip = farthest(from_root)) {
    tree.add_branch(tip, ways);
    ways = ways_to(tree.vertices(), mesh);
    for(const Vertex v : mesh.vertices())
      if(ways.length[v] <= reach)
        from_root[v] = 0;
  }
  return tree;
}

} // namespace

Method_result teasar(const Method_input& input)
{
  Method_result result;
  timed_stage(result, "paths", [&] {
    for(const Mesh& mesh : input.components)
      tree_of(mesh).add_to(result.skeleton, mesh);
  });
  return result;
}
