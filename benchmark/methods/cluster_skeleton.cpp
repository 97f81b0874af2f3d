// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cluster_skeleton.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <utility>

namespace methods {

void spread(std::vector<std::size_t>& owner, const Neighbors& neighbors)
{
  std::queue<std::size_t> queue;
  for(std::size_t i = 0; i < owner.size(); ++i)
    if(owner[i] != no_cluster)
      queue.push(i);
  for(; !queue.empty(); queue.pop())
    for(const std::size_t j : neighbors[queue.front()])
      if(owner[j] == no_cluster) {
        owner[j] = owner[queue.front()];
        queue.push(j);
      }
}

Cluster_graph::Cluster_graph(std::vector<Cluster> clusters, const std::vector<std::size_t>& owner,
                             const Neighbors& neighbors)
    : clusters_(std::move(clusters))
    , adjacent_(clusters_.size())
{
  for(std::size_t i = 0; i < owner.size(); ++i) {
    if(owner[i] == no_cluster)
      continue;
    clusters_[owner[i]].points.push_back(i);
    for(const std::size_t j : neighbors[i])
      if(owner[j] != no_cluster && owner[i] != owner[j]) {
        adjacent_[owner[i]].insert(owner[j]);
        adjacent_[owner[j]].insert(owner[i]);
      }
  }
}

bool Cluster_graph::in_triangle(std::size_t a, std::size_t b) const
{
  const std::size_t few = adjacent_[a].size() < adjacent_[b].size() ? a : b;
  const std::set<std::size_t>& others = adjacent_[few == a ? b : a];
  return std::any_of(adjacent_[few].begin(), adjacent_[few].end(),
                     [&](std::size_t c) { return others.count(c) != 0; });
}

Cluster_graph::Edge Cluster_graph::edge(std::size_t a, std::size_t b) const
{
  return {(clusters_[a].center - clusters_[b].center).squaredNorm(), std::min(a, b),
          std::max(a, b)};
}

void Cluster_graph::collapse(std::size_t kept, std::size_t gone)
{
  Cluster& cluster = clusters_[kept];
  cluster.center = (cluster.center + clusters_[gone].center) / 2;
  cluster.radius = (cluster.radius + clusters_[gone].radius) / 2;
  cluster.points.insert(cluster.points.end(), clusters_[gone].points.begin(),
                        clusters_[gone].points.end());
  clusters_[gone].points.clear();
  for(const std::size_t c : std::exchange(adjacent_[gone], {})) {
    adjacent_[c].erase(gone);
    if(c != kept) {
      adjacent_[c].insert(kept);
      adjacent_[kept].insert(c);
    }
  }
}

void Cluster_graph::collapse_triangles()
{
  std::priority_queue<Edge, std::vector<Edge>, std::greater<Edge>> queue;
  for(std::size_t a = 0; a < clusters_.size(); ++a)
    for(const std::size_t b : adjacent_[a])
      if(a < b)
        queue.push(edge(a, b));
  while(!queue.empty()) {
    const Edge shortest = queue.top();
    queue.pop();
    const std::size_t a = std::get<1>(shortest), b = std::get<2>(shortest);
    if(adjacent_[a].count(b) == 0 || shortest != edge(a, b) || !in_triangle(a, b))
      continue;
    collapse(a, b);
    // What has moved, and what may have become part of a triangle.
    for(const std::size_t c : adjacent_[a]) {
      queue.push(edge(a, c));
      for(const std::size_t d : adjacent_[c])
        if(c < d && adjacent_[a].count(d) != 0)
          queue.push(edge(c, d));
    }
  }
}

// By Dijkstra's algorithm.
bool Cluster_graph::has_path(std::size_t from, std::size_t to, double max_length) const
{
  using Visit = std::pair<double, std::size_t>;
  std::priority_queue<Visit, std::vector<Visit>, std::greater<Visit>> queue;
  std::set<std::size_t> done;
  queue.emplace(0., from);
  while(!queue.empty()) {
    const Visit visit = queue.top();
    queue.pop();
    if(visit.second == to)
      return true;
    if(!done.insert(visit.second).second)
      continue;
    for(const std::size_t next : adjacent_[visit.second]) {
      const double length =
          visit.first + (clusters_[next].center - clusters_[visit.second].center).norm();
      if(length <= max_length)
        queue.emplace(length, next);
    }
  }
  return false;
}

void Cluster_graph::keep_spanner(double stretch)
{
  std::vector<Edge> edges;
  for(std::size_t a = 0; a < clusters_.size(); ++a)
    for(const std::size_t b : std::exchange(adjacent_[a], {}))
      if(a < b)
        edges.push_back(edge(a, b));
  std::sort(edges.begin(), edges.end());
  for(const auto& [squared_length, a, b] : edges)
    if(!has_path(a, b, stretch * std::sqrt(squared_length))) {
      adjacent_[a].insert(b);
      adjacent_[b].insert(a);
    }
}

Skeleton Cluster_graph::skeleton() const
{
  Skeleton result;
  std::vector<Skeleton::vertex_descriptor> vertex(clusters_.size());
  for(std::size_t c = 0; c < clusters_.size(); ++c) {
    if(clusters_[c].points.empty())
      continue;
    vertex[c] = add_vertex(result);
    auto& bundle = result[vertex[c]];
    bundle.point = Point(clusters_[c].center.x(), clusters_[c].center.y(), clusters_[c].center.z());
    bundle.radius = clusters_[c].radius;
    bundle.indices.assign(clusters_[c].points.begin(), clusters_[c].points.end());
    std::sort(bundle.indices.begin(), bundle.indices.end());
    for(const std::size_t b : adjacent_[c])
      if(b < c)
        add_edge(vertex[b], vertex[c], result);
  }
  return result;
}

} // namespace methods
