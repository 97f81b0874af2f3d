// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "teasar.h"

#include "add_curve.h"

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
using Vertex = Mesh::Vertex_index;

/// The girth of a tube says how far its other side is; limbs are not round, nor all alike.
constexpr double share_of_girth = 0.75;

/// Every vertex at the mean of its neighbours, and once more: without most of the noise.
Mesh smoothed(Mesh mesh)
{
  constexpr int rounds = 2;
  for(int round = 0; round < rounds; ++round) {
    const Mesh before = mesh;
    for(const Vertex v : mesh.vertices()) {
      Vector sum = CGAL::NULL_VECTOR;
      for(const Vertex w : CGAL::vertices_around_target(before.halfedge(v), before))
        sum += before.point(w) - CGAL::ORIGIN;
      mesh.point(v) = CGAL::ORIGIN + sum / static_cast<double>(before.degree(v));
    }
  }
  return mesh;
}

double length_of_edges(const Mesh& mesh)
{
  double sum = 0;
  for(const auto e : mesh.edges())
    sum += PMP::edge_length(mesh.halfedge(e), mesh);
  return sum;
}

/// Of a tube of radius r, the volume is r / 2 times the area. Noise adds to the area, and makes the
/// ways longer by as much as the edges.
double invalidation_distance(const Mesh& mesh)
{
  const Mesh smooth = smoothed(mesh);
  const double radius = 2 * std::abs(PMP::volume(smooth)) / PMP::area(smooth);
  return share_of_girth * 2 * CGAL_PI * radius * length_of_edges(mesh) / length_of_edges(smooth);
}

/// The shortest ways along the edges from every vertex to the nearest of some.
struct Ways
{
  std::vector<double> length;
  std::vector<Vertex> next; ///< itself, if there

  explicit Ways(const Mesh& mesh)
      : length(mesh.number_of_vertices(), std::numeric_limits<double>::infinity())
      , next(mesh.number_of_vertices())
  {}

  /// More to go to: Dijkstra's algorithm, as far as they are nearer than those before.
  void add_goals(const std::vector<Vertex>& goals, const Mesh& mesh)
  {
    using Entry = std::tuple<double, Vertex, Vertex>; // length, from, next
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    for(const Vertex goal : goals)
      queue.emplace(0, goal, goal);
    while(!queue.empty()) {
      const auto [way, v, to] = queue.top();
      queue.pop();
      if(way >= length[v])
        continue;
      length[v] = way;
      next[v] = to;
      for(const auto h : CGAL::halfedges_around_target(mesh.halfedge(v), mesh))
        queue.emplace(way + PMP::edge_length(h, mesh), mesh.source(h), v);
    }
  }
};

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

  /// Adds the way from `tip`, which is not in the tree, to it; the branch becomes a goal of ways.
  void add_branch(Vertex tip, Ways& ways, const Mesh& mesh)
  {
    std::vector<Vertex> branch;
    for(Vertex v = tip; ways.next[v] != v; v = ways.next[v]) {
      branch.push_back(v);
      edges_.emplace_back(v, ways.next[v]);
    }
    vertices_.insert(vertices_.end(), branch.begin(), branch.end());
    ways.add_goals(branch, mesh);
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
  Ways from_any(mesh);
  from_any.add_goals({*mesh.vertices_begin()}, mesh);
  const Vertex root = farthest(from_any.length);
  const double reach = invalidation_distance(mesh);
  Tree tree(root);
  Ways ways(mesh);
  ways.add_goals({root}, mesh);
  std::vector<double> from_root = ways.length; // 0 once a branch is near
  for(Vertex tip = farthest(from_root); from_root[tip] > 0; tip = farthest(from_root)) {
    tree.add_branch(tip, ways, mesh);
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
