// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "lapcon08_vc.h"

#include "add_curve.h"
#include "cluster_skeleton.h"
#include "mesh_contraction.h"

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace {

using methods::Cluster;
using methods::Neighbors;
using methods::Positions;

constexpr double cluster_radius = 0.02; // diagonals

Neighbors neighbors_of(const std::vector<methods::Fan>& fans)
{
  Neighbors neighbors(fans.size());
  for(std::size_t i = 0; i < fans.size(); ++i)
    for(const auto& edge : fans[i])
      neighbors[i].push_back(edge[0]); // the surface is closed: every neighbour is first once
  return neighbors;
}

Eigen::Vector3d row(const Positions& points, std::size_t i)
{
  return points.row(static_cast<Eigen::Index>(i));
}

/// The lengths of the shortest ways along the edges to the nearest of some seeds, and which it is.
struct Nearest_seed
{
  std::vector<double> distance;
  std::vector<std::size_t> seed;

  /// Gives to a new seed what it is nearer to: Dijkstra's algorithm.
  void add(std::size_t vertex, std::size_t number, const Positions& points,
           const Neighbors& neighbors)
  {
    using Entry = std::pair<double, std::size_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    for(queue.emplace(0, vertex); !queue.empty();) {
      const auto [length, i] = queue.top();
      queue.pop();
      if(length >= distance[i])
        continue;
      distance[i] = length;
      seed[i] = number;
      for(const std::size_t j : neighbors[i])
        queue.emplace(length + (row(points, i) - row(points, j)).norm(), j);
    }
  }
};

methods::Cluster_graph graph_of(const Positions& points, const Neighbors& neighbors, double radius)
{
  Nearest_seed nearest{
      std::vector<double>(neighbors.size(), std::numeric_limits<double>::infinity()),
      std::vector<std::size_t>(neighbors.size())};
  std::vector<Cluster> clusters;
  for(auto farthest = nearest.distance.begin(); *farthest > radius;
      farthest = std::max_element(nearest.distance.begin(), nearest.distance.end())) {
    const auto seed = static_cast<std::size_t>(farthest - nearest.distance.begin());
    nearest.add(seed, clusters.size(), points, neighbors);
    clusters.push_back({row(points, seed), 0, {}});
  }
  return {std::move(clusters), nearest.seed, neighbors};
}

Eigen::Vector3d mean_of(const std::vector<std::size_t>& chosen, const Positions& points)
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for(const std::size_t i : chosen)
    sum += row(points, i);
  return sum / static_cast<double>(chosen.size());
}

void add_component(Skeleton& skeleton, const Mesh& mesh, const Positions& contracted)
{
  const Positions points = methods::positions_of(mesh);
  const double diagonal = (points.colwise().maxCoeff() - points.colwise().minCoeff()).norm();
  methods::Cluster_graph graph =
      graph_of(contracted, neighbors_of(methods::fans_of(mesh)), cluster_radius * diagonal);
  graph.collapse_triangles();
  std::vector<Point> centres;
  std::vector<std::size_t> position(graph.clusters().size());
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  for(std::size_t c = 0; c < graph.clusters().size(); ++c) {
    if(graph.clusters()[c].points.empty())
      continue;
    const Eigen::Vector3d centre = mean_of(graph.clusters()[c].points, contracted);
    position[c] = centres.size();
    centres.emplace_back(centre.x(), centre.y(), centre.z());
    for(const std::size_t d : graph.adjacent(c))
      if(d < c)
        edges.emplace_back(position[d], position[c]);
  }
  add_curve(skeleton, centres, edges);
}

} // namespace

Method_result lapcon08_vc(const Method_input& input)
{
  return methods::contract_and_add(input, "clustering", add_component);
}
